// bask study closed-loop: runs the study on the rig of the three-object examples, its table and figures.

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/drawing/studies.h"
#include "app/studies/study_work.h"
#include "engine/studies/row_bytes.h"
#include "widgets/plots/figure_png.h"

#include <algorithm>
#include <cstdio>

namespace bask {
namespace {

using ClosedLoopRows = std::vector<ClosedLoopRow>;

QString noteOf(const ClosedLoopStudy& study, const ClosedLoopRequest& request) {
    static constexpr const char* kMountings[] = {"triangle", "line", "random mountings",
                                                 "random heights and tilts"};
    QString conditions;
    if (request.convection_W_m2K > 0.0)
        conditions += QString::fromUtf8(", h to %1 W/(m²K)").arg(request.convection_W_m2K);
    if (request.sensorLag_s > 0.0)
        conditions += QStringLiteral(", lag to %1 s").arg(request.sensorLag_s);
    if (request.robotLatency_s > 0.0)
        conditions += QStringLiteral(", latency to %1 s").arg(request.robotLatency_s);
    if (request.uneven > 0.0)
        conditions += QString::fromUtf8(", source uneven to %1 %").arg(100.0 * request.uneven);
    return QString::fromUtf8("%1 runs, seed %2: %3, rates wrong within ×%4, source model %5, %6%7")
        .arg(study.count)
        .arg(study.seed)
        .arg(QLatin1String(request.controller.key()))
        .arg(request.rateError)
        .arg(request.sourceModel == SourceModel::Gray ? QStringLiteral("gray") : QStringLiteral("paper"))
        .arg(QLatin1String(kMountings[static_cast<int>(request.mounting)]), conditions);
}

Figure settlingFigure(const ClosedLoopRows& rows, const QString& note) {
    Figure figure;
    figure.title = QStringLiteral("Settling time against the least that physics allows");
    figure.note = note;
    figure.xLabel = QStringLiteral("Bound of the slowest object (s)");
    figure.yLabel = QStringLiteral("Settling time (s)");
    FigureSeries settled{QStringLiteral("settled"), {}, false};
    FigureSeries failed{QStringLiteral("not settled, at the run's length"), {}, false};
    std::vector<double> bounds_s;
    for (const ClosedLoopRow& row : rows) {
        (row.settling_s ? settled : failed).points
            << QPointF(row.drawn.bound_s, std::max(row.settling_s.value_or(row.drawn.duration_s()), 1.0));
        bounds_s.push_back(row.drawn.bound_s);
    }
    std::ranges::sort(bounds_s);
    FigureSeries bound{QStringLiteral("the bound"), {}};
    for (const double bound_s : bounds_s)
        bound.points << QPointF(bound_s, bound_s);
    bound.hasMarkers = false;
    figure.isXLogarithmic = false;
    figure.smallest = 1.0;
    figure.series << settled << failed << bound;
    return figure;
}

/// Runs in the order of their ratio, failures left out at the right end.
Figure ratioFigure(const ClosedLoopRows& rows, const QString& note) {
    Figure figure;
    figure.title = QStringLiteral("Settling time over the bound, best run first");
    figure.note = note;
    figure.xLabel = QStringLiteral("Runs (%), failures missing at the right");
    figure.yLabel = QStringLiteral("Settling time over the bound");
    figure.isXLogarithmic = false;
    figure.smallest = 0.1;
    const auto sorted = [&](const QString& name, double ClosedLoopCase::*bound_s) {
        std::vector<double> ratios;
        for (const ClosedLoopRow& row : rows)
            if (row.settling_s)
                ratios.push_back(*row.settling_s / row.drawn.*bound_s);
        std::ranges::sort(ratios);
        FigureSeries series{name, {}};
        for (std::size_t k = 0; k < ratios.size(); ++k)
            series.points << QPointF(100.0 * static_cast<double>(k + 1) / static_cast<double>(rows.size()),
                                     ratios[k]);
        return series;
    };
    figure.series << sorted(QStringLiteral("bound with travel"), &ClosedLoopCase::bound_s)
                  << sorted(QStringLiteral("bound without travel"), &ClosedLoopCase::radiation_s)
                  << FigureSeries{QStringLiteral("the bound"), {{0.0, 1.0}, {100.0, 1.0}}, true, false};
    return figure;
}

Figure overshootFigure(const ClosedLoopRows& rows, const QString& note) {
    Figure figure;
    figure.title = QStringLiteral("Overshoot of the true temperatures");
    figure.note = note;
    figure.xLabel = QStringLiteral("Bound of the slowest object (s)");
    figure.yLabel = QString::fromUtf8("Farthest past a target (K; 10⁻²: that or less)");
    figure.isXLogarithmic = false;
    figure.smallest = 0.01;
    FigureSeries settled{QStringLiteral("settled"), {}, false};
    FigureSeries failed{QStringLiteral("not settled"), {}, false};
    for (const ClosedLoopRow& row : rows)
        (row.settling_s ? settled : failed).points << QPointF(row.drawn.bound_s, row.overshoot_K);
    figure.series << settled << failed;
    return figure;
}

void printSummary(const ClosedLoopRows& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k)
        if (!rows[k].failure.empty())
            std::printf("run %zu failed: %s\n", k + 1, rows[k].failure.c_str());
    const ClosedLoopSummary summary = summarize(rows);
    const auto shown = [](const std::optional<double>& value, double factor, const char* unit) {
        char text[32] = "none";
        if (value)
            std::snprintf(text, sizeof text, "%.2f%s", factor * *value, unit);
        return std::string(text);
    };
    const auto ratio = [&](const std::optional<double>& value) { return shown(value, 1.0, ""); };
    std::printf("median way: %s\n", shown(summary.medianWay_m, 1.0, " m").c_str());
    std::printf("mean speed at rest: %s, worst run %s\n",
                shown(summary.meanRestSpeed_m_s, 1000.0, " mm/s").c_str(),
                shown(summary.worstRestSpeed_m_s, 1000.0, " mm/s").c_str());
    std::printf("90th percentile of settling over bound: %s\n", ratio(summary.tenthOverBound).c_str());
    std::printf("median settling over bound without travel: %s\n",
                ratio(summary.medianOverRadiation).c_str());
    std::printf("success rate: %.1f %%\n", 100.0 * summary.successRate);
    std::printf("median settling over bound: %s\n", ratio(summary.medianOverBound).c_str());
    std::printf("worst overshoot: %.2f K\n", summary.worstOvershoot_K);
}

Result<ClosedLoopRows> rowsOf(const ClosedLoopStudy& study, const StudyWay& way) {
    if (way.merged == nullptr) {
        Progress progress(study.count, "runs");
        return runClosedLoopStudy(study, way.threads, [&](int done) { progress.tell(done); });
    }
    return mergedRows<ClosedLoopRow>(*way.merged, study.count, [&](const std::string& bytes) {
        return closedLoopRowOf(bytes, study.rig.objects.size());
    });
}

} // namespace

int closedLoopStudyCommand(const ClosedLoopRequest& request, const QString& folder, const StudyWay& way) {
    const StudyNames names = namesOf(request);
    const auto files = studyFiles(way.command(), folder, names);
    if (!files)
        return kExitBadInput;
    const auto study = studyOf(request);
    if (!study)
        return refuse(way.command(), study.error());
    const auto rows = rowsOf(*study, way);
    if (!rows)
        return refuse(way.command(), rows.error());
    const QString note = noteOf(*study, request);
    std::vector<std::string> contents{closedLoopCsv(*study, *rows)};
    for (const Figure& figure :
         {settlingFigure(*rows, note), ratioFigure(*rows, note), overshootFigure(*rows, note)})
        contents.push_back(figurePng(figure, QString::fromLatin1(names.mark)).toStdString());
    if (const auto written = writeFiles(*files, contents); !written)
        return refuse(way.command(), written.error());
    printSummary(*rows);
    return kExitDone;
}

} // namespace bask
