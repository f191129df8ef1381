#include "app/report/report_figures.h"

#include "engine/base/message_code.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/display.h"
#include "widgets/plots/figure_paths.h"
#include "widgets/plots/figure_traces.h"
#include "widgets/plots/quantity_words.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace bask {
namespace {

struct FigureText {
    Q_DECLARE_TR_FUNCTIONS(bask::RunReport)
};

constexpr double kLabelRoom = 0.022;                        // of the time axis
constexpr std::size_t kMaxPathPoints = 4000;                // of an object in the figure of trajectories
constexpr double kViewAspect = 0.32, kAboutViews_mm = 26.0; // of that figure

int pixels(double mm) {
    return qRound(mm / 25.4 * kFigureDots);
}

bool isMarked(MessageCode code) {
    switch (code) {
    case MessageCode::EventHeld:
    case MessageCode::EventHeldFor:
    case MessageCode::EventResumed:
    case MessageCode::EventSettled:
    case MessageCode::EventStopped:
    case MessageCode::EventStoppedFor:
    case MessageCode::EventEmergencyStop:
    case MessageCode::EventTargetsChanged:
    case MessageCode::EventGainsChanged:
        return true;
    default:
        return alarmPriority(code) > 0;
    }
}

/// Of all readings, at least that of the band.
double greatestError_K(const SessionRecord& session) {
    double greatest_K = kSettledBand_K;
    for (const TraceSample& sample : session.samples)
        for (std::size_t i = 0; i < sample.objects.size(); ++i)
            greatest_K = std::fmax(greatest_K, std::abs(plottedValue(sample, Quantity::Error, i)));
    return greatest_K;
}

double temperature_K(const ObjectSample& object) {
    return std::isfinite(object.estimated_K) ? object.estimated_K : object.measured_K;
}

} // namespace

std::vector<int> markedEvents(const std::vector<TraceEvent>& events) {
    std::vector<int> numbers;
    int count = 0;
    for (const TraceEvent& event : events)
        numbers.push_back(count < kMaxMarked && isMarked(event.message.code) ? ++count : 0);
    return numbers;
}

std::vector<RunFigure> runFigures(const SessionRecord& session) {
    std::vector<RunFigure> figures{Quantity::Temperature, Quantity::Error, Quantity::Speed};
    for (const Quantity quantity : furtherQuantities())
        if (quantity != Quantity::Error && !quantityCaption(quantity).isEmpty() &&
            (quantity != Quantity::Shade || mayShade(session.experiment)))
            figures.emplace_back(quantity);
    figures.emplace_back(std::nullopt);
    return figures;
}

std::string runFigureStem(RunFigure figure) {
    if (!figure)
        return "trajectory";
    if (*figure == Quantity::Speed)
        return "speed";
    const ObjectColumn* const column = plottedColumn(*figure);
    std::string stem = column != nullptr ? column->title : plottedRunColumn(*figure)->title;
    std::ranges::transform(stem, stem.begin(), [](unsigned char c) {
        return c == ' ' ? '_' : static_cast<char>(std::tolower(c));
    });
    return stem;
}

QString runFigureCaption(RunFigure figure, const SessionRecord& session, TemperatureUnit unit) {
    const auto plusMinus = [&](double difference_K, int decimals) {
        return QStringLiteral("\u00b1") + formatDifference(difference_K, unit, decimals).mid(1);
    };
    if (!figure)
        return FigureText::tr(
            "Trajectories of the objects' centres over the source until Stop, from the ring to the dot, "
            "coloured by temperature; black: the source.");
    switch (*figure) {
    case Quantity::Temperature:
        return quantityCaption(*figure).arg(plusMinus(kSettledBand_K, 1));
    case Quantity::Error:
        return quantityCaption(*figure).arg(plusMinus(greatestError_K(session), 1));
    case Quantity::Speed:
        return FigureText::tr(
                   "Commanded speed of the end-effector as a share of its limits: %1 mm/s and %2 \u00b0/s.")
            .arg(QLocale().toString(1e3 * session.experiment.robot.maxSpeed_m_s, 'g', 3),
                 QLocale().toString(degFromRad(session.experiment.robot.maxRotation_rad_s), 'g', 3));
    default:
        return quantityCaption(*figure);
    }
}

struct RunFigures::Impl {
    const SessionRecord& session;
    TemperatureUnit unit;
    FigureLayout layout;
    TraceStore store;
    QStringList names;
    QList<FigureMoment> moments;
    QString note, namesOfMoments;
    QString corner;

    QByteArray traces(const QString& title, Quantity quantity, FigureFormat format) const {
        TraceFigure figure;
        figure.layout = layout;
        figure.title = title;
        figure.note = namesOfMoments.isEmpty() ? note : note + QStringLiteral(" \u00b7 ") + namesOfMoments;
        figure.corner = corner;
        figure.quantity = quantity;
        figure.names = names;
        figure.unit = unit;
        figure.limits = {session.experiment.robot.maxSpeed_m_s, session.experiment.robot.maxRotation_rad_s};
        figure.moments = moments;
        figure.aspect = quantity == Quantity::Temperature ? 0.26 : 0.2;
        return traceFigure(figure, store, format, kRunFigureMark);
    }

