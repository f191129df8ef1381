// bask study: repeats a study of the paper and writes its table and figures.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/view_factor_study.h"

#include "widgets/plots/figure_png.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFile>

#include <cstdio>

namespace bask {
namespace {

/// In every file of a study, near its beginning: what holds it may be replaced.
constexpr const char* kMark = "Bask view-factor study";
constexpr int kLeastElements = 10, kMostElements = 20000;

int refuse(const Error& error) {
    std::fprintf(stderr, "bask study: %s\n", describe(error).c_str());
    return kExitBadInput;
}

int refuse(const QString& words) {
    std::fprintf(stderr, "bask study: %s (see bask study --help)\n", qPrintable(words));
    return kExitBadInput;
}

using Rows = std::vector<StudyRow>;

/// Points of the rows that `wanted` picks.
template <class Wanted, class Point>
FigureSeries seriesOf(const QString& name, const Rows& rows, const Wanted& wanted, const Point& point) {
    FigureSeries series{name, {}};
    for (const StudyRow& row : rows)
        if (wanted(row))
            series.points << point(row);
    return series;
}

Figure emptyFigure(const ViewFactorStudy& study, const char* title) {
    Figure figure;
    figure.title = QString::fromUtf8(title);
    figure.note =
        QString::fromUtf8("Bask's bunny over a disk of radius 10 cm, 5 cm apart, parallel: F₂₁ = %1. "
                          "The paper's 0.764602 is another bunny's.")
            .arg(study.exact, 0, 'f', 9);
    figure.yLabel = QStringLiteral("Absolute error of F₂₁");
    return figure;
}

Figure elementsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Surface integral: error against the number of elements");
    figure.xLabel = QStringLiteral("Elements on each face");
    figure.series = {seriesOf(
        QStringLiteral("surface integral"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SurfaceIntegral; },
        [](const StudyRow& row) { return QPointF(row.elements, row.error); })};
    // For the eye: how the error of a staircase of squares falls.
    const auto& points = figure.series[0].points;
    FigureSeries trend{QStringLiteral("slope −3/4"), {}};
    for (const QPointF& point : points)
        trend.points << QPointF(point.x(), 0.1 * std::pow(point.x() / 10.0, -0.75));
    trend.hasMarkers = false;
    figure.series << trend;
    return figure;
}

Figure harmonicsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Fourier method: error against the number of harmonics");
    figure.xLabel = QStringLiteral("Harmonics of the outline");
    figure.isXLogarithmic = false;
    for (int points : {8, 16, 32, 64})
        figure.series << seriesOf(
            QStringLiteral("Simpson, %1 points").arg(points), study.rows,
            [&](const StudyRow& row) { return row.method == StudyMethod::Fourier && row.points == points; },
            [](const StudyRow& row) { return QPointF(row.harmonics, row.error); });
    figure.series << seriesOf(
        QStringLiteral("truncation alone (Bask's solver)"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SolverFourier; },
        [](const StudyRow& row) { return QPointF(row.harmonics, row.error); });
    return figure;
}

Figure pointsFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "Fourier method: error of the quadrature against its points");
    figure.xLabel = QStringLiteral("Quadrature points on each contour");
    figure.xBase = 2;
    figure.yLabel = QStringLiteral("Absolute error against the same truncated outline");
    for (int harmonics : {1, 2, 5, 10, 20})
        figure.series << seriesOf(
            harmonics == 1 ? QStringLiteral("1 harmonic") : QStringLiteral("%1 harmonics").arg(harmonics),
            study.rows,
            [&](const StudyRow& row) {
                return row.method == StudyMethod::Fourier && row.harmonics == harmonics;
            },
            [](const StudyRow& row) { return QPointF(row.points, row.quadratureError.value_or(0.0)); });
    return figure;
}

Figure timeFigure(const ViewFactorStudy& study) {
    Figure figure = emptyFigure(study, "All methods: error against time");
    figure.xLabel = QStringLiteral("Time of one evaluation (µs)");
    figure.yLabel += QStringLiteral(" (10⁻¹²: that or less)");
    figure.smallest = 1e-12; // the reference is no better
    const auto at = [](const StudyRow& row) { return QPointF(row.time_us, row.error); };
    const auto of = [](StudyMethod method, int harmonics) {
        return [=](const StudyRow& row) { return row.method == method && row.harmonics == harmonics; };
    };
    figure.series << seriesOf(QStringLiteral("surface integral"), study.rows,
                              of(StudyMethod::SurfaceIntegral, 0), at);
    for (int harmonics : {5, 20})
        figure.series << seriesOf(QStringLiteral("Fourier method, %1 harmonics").arg(harmonics), study.rows,
                                  of(StudyMethod::Fourier, harmonics), at);
    figure.series << seriesOf(
        QStringLiteral("Bask with gradient, 1 to 20 harmonics"), study.rows,
        [](const StudyRow& row) { return row.method == StudyMethod::SolverFourier; }, at);
    figure.series.last().isJoined = false;
    figure.series << seriesOf(QStringLiteral("Bask with gradient, outline"), study.rows,
                              of(StudyMethod::SolverOutline, 0), at);
    return figure;
}

