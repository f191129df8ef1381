#include "app/drawing/reproduction_surfaces.h"

#include "app/drawing/field_axes.h"
#include "engine/base/units.h"
#include "engine/exchange/isosurface.h"
#include "engine/model/uneven_source.h"
#include "engine/rig/rig_setup.h"

#include "widgets/plots/figure_surfaces.h"

#include <cmath>

namespace bask {
namespace {

const QString kSurfaceComment = QStringLiteral("Bask reproduction");
const QString kDisks =
    QStringLiteral("disk of 1.5 cm over a disk of 10 cm (black); the quarter towards the eye is cut away");
constexpr double kSurfaceTolerance = 1e-7;
constexpr std::array kLevels{0.1, 0.3, 0.5, 0.7, 0.9};

/// From violet to yellow: still apart in grey.
QColor levelColor(double F) {
    static const std::array kStops{QColor(0x46, 0x3b, 0x8a), QColor(0x2f, 0x6d, 0xb0),
                                   QColor(0x2a, 0xa1, 0x8c), QColor(0x8c, 0xc6, 0x3f),
                                   QColor(0xf2, 0xb7, 0x05)};
    return kStops[static_cast<std::size_t>(std::clamp(std::lround(F / 0.2 - 0.5), 0L, 4L))];
}

FigureSurface drawn(const Isosurface& surface, double scale, const QString& name, const QColor& color) {
    FigureSurface out{name, color, surface.points, surface.normals, surface.triangles};
    for (Eigen::Vector3d& point : out.points)
        point *= scale;
    return out;
}

std::vector<FieldAxis> translations() {
    return {{kX, -0.20, 0.01, 41}, {kY, -0.20, 0.01, 41}, {kZ, 0.005, 0.005, 60}};
}

std::vector<FieldAxis> rotations() {
    const double first = radFromDeg(-90.0), step = radFromDeg(6.0);
    return {{kThetaX, first, step, 31}, {kThetaY, first, step, 31}, {kThetaZ, first, step, 31}};
}

/// A box with cm or degrees, without surfaces.
SurfacePanel emptyPanel(const QString& title, bool overRotations) {
    SurfacePanel panel;
    panel.title = title;
    if (overRotations) {
        panel.axes = {QString::fromUtf8("θx (°)"), QString::fromUtf8("θy (°)"), QString::fromUtf8("θz (°)")};
        panel.lower = {-90.0, -90.0, -90.0};
        panel.upper = {90.0, 90.0, 90.0};
        panel.tick = 45.0;
    } else {
        panel.axes = {QStringLiteral("x (cm)"), QStringLiteral("y (cm)"), QStringLiteral("z (cm)")};
        panel.lower = {-20.0, -20.0, 0.0};
        panel.upper = {20.0, 20.0, 30.0};
        panel.tick = 10.0;
    }
    return panel;
}

FigureLine sourceLine(const Shape& source) {
    FigureLine line{{}, Qt::black};
    for (const Eigen::Vector2d& point : shapeOutline(source, 120))
        line.points.emplace_back(100.0 * point.x(), 100.0 * point.y(), 0.0);
    line.points.push_back(line.points.front());
    return line;
}

/// Surfaces of equal view factor of the paper's disks, `fixed` saying where.
Result<SurfacePanel> levelPanel(const QString& title, bool overRotations, const Vector6d& fixed) {
    FieldRequest request{RadiatingContour(presetSource()), RadiatingContour(presetObject()),
                         overRotations ? rotations() : translations()};
    request.fixed = fixed;
    request.tolerance = kSurfaceTolerance;
    const auto field = sampleField(request);
    if (!field)
        return field.error();
    SurfacePanel panel = emptyPanel(title, overRotations);
    const double scale = overRotations ? degFromRad(1.0) : 100.0;
    for (const Isosurface& surface : isosurfaces(**field, {kLevels.begin(), kLevels.end()}))
        if (!surface.empty())
            panel.surfaces << drawn(surface, scale, QStringLiteral("F = %1").arg(surface.value),
                                    levelColor(surface.value));
    if (!overRotations)
        panel.lines << sourceLine(presetSource());
    return panel;
}

struct LevelCase {
    QString title;
    bool overRotations;
    Coordinate fixed;
    double value; ///< m or rad
};

Result<QList<SurfacePanel>> levelPanels(const std::vector<LevelCase>& cases) {
    QList<SurfacePanel> panels;
    for (const LevelCase& each : cases) {
        Vector6d fixed = Vector6d::Zero();
        if (each.overRotations)
            fixed[kZ] = 0.05;
        fixed[each.fixed] = each.value;
        auto panel = levelPanel(each.title, each.overRotations, fixed);
        if (!panel)
            return panel.error();
        panels << std::move(*panel);
    }
    return panels;
}

std::vector<ReportPicture> onePicture(const SurfacesFigure& figure) {
    return {{surfacesPng(figure, kSurfaceComment), figure.title + QStringLiteral(". ") + figure.note, true}};
}

QColor objectColor(std::size_t object) {
    return object == 0 ? QColor(0xd6, 0x40, 0x2c) : QColor(0x2f, 0x6d, 0xb0);
}

/// Where an object's centre is steady at the temperatures, over the translations.
Result<QList<FigureSurface>> steadySurfaces(const Experiment& experiment, std::size_t object,
                                            const std::vector<double>& temperatures_K) {
    const HeatRates rates = nominalRates(experiment, experiment.environment_K)[object];
    FieldRequest request{radiatingSource(experiment), RadiatingContour(experiment.objects[object].shape),
                         translations()};
    request.tolerance = kSurfaceTolerance;
    const auto field = sampleField(request);
    if (!field)
        return field.error();
    std::vector<double> values;
    for (const double temperature_K : temperatures_K)
        values.push_back(rates.steadyViewFactor(temperature_K));
    QList<FigureSurface> surfaces;
    for (const Isosurface& surface : isosurfaces(**field, values))
        surfaces << drawn(surface, 100.0, QString::fromStdString(experiment.objects[object].name),
                          objectColor(object));
    return surfaces;
}

FigureLine centreLine(const ReproducedExperiment& experiment, const ReproducedRun& run, std::size_t object) {
    FigureLine line;
    for (const TraceSample& sample : run.samples)
        line.points.push_back(100.0 * objectCentre_m(experiment.paper.experiment, sample, object));
    return line;
}

/// The objects by themselves and together, at the paper's three temperatures.
Result<QList<SurfacePanel>> threeTemperatures(const Experiment& experiment) {
    const std::vector<double> temperatures_K{kelvinFromCelsius(30.0), kelvinFromCelsius(40.0),
                                             kelvinFromCelsius(50.0)};
    const QString words = QString::fromUtf8(": steady at 30, 40, 50 °C");
    SurfacePanel both = emptyPanel(QStringLiteral("both") + words, false);
    both.lines << sourceLine(experiment.source.shape);
    QList<SurfacePanel> panels;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const auto surfaces = steadySurfaces(experiment, i, temperatures_K);
        if (!surfaces)
            return surfaces.error();
        SurfacePanel panel = emptyPanel(QString::fromStdString(experiment.objects[i].name) + words, false);
        panel.surfaces = *surfaces;
        panel.lines = both.lines;
        both.surfaces << *surfaces;
        panels << panel;
    }
    panels << both;
    return panels;
}

Result<SurfacePanel> targetPanel(const ReproducedExperiment& experiment, std::size_t by) {
    const Experiment& rig = experiment.paper.experiment;
    QStringList targets;
    for (const ObjectSpec& object : rig.objects)
        targets << QString::fromStdString(formatNumber(celsiusFromKelvin(object.target_K), 4));
    SurfacePanel panel = emptyPanel(
        QString::fromUtf8("%1 °C, %2")
            .arg(targets.join(QStringLiteral(", ")), QLatin1String(experiment.runs[by].controller.key())),
        false);
    for (std::size_t i = 0; i < rig.objects.size(); ++i) {
        const auto surfaces = steadySurfaces(rig, i, {rig.objects[i].target_K});
        if (!surfaces)
            return surfaces.error();
        panel.surfaces << *surfaces;
        panel.lines << centreLine(experiment, experiment.runs[by], i);
    }
    panel.lines << sourceLine(rig.source.shape);
    return panel;
}

} // namespace

