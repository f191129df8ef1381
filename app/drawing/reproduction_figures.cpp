#include "app/drawing/reproduction_figures.h"

#include "app/drawing/reproduction_surfaces.h"
#include "app/drawing/view_factor_study_figures.h"
#include "engine/base/units.h"
#include "engine/control/controller_catalogue.h"

#include "widgets/plots/figure_paths.h"
#include "widgets/plots/figure_png.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

using Experiments = std::vector<const ReproducedExperiment*>;

constexpr double kHours = 4.0 * 3600.0; // beyond it the axis is in hours
constexpr QSize kHalfPage_px{1160, 800};
constexpr std::array<std::size_t, 2> kBoth{kByThePaper, kByTheLevelServo};
const QString kFigureComment = QStringLiteral("Bask reproduction");

QString controllerWords(ControllerKind kind) {
    const QString name = QString::fromUtf8(controllerEntry(kind).name);
    return kind == ControllerKind::LevelServo ? name : name + QStringLiteral(" law");
}

QString plain(double value) {
    return QString::fromStdString(formatNumber(value, 4));
}

QString targetsInDegrees(const Experiment& experiment) {
    return QString::fromStdString(targetWords(experiment)) + QString::fromUtf8(" °C");
}

double duration_s(const ReproducedExperiment& experiment) {
    return std::max(experiment.runs[0].samples.back().time_s, experiment.runs[1].samples.back().time_s);
}

double error_K(const ObjectSample& object) {
    return object.true_K - object.target_K;
}

double norm_K(const TraceSample& sample) {
    double sum = 0.0;
    for (const ObjectSample& object : sample.objects)
        sum += error_K(object) * error_K(object);
    return std::sqrt(sum);
}

/// Axes of an error over time.
Figure emptyFigure(const QString& title, const QString& note, double end_s) {
    Figure figure;
    figure.title = title;
    figure.note = note;
    const bool hours = end_s > kHours;
    figure.xLabel = hours ? QStringLiteral("Time (h)") : QStringLiteral("Time (s)");
    figure.yLabel = QStringLiteral("Temperature error (K)");
    figure.isXLogarithmic = figure.isYLogarithmic = false;
    figure.xRange = FigureRange{0.0, hours ? end_s / 3600.0 : end_s};
    figure.band = kSettledBand_K;
    figure.size_px = kHalfPage_px;
    return figure;
}

template <class Value>
FigureSeries seriesOf(const QString& name, const ReproducedRun& run, double end_s, const Value& value) {
    FigureSeries series{name, {}, true, false};
    const double unit_s = end_s > kHours ? 3600.0 : 1.0;
    for (const TraceSample& sample : run.samples)
        series.points << QPointF(sample.time_s / unit_s, value(sample));
    return series;
}

/// From the coldest to the hottest error of both controllers, so that their figures compare.
FigureRange errorRange(const Experiments& experiments) {
    FigureRange range{-2.0 * kSettledBand_K, 2.0 * kSettledBand_K};
    for (const ReproducedExperiment* experiment : experiments)
        for (const std::size_t by : kBoth)
            for (const TraceSample& sample : experiment->runs[by].samples)
                for (const ObjectSample& object : sample.objects)
                    range = {std::min(range.min, error_K(object)), std::max(range.max, error_K(object))};
    return range;
}

ReportPicture pictureOf(const Figure& figure) {
    return {figurePng(figure, kFigureComment), figure.title + QStringLiteral(": ") + figure.note, false};
}

std::vector<ReportPicture> errorPictures(const Experiments& experiments) {
    std::vector<ReportPicture> pictures;
    for (const ReproducedExperiment* each : experiments) {
        const Experiment& experiment = each->paper.experiment;
        for (const std::size_t by : kBoth) {
            const ReproducedRun& run = each->runs[by];
            Figure figure = emptyFigure(controllerWords(run.controller) + QStringLiteral(": ") +
                                            targetsInDegrees(experiment),
                                        QString::fromStdString(each->paper.name), duration_s(*each));
            figure.yRange = errorRange({each});
            for (std::size_t i = 0; i < experiment.objects.size(); ++i)
                figure.series << seriesOf(QString::fromStdString(experiment.objects[i].name), run,
                                          duration_s(*each),
                                          [i](const TraceSample& s) { return error_K(s.objects[i]); });
            pictures.push_back(pictureOf(figure));
        }
    }
    return pictures;
}

/// What tells the experiments of an overlay apart: the gain or the target.
QString overlayName(const Experiments& all, const Experiment& experiment) {
    const bool sameGain = std::ranges::all_of(all, [&](const ReproducedExperiment* other) {
        return other->paper.experiment.controller.modelBased.K == experiment.controller.modelBased.K;
    });
    return sameGain ? targetsInDegrees(experiment)
                    : QStringLiteral("K = %1").arg(plain(experiment.controller.modelBased.K));
}