/// Makes the folder if it is not there. Returns what is wrong with it, in words.
QString makeFolder(const QString& folder) {
    const QFileInfo info(folder);
    if (info.exists() && !info.isDir())
        return QStringLiteral("%1 is a file, not a folder; choose another name").arg(folder);
    if (!QDir().mkpath(folder))
        return QStringLiteral("the folder %1 cannot be made; choose another place").arg(folder);
    return {};
}

/// Refuses to replace what is no part of a study.
Result<void> checkReplaced(const std::vector<OutputFile>& outputs) {
    for (const OutputFile& output : outputs) {
        QFile old(QString::fromStdString(output.path));
        if (old.exists() && old.size() > 0 &&
            (!old.open(QIODevice::ReadOnly) || !old.read(1024).contains(kMark)))
            return Error(MessageCode::OutputForeign, output.path, {"part of a study written by Bask"});
    }
    return {};
}

void printRow(const StudyRow& row) {
    std::string detail;
    if (row.elements > 0)
        detail = "n = " + std::to_string(row.elements);
    if (row.harmonics > 0)
        detail += "h = " + std::to_string(row.harmonics);
    if (row.points > 0)
        detail += ", " + std::to_string(row.points) + " points";
    if (row.tolerance > 0.0)
        detail += (detail.empty() ? "to " : ", to ") + formatNumber(row.tolerance, 1);
    std::printf("%-18s  %-18s  %.12f  %8.1e  %12.2f\n", studyMethodName(row.method), detail.c_str(),
                row.value, row.error, row.time_us);
}

/// The rows that tell the story: all would be over a hundred lines.
bool isInSummary(const StudyRow& row) {
    const bool isTypical = row.harmonics == 5 || row.harmonics == 10 || row.harmonics == 20;
    switch (row.method) {
    case StudyMethod::SurfaceIntegral:
        return row.elements == 20 || row.elements == 200 || row.elements == 2000 || row.elements == 20000;
    case StudyMethod::Fourier:
        return isTypical && (row.points == 32 || row.points == 128);
    case StudyMethod::SolverFourier:
        return isTypical;
    case StudyMethod::SolverOutline:
        return true;
    }
    return false;
}

void printSummary(const ViewFactorStudy& study) {
    std::printf("%-18s  %-18s  %-14s  %8s  %12s\n", "method", "", "view factor", "error", "time (us)");
    for (const StudyRow& row : study.rows)
        if (isInSummary(row))
            printRow(row);
    std::printf("exact %.12f; the paper's 0.764602 belongs to another bunny: compare trends, not values\n",
                study.exact);
}

Result<void> writeStudy(const ViewFactorStudy& study, const std::vector<OutputFile>& outputs) {
    if (auto written = writeOutput(outputs[0].path, studyCsv(study)); !written)
        return written;
    const Figure figures[] = {elementsFigure(study), harmonicsFigure(study), pointsFigure(study),
                              timeFigure(study)};
    for (std::size_t i = 0; i < std::size(figures); ++i) {
        const QByteArray png = figurePng(figures[i], QString::fromLatin1(kMark));
        if (auto written = writeOutput(outputs[i + 1].path, png.toStdString()); !written)
            return written;
    }
    return {};
}

} // namespace

int studyCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Repeats the study of the paper's Appendix B on Bask's bunny over a disk at 5 cm: the surface\n"
        "integral with n elements, the Fourier method with h harmonics and Bask's own solver, each with\n"
        "value, error and time. Writes view_factor_study.csv and four figures, and prints a summary.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption({{"o", "output"}, "Folder for the files; made if it is not there. Required.", "DIR"});
    parser.addOption(
        {"elements", "Most elements on each face of the surface integral, 10 to 20000.", "N", "20000"});
    parser.addPositionalArgument("view-factor", "The study; there is this one.");
    if (const auto code = parseCommand(parser, "study", arguments, 1))
        return *code;
    if (parser.positionalArguments().front() != QLatin1String("view-factor"))
        return refuse(QStringLiteral("there is no study \"%1\"; known: view-factor")
                          .arg(parser.positionalArguments().front()));
    if (parser.value("output").isEmpty())
        return refuse(QStringLiteral("-o DIR is needed"));
    bool isNumber = false;
    const int elements = parser.value("elements").toInt(&isNumber);
    if (!isNumber || elements < kLeastElements || elements > kMostElements)
        return refuse(QStringLiteral("--elements %1 is not a whole number from %2 to %3")
                          .arg(parser.value("elements"))
                          .arg(kLeastElements)
                          .arg(kMostElements));
    if (const QString wrong = makeFolder(parser.value("output")); !wrong.isEmpty())
        return refuse(wrong);
    std::vector<OutputFile> outputs;
    for (const char* name : {".csv", "_elements.png", "_harmonics.png", "_points.png", "_time.png"})
        outputs.push_back({QDir(parser.value("output"))
                               .filePath(QStringLiteral("view_factor_study%1").arg(QLatin1String(name)))
                               .toStdString()});
    if (const auto place = checkOutputs({}, outputs); !place)
        return refuse(place.error());
    if (const auto place = checkReplaced(outputs); !place)
        return refuse(place.error());
    const auto study = runViewFactorStudy(elements);
    if (!study)
        return refuse(study.error());
    if (const auto written = writeStudy(*study, outputs); !written)
        return refuse(written.error());
    printSummary(*study);
    for (const OutputFile& output : outputs)
        std::fprintf(stderr, "wrote %s\n", output.path.c_str());
    return kExitDone;
}

} // namespace bask