    FigurePath path(const std::vector<TraceSample>& samples, std::size_t i) const {
        const Pose X_EO = poseFromCoordinates(session.experiment.objects[i].mounting);
        FigurePath path{names.value(static_cast<qsizetype>(i)), {}};
        const std::size_t step = std::max<std::size_t>(1, samples.size() / kMaxPathPoints);
        for (std::size_t k = 0; k < samples.size(); k += step) {
            const TraceSample& s = samples[k];
            const Pose X_SO =
                poseFromCoordinates(s.source).inverse() * poseFromCoordinates(s.coordinates) * X_EO;
            const Eigen::Vector3d p_cm = 100.0 * X_SO.translation();
            const double T_K = temperature_K(s.objects[i]);
            if (p_cm.allFinite() && std::isfinite(T_K))
                path.points << PathPoint{p_cm.x(), p_cm.y(), p_cm.z(), displayTemperature(T_K, unit)};
        }
        return path;
    }

    QByteArray trajectories(FigureFormat format) const {
        PathsFigure figure;
        figure.title = FigureText::tr("Trajectories of the objects");
        figure.note = note;
        figure.hasHeading = layout.hasHeading;
        figure.corner = corner;
        figure.size_px =
            QSize(pixels(layout.width_mm), pixels(kViewAspect * layout.width_mm + kAboutViews_mm));
        figure.above = FigureText::tr("seen along \u2212z of the source");
        figure.aside = FigureText::tr("seen along x of the source");
        figure.temperature = FigureText::tr("Temperature (%1)").arg(temperatureUnitSymbol(unit));
        double coldest = 1e300, hottest = -1e300;
        const std::vector<TraceSample> samples = session.controlledSamples();
        for (std::size_t i = 0; i < session.experiment.objects.size(); ++i) {
            figure.paths << path(samples, i);
            for (const PathPoint& point : figure.paths.back().points) {
                coldest = std::min(coldest, point.temperature_degC);
                hottest = std::max(hottest, point.temperature_degC);
            }
        }
        if (coldest <= hottest) {
            figure.coldest_degC = std::floor(coldest);
            figure.hottest_degC = std::max(std::ceil(hottest), std::floor(coldest) + 1.0);
        }
        for (const Eigen::Vector2d& point : shapeOutline(session.experiment.source.shape, 120))
            figure.source_cm << QPointF(100.0 * point.x(), 100.0 * point.y());
        return pathsPicture(figure, format, kRunFigureMark);
    }
};

RunFigures::RunFigures(const SessionRecord& session, TemperatureUnit unit, const FigureLayout& layout,
                       bool namesMoments)
    : m_impl(new Impl{session, unit, layout, {}, {}, {}, {}, {}, {}}) {
    for (const ObjectSpec& object : session.experiment.objects)
        m_impl->names << QString::fromStdString(object.name);
    m_impl->store.reset(session.experiment.objects.size());
    m_impl->store.keepAll();
    m_impl->store.append(session.samples);
    const std::vector<int> numbers = markedEvents(session.events);
    QStringList words;
    double labelled_s = -1e300; // numbers that would overlap are left out, lines are not
    for (std::size_t k = 0; k < numbers.size() && layout.hasHeading; ++k) {
        if (numbers[k] == 0)
            continue;
        const double time_s = session.events[k].time_s;
        const bool hasRoom = time_s - labelled_s > kLabelRoom * m_impl->store.lastTime_s();
        m_impl->moments << FigureMoment{time_s, hasRoom ? QString::number(numbers[k]) : QString()};
        labelled_s = hasRoom ? time_s : labelled_s;
        if (hasRoom && namesMoments)
            words << QString::number(numbers[k]) + u' ' + messageText(session.events[k].message, unit);
    }
    m_impl->note = QString::fromStdString(session.experiment.title);
    if (session.simulated) {
        m_impl->corner = FigureText::tr("SIMULATED");
        m_impl->note = (QStringList(m_impl->corner) << m_impl->note).join(QStringLiteral(" \u00b7 "));
    }
    if (session.samples.empty())
        m_impl->note += QStringLiteral(" \u00b7 ") + FigureText::tr("no samples were recorded");
    m_impl->namesOfMoments = words.join(listSeparator());
}

RunFigures::~RunFigures() = default;

QByteArray RunFigures::draw(RunFigure figure, FigureFormat format) const {
    if (!figure)
        return m_impl->trajectories(format);
    return m_impl->traces(*figure == Quantity::Speed ? FigureText::tr("Commanded speed")
                                                     : quantityTitle(*figure),
                          *figure, format);
}

} // namespace bask