Result<std::vector<ReportPicture>> subsetPictures() {
    auto panels = levelPanels({{QStringLiteral("translations, parallel"), false, kThetaX, 0.0},
                               {QStringLiteral("rotations at (0, 0, 5) cm"), true, kZ, 0.05}});
    if (!panels)
        return panels.error();
    return onePicture({QStringLiteral("Surfaces of equal view factor"), kDisks, std::move(*panels)});
}

Result<std::vector<ReportPicture>> panelPictures() {
    std::vector<LevelCase> cases;
    for (const double angle_deg : {0.0, 45.0, 90.0})
        cases.push_back({QString::fromUtf8("translations, θx = %1°").arg(angle_deg), false, kThetaX,
                         radFromDeg(angle_deg)});
    for (const double height_cm : {1.0, 5.0, 10.0})
        cases.push_back({QStringLiteral("rotations, z = %1 cm").arg(height_cm), true, kZ, height_cm / 100.0});
    for (const double aside_cm : {0.0, 5.0, 10.0})
        cases.push_back(
            {QStringLiteral("rotations, z = 5 cm, x = %1 cm").arg(aside_cm), true, kX, aside_cm / 100.0});
    auto panels = levelPanels(cases);
    if (!panels)
        return panels.error();
    return onePicture({QStringLiteral("Surfaces of equal view factor as a fourth coordinate changes"), kDisks,
                       std::move(*panels), 3});
}

Result<std::vector<ReportPicture>>
steadySurfacePictures(const std::vector<const ReproducedExperiment*>& all) {
    auto panels = threeTemperatures(all.front()->paper.experiment);
    if (!panels)
        return panels.error();
    SurfacesFigure figure{QStringLiteral("Where the objects' centres are steady"),
                          QStringLiteral("black: the source; the quarter towards the eye is cut away"),
                          std::move(*panels), 3};
    std::vector<ReportPicture> pictures = onePicture(figure);
    figure = {
        QStringLiteral("The targets' surfaces and the paths of the centres"),
        QStringLiteral("from blue at the start to red at the end; above the paper's controller, below the "
                       "level servo"),
        {},
        static_cast<int>(all.size())};
    for (const std::size_t by : {kByThePaper, kByTheLevelServo})
        for (const ReproducedExperiment* each : all) {
            auto panel = targetPanel(*each, by);
            if (!panel)
                return panel.error();
            figure.panels << std::move(*panel);
        }
    pictures.push_back(onePicture(figure).front());
    return pictures;
}

} // namespace bask