std::vector<ReportPicture> overlayPictures(const Experiments& experiments) {
    std::vector<ReportPicture> pictures;
    double end_s = 0.0;
    for (const ReproducedExperiment* each : experiments)
        end_s = std::max(end_s, duration_s(*each));
    Experiments sorted = experiments;
    std::ranges::stable_sort(sorted, {}, [](const ReproducedExperiment* each) {
        return each->paper.experiment.objects.front().target_K;
    });
    for (const std::size_t by : kBoth) {
        Figure figure = emptyFigure(
            controllerWords(sorted.front()->runs[by].controller) + QStringLiteral(", one object"),
            by == kByThePaper ? QStringLiteral("Gains K (1/s²) as named, D = 0.2 1/s")
                              : QStringLiteral("The same files; the servo has no use for the gains"),
            end_s);
        figure.yRange = errorRange(experiments);
        for (const ReproducedExperiment* each : sorted)
            figure.series << seriesOf(overlayName(experiments, each->paper.experiment), each->runs[by], end_s,
                                      [](const TraceSample& s) { return error_K(s.objects[0]); });
        pictures.push_back(pictureOf(figure));
    }
    return pictures;
}

std::vector<ReportPicture> normPictures(const Experiments& experiments) {
    std::vector<ReportPicture> pictures;
    for (const ReproducedExperiment* each : experiments) {
        Figure figure =
            emptyFigure(QStringLiteral("Norm of the error, ") + targetsInDegrees(each->paper.experiment),
                        QString::fromStdString(each->paper.name), duration_s(*each));
        figure.yLabel = QStringLiteral("Norm of the errors (K)");
        figure.band = 0.0;
        double max = 1.0;
        for (const std::size_t by : kBoth) {
            figure.series << seriesOf(controllerWords(each->runs[by].controller), each->runs[by],
                                      duration_s(*each), norm_K);
            for (const QPointF& point : figure.series.back().points)
                max = std::max(max, point.y());
        }
        figure.yRange = FigureRange{0.0, max};
        pictures.push_back(pictureOf(figure));
    }
    return pictures;
}

FigurePath pathOf(const ReproducedExperiment& experiment, const ReproducedRun& run, std::size_t object) {
    FigurePath path{QString::fromStdString(experiment.paper.experiment.objects[object].name), {}};
    for (const TraceSample& sample : run.samples) {
        const Eigen::Vector3d p_SO_cm = 100.0 * objectCentre_m(experiment.paper.experiment, sample, object);
        path.points << PathPoint{p_SO_cm.x(), p_SO_cm.y(), p_SO_cm.z(),
                                 celsiusFromKelvin(sample.objects[object].measured_K)};
    }
    return path;
}

std::vector<ReportPicture> pathPictures(const Experiments& experiments) {
    std::vector<ReportPicture> pictures;
    for (const ReproducedExperiment* each : experiments) {
        const Experiment& experiment = each->paper.experiment;
        PathsFigure figure;
        figure.coldest_degC = std::floor(celsiusFromKelvin(experiment.environment_K));
        for (const ObjectSpec& object : experiment.objects)
            figure.hottest_degC = &object == &experiment.objects.front()
                                      ? celsiusFromKelvin(object.target_K)
                                      : std::max(figure.hottest_degC, celsiusFromKelvin(object.target_K));
        for (const Eigen::Vector2d& point : shapeOutline(experiment.source.shape, 120))
            figure.source_cm << QPointF(100.0 * point.x(), 100.0 * point.y());
        for (const std::size_t by : kBoth) {
            const ReproducedRun& run = each->runs[by];
            figure.title =
                controllerWords(run.controller) + QStringLiteral(": ") + targetsInDegrees(experiment);
            figure.note = QString::fromStdString(each->paper.name) +
                          QStringLiteral(": from the ring to the dot; black: the source");
            figure.paths.clear();
            for (std::size_t i = 0; i < experiment.objects.size(); ++i)
                figure.paths << pathOf(*each, run, i);
            pictures.push_back({pathsPng(figure, kFigureComment), figure.title, true});
        }
    }
    return pictures;
}

Result<std::vector<ReportPicture>> methodPictures() {
    constexpr int kMaxElements = 20000; // as the paper
    const auto study = runViewFactorStudy(kMaxElements);
    if (!study)
        return study.error();
    std::vector<ReportPicture> pictures;
    for (const Figure& figure : viewFactorStudyFigures(*study))
        pictures.push_back(pictureOf(figure));
    return pictures;
}

} // namespace

Result<std::vector<ReportPicture>> reportPictures(const std::string& plot, const Experiments& all) {
    if (plot == "overlay")
        return overlayPictures(all);
    if (plot == "errors")
        return errorPictures(all);
    if (plot == "norm")
        return normPictures(all);
    if (plot == "paths")
        return pathPictures(all);
    if (plot == "subsets")
        return subsetPictures();
    if (plot == "panels")
        return panelPictures();
    if (plot == "surfaces")
        return steadySurfacePictures(all);
    return methodPictures();
}

} // namespace bask
