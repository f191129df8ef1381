#include "widgets/scene/target_scene.h"

#include "engine/base/message_code.h"
#include "engine/control/rig_geometry.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/scene/cut_sheet.h"
#include "widgets/scene/scene_frame.h"
#include "widgets/scene/scene_overlay.h"
#include "widgets/scene/scene_rays.h"
#include "widgets/scene/target_props.h"
#include "widgets/scene/vtk_view.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bask {

namespace {

constexpr int kBarSteps = 10; ///< of the colour bar, and so contour lines
constexpr double kLift_px = 8.0;
constexpr double kGhostOpacity = 0.55;
constexpr double kMarkShare = 0.009; ///< radius of a mark, of the frame's diagonal
constexpr double kArrowShare = 0.07;
constexpr QSizeF kPlainSize{1000.0, 700.0}; ///< of a saved picture whose text is as large as on screen

QString tenthsText(double value) {
    const double tenths = std::round(10.0 * value) + 0.0; // no minus before zero
    return QLocale()
        .toString(tenths / 10.0, 'f', 1)
        .replace(QLocale().negativeSign(), QStringLiteral("\u2212"));
}

Box angleBox() {
    constexpr double kRightAngle = std::numbers::pi / 2.0; // as surfaceAxes has it
    return {Eigen::Vector3d::Constant(-kRightAngle), Eigen::Vector3d::Constant(kRightAngle)};
}

} // namespace

struct TargetScene::Impl {
    // Values; all of the picture can be made from them at any time.
    Experiment experiment;
    std::unique_ptr<RigGeometry> rig; ///< null without an experiment
    std::vector<HeatRates> rates;
    Box frame;
    Vector6d held = Vector6d::Zero();
    PoseSubset subset = PoseSubset::Translation;
    std::vector<Isosurface> surfaces;
    std::optional<SceneVerdict> verdict;
    std::optional<SceneCut> cut;
    bool stale = false;
    struct Pick {
        Vector6d q = Vector6d::Zero();
        PickedArrows arrows;
    };
    std::optional<Pick> picked;
    TemperatureUnit unit = TemperatureUnit::Celsius;
    ViewPreset preset = ViewPreset::Isometric;
    bool cameraIsPersons = false;
    double scale = 1.0; ///< of text and lines, while a large picture is saved

    // What the picture does not show yet.
    bool rebuild = true;
    bool resurface = true;
    bool remark = true;
    NiceRange cutRange;
    OverlayContent content;

    VtkView* view = nullptr;
    QLabel* notice = nullptr;
    std::unique_ptr<SceneProps> props;
    std::unique_ptr<TargetProps> targets;
    SceneOverlay overlay;

    bool isOverAngles() const { return subset == PoseSubset::Rotation; }
    /// The drawn three of a pose's coordinates.
    Eigen::Vector3d drawn(const Vector6d& q) const { return q.segment<3>(isOverAngles() ? kThetaX : kX); }
    Box limits() const { return {drawn(experiment.robot.lower), drawn(experiment.robot.upper)}; }
    Box drawnBox() const { return isOverAngles() ? angleBox() : limits(); }
    double inUnit(double value) const { return isOverAngles() ? degFromRad(value) : 100.0 * value; }
    QString unitWord() const { return isOverAngles() ? QStringLiteral("°") : QStringLiteral("cm"); }
    QString placeText(const Eigen::Vector3d& p) const {
        return QStringLiteral("(%1, %2, %3) %4")
            .arg(tenthsText(inUnit(p.x())), tenthsText(inUnit(p.y())), tenthsText(inUnit(p.z())), unitWord());
    }
    QSizeF size() const { return QSizeF(view->size()) / scale; }
    /// The verdict's pose; without one the start, turned as the surfaces are held.
    Vector6d ghost() const {
        Vector6d q = experiment.start;
        q.tail<3>() = held.tail<3>();
        return verdict ? verdict->pose : q;
    }
    double markRadius() const { return kMarkShare * frame.diagonal().norm(); }
    std::vector<QColor> colours(bool dark) const {
        std::vector<QColor> result;
        for (std::size_t i = 0; i < experiment.objects.size(); ++i)
            result.push_back(seriesColor(static_cast<int>(i), dark));
        return result;
    }
    double cutValue(double F) const {
        return cut->asTemperature
                   ? displayTemperature(
                         rates.at(static_cast<std::size_t>(cut->object)).steadyTemperature_K(F), unit)
                   : F;
    }
    std::vector<Eigen::Vector3d> clearancePolygon() const;
    void showCut(bool dark);
    void showMarks(bool dark);
    QStringList describe(Pick& pick) const;
    OverlayContent overlayContent(bool dark) const;
    void paint(QPainter& painter, const QPalette& palette, const QFont& font);
};

/// Where the end-effector is at the held angles when the lowest object has just the clearance.
std::vector<Eigen::Vector3d> TargetScene::Impl::clearancePolygon() const {
    Vector6d q = held;
    q.head<3>() = rig->X_RS().translation();
    const Eigen::Vector3d n = rig->away();
    const double offset =
        n.dot(rig->X_RS().translation()) + experiment.robot.clearance_m - rig->lowestPoint_m(q);
    return planeInBox(limits(), n, offset);
}

void TargetScene::Impl::showCut(bool dark) {
    if (!cut) {
        targets->setCut({}, [](double) { return QColor(); });
        return;
    }
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const double F : cut->field->values) // comparisons with NaN are false
        least = F < least ? F : least, most = F > most ? F : most;
    cutRange = least <= most ? niceRange(cutValue(least), cutValue(most), kBarSteps) : NiceRange{};
    CutSheet sheet = sheetOf(*cut->field, cut->axis % 3, cut->position);
    for (double& value : sheet.values)
        value = cutValue(value);
    for (double line = cutRange.least + cutRange.step; line < cutRange.most; line += cutRange.step)
        sheet.lines.push_back(line);
    targets->setCut(sheet, [this, dark](double value) {
        return mapColour((value - cutRange.least) / (cutRange.most - cutRange.least), dark);
    });
}

void TargetScene::Impl::showMarks(bool dark) {
    std::vector<Eigen::Vector3d> points;
    if (verdict && verdict->feasible)
        points = {drawn(verdict->pose)};
    else if (verdict && verdict->closest)
        points = {verdict->closest->first, verdict->closest->second};
    targets->setMarks(points, markRadius());
    targets->setArrows(picked ? &picked->arrows : nullptr, 0.7 * markRadius(), colours(dark));
}

OverlayContent TargetScene::Impl::overlayContent(bool dark) const {
    OverlayContent result;
    if (!rig)
        return result;
    result.frame = frame;
    result.angles = isOverAngles();
    result.hasBar = cut.has_value();
    result.bar = cutRange;
    if (cut)
        result.barUnit = cut->asTemperature ? temperatureUnitSymbol(unit) : QStringLiteral("F");
    const auto add = [&result](const QString& text, const QString& value,
                               const std::vector<Eigen::Vector3d>& outline) {
        SceneLabel label;
        label.text = text;
        label.value = value;
        label.outline_R = outline;
        result.labels.push_back(label);
    };
    if (picked)
        add(TargetScene::tr("Picked"), placeText(drawn(picked->q)), {drawn(picked->q)});
    if (verdict && verdict->feasible)
        add(TargetScene::tr("All targets"), placeText(drawn(verdict->pose)), {drawn(verdict->pose)});
    else if (verdict && verdict->closest) {
        const auto& [a, b] = *verdict->closest;
        add(TargetScene::tr("Closest"), tenthsText(inUnit((a - b).norm())) + QLatin1Char(' ') + unitWord(),
            {a, b});
    }
    // Over the angles no object is there to carry its name: its surface does.
    for (std::size_t i = 0; isOverAngles() && i < experiment.objects.size() && i < surfaces.size(); ++i)
        if (const auto& points = surfaces[i].points; !points.empty()) {
            add(QString::fromStdString(experiment.objects[i].name),
                formatTemperature(experiment.objects[i].target_K, unit), {points[points.size() / 2]});
            result.labels.back().colour = seriesColor(static_cast<int>(i), dark);
        }
    const Pose X_RE = poseFromCoordinates(ghost());
    for (std::size_t i = 0; i < experiment.objects.size() && !isOverAngles(); ++i) {
        const ObjectSpec& object = experiment.objects[i];
        const Pose X_RO = X_RE * poseFromCoordinates(object.mounting);
        std::vector<Eigen::Vector3d> outline;
        for (const Eigen::Vector3d& p_OQ : labelOutline(object.shape))
            outline.push_back(X_RO * p_OQ);
        add(QString::fromStdString(object.name), formatTemperature(object.target_K, unit), outline);
        result.labels.back().colour = seriesColor(static_cast<int>(i), dark);
    }
    return result;
}

/// Points the arrows and says the figures, a sentence an object.
QStringList TargetScene::Impl::describe(Pick& pick) const {
    QStringList words;
    pick.arrows.at = drawn(pick.q);
    pick.arrows.length = kArrowShare * frame.diagonal().norm();
    const ViewFactors factors = rig->viewFactors(pick.q);
    for (Eigen::Index i = 0; i < factors.F.size(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const Eigen::Vector3d slope = drawn(factors.dF.row(i).transpose());
        pick.arrows.directions.push_back(slope.stableNormalized());
        words << TargetScene::tr("%1: F %2, steady at %3, F grows by %4 per %5")
                     .arg(QString::fromStdString(experiment.objects[k].name),
                          QLocale().toString(factors.F[i], 'f', 3),
                          formatTemperature(rates[k].steadyTemperature_K(factors.F[i]), unit),
                          QLocale().toString(slope.norm() / inUnit(1.0), 'f', 3), unitWord());
    }
    return words;
}

void TargetScene::Impl::paint(QPainter& painter, const QPalette& palette, const QFont& font) {
    painter.setFont(font);
    painter.scale(scale, scale);
    if (stale) {
        QColor ground = palette.color(QPalette::Base);
        ground.setAlphaF(0.35F);
        QColor hatch = palette.color(QPalette::Text);
        hatch.setAlphaF(0.22F);
        painter.fillRect(QRectF({}, size()), ground);
        painter.fillRect(QRectF({}, size()), QBrush(hatch, Qt::BDiagPattern));
    }
    overlay.paint(painter, size(), palette, Projection(*view->renderer().GetActiveCamera(), size()), content);
}

TargetScene::TargetScene(QWidget* parent) : QWidget(parent), m(std::make_unique<Impl>()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (VtkView::available())
        makePicture();
    else
        showNotice();
}

TargetScene::~TargetScene() {
    // The view may still paint while QWidget's destructor takes it down, when the rest is gone.
    if (m->view != nullptr) {
        m->targets.reset();
        m->props.reset();
        delete m->view;
        m->view = nullptr;
    }
}

void TargetScene::makePicture() {
    m->view = new VtkView(this);
    m->view->setAccessibleName(tr("3-D scene of the targets"));
    layout()->addWidget(m->view);
    setFocusProxy(m->view);
    m->props = std::make_unique<SceneProps>(m->view->renderer());
    m->targets = std::make_unique<TargetProps>(m->view->renderer());
    m->view->setPrepare([this] { prepareFrame(); });
    m->view->setOverlay([this](QPainter& painter) { m->paint(painter, palette(), font()); });
    connect(m->view, &VtkView::cameraMoved, this, [this] { m->cameraIsPersons = true; });
    connect(m->view, &VtkView::cameraResetRequested, this, [this] { turnTo(m->preset); });
    connect(m->view, &VtkView::clicked, this, &TargetScene::pick);
    connect(m->view, &VtkView::failed, this, [this] {
        m->view->setPrepare({});
        m->view->setOverlay({});
        m->view->hide();
        m->view->deleteLater();
        m->targets.reset();
        m->props.reset();
        m->view = nullptr;
        showNotice();
    });
    applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
}

void TargetScene::showNotice() {
    m->notice = new QLabel(this);
    m->notice->setAlignment(Qt::AlignCenter);
    m->notice->setWordWrap(true);
    m->notice->setMargin(24);
    m->notice->setText(tr("The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. "
                          "Everything else works."));
    layout()->addWidget(m->notice);
}

bool TargetScene::hasPicture() const {
    return m->view != nullptr;
}
QSize TargetScene::sizeHint() const {
    return {640, 480};
}
QSize TargetScene::minimumSizeHint() const {
    return {160, 120};
}

void TargetScene::requestFrame() {
    if (m->view != nullptr)
        m->view->requestFrame();
}

void TargetScene::setExperiment(const Experiment& experiment) {
    const bool sameRoom = m->rig && frameOf(experiment).isApprox(m->frame);
    m->experiment = experiment;
    m->subset = PoseSubset::Translation;
    m->frame = frameOf(experiment);
    std::vector<Shape> shapes;
    std::vector<Vector6d> mountings;
    m->rates.clear();
    const SourceSpec& source = experiment.source;
    const double power_W_m2 =
        netSourcePower_W_m2(source.model, source.temperature_K, source.emittance, experiment.environment_K);
    for (const ObjectSpec& object : experiment.objects) {
        shapes.push_back(object.shape);
        mountings.push_back(object.mounting);
        m->rates.push_back(heatRates(object.material, power_W_m2, experiment.environment_K));
    }
    m->rig = std::make_unique<RigGeometry>(source.shape, shapes, mountings, experiment.robot,
                                           poseFromCoordinates(source.pose));
    m->held = experiment.start;
    m->surfaces.clear();
    m->verdict.reset();
    m->cut.reset();
    m->picked.reset();
    m->rebuild = true;
    if (!sameRoom || !m->cameraIsPersons)
        fit();
    requestFrame();
}

void TargetScene::setSurfaces(std::vector<Isosurface> surfaces, const Vector6d& held, PoseSubset subset) {
    if (subset != m->subset) {
        m->subset = subset;
        m->frame = m->isOverAngles() ? angleBox() : frameOf(m->experiment);
        m->cut.reset();
        m->picked.reset();
        m->rebuild = true;
        fit();
    }
    m->surfaces = std::move(surfaces);
    m->held = held;
    m->resurface = true;
    requestFrame();
}

void TargetScene::setVerdictPoint(const std::optional<SceneVerdict>& verdict) {
    m->verdict = verdict;
    m->remark = true;
    requestFrame();
}

void TargetScene::setCut(const std::optional<SceneCut>& cut) {
    if (cut) {
        const int first = m->isOverAngles() ? kThetaX : kX;
        const auto isOver = [&](int a) {
            return cut->field->axes[static_cast<std::size_t>(a)].coordinate == first + a;
        };
        if (!cut->field || cut->field->axes.size() != 3 || !isOver(0) || !isOver(1) || !isOver(2) ||
            cut->axis < first || cut->axis > first + 2 || cut->object < 0 ||
            cut->object >= static_cast<int>(m->experiment.objects.size()))
            throw std::invalid_argument("TargetScene: a cut needs an object's field over the surfaces' axes");
    }
    m->cut = cut;
    m->remark = true;
    requestFrame();
}

void TargetScene::setStale(bool stale) {
    if (stale == m->stale)
        return;
    m->stale = stale;
    m->remark = true;
    requestFrame();
}

void TargetScene::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m->unit)
        return;
    m->unit = unit;
    m->remark = true;
    requestFrame();
}

void TargetScene::clearPick() {
    m->picked.reset();
    m->remark = true;
    requestFrame();
}

void TargetScene::viewAlongMinusZ() {
    turnTo(ViewPreset::AlongMinusZ);
}
void TargetScene::viewAlongX() {
    turnTo(ViewPreset::AlongX);
}
void TargetScene::viewIsometric() {
    turnTo(ViewPreset::Isometric);
}

void TargetScene::turnTo(ViewPreset preset) {
    m->preset = preset;
    if (m->view != nullptr)
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
    fit();
}

void TargetScene::fit() {
    m->cameraIsPersons = false; // prepareFrame fits it
    requestFrame();
}

void TargetScene::prepareFrame() {
    const bool dark = isDark(palette());
    vtkCamera& camera = *m->view->renderer().GetActiveCamera();
    const QSizeF size = m->size();
    if (!m->cameraIsPersons && m->rig)
        fitCamera(camera, m->frame, size, SceneOverlay::margins(font(), size));
    const double lineScale = m->scale * m->view->devicePixelRatioF() *
                             std::clamp(std::min(size.width() / 800.0, size.height() / 560.0), 0.5, 1.0);
    if (m->rebuild)
        m->props->setColours(sceneColours(palette()));
    if (m->rebuild && m->rig && m->isOverAngles())
        m->view->renderer().RemoveAllViewProps();
    else if (m->rebuild && m->rig) {
        m->props->build(m->experiment, m->frame);
        m->props->setObjectOpacity(kGhostOpacity);
        for (std::size_t i = 0; i < m->experiment.objects.size(); ++i)
            m->props->setObjectColour(i, seriesColor(static_cast<int>(i), dark));
    }
    if (m->rebuild && m->rig)
        m->targets->addActors();
    if ((m->rebuild || m->resurface) && m->rig) {
        const auto clearance = m->isOverAngles() ? std::vector<Eigen::Vector3d>() : m->clearancePolygon();
        m->targets->setSurfaces(m->surfaces);
        m->targets->setBounds(m->isOverAngles() ? edgesOf(m->limits()) : sidesOf(clearance), clearance);
    }
    if ((m->rebuild || m->resurface || m->remark) && m->rig) {
        m->showCut(dark);
        m->showMarks(dark);
        m->targets->setColours(m->colours(dark), palette().color(QPalette::Text),
                               palette().color(QPalette::Base), m->stale);
    }
    if (m->rig) {
        m->props->setLineScale(lineScale);
        m->targets->setLineScale(lineScale);
        const Eigen::Vector3d direction(camera.GetDirectionOfProjection());
        const double metresPerPixel = 2.0 * camera.GetParallelScale() / std::max(1.0, size.height());
        const Eigen::Vector3d lift = -kLift_px * metresPerPixel * direction;
        m->props->setViewDirection(direction);
        m->props->setPoses(poseFromCoordinates(m->ghost()), m->rig->X_RS(), lift);
        m->targets->setLift(0.25 * lift, -1.5 * m->frame.diagonal().norm() * direction);
    }
    m->content = m->overlayContent(dark);
    m->rebuild = m->resurface = m->remark = false;
}

void TargetScene::pick(QPointF place) {
    if (!m->rig)
        return;
    const Ray ray = rayThrough(*m->view->renderer().GetActiveCamera(), m->view->size(), place);
    std::optional<double> nearest;
    const auto take = [&nearest](const std::optional<double>& along) {
        if (along && (!nearest || *along < *nearest))
            nearest = along;
    };
    for (const Isosurface& surface : m->surfaces)
        take(distanceTo(surface, ray));
    const RobotLimits& robot = m->experiment.robot;
    if (m->cut)
        take(distanceToCut(Box(robot.lower.head<3>().eval(), robot.upper.head<3>().eval()), m->cut->axis,
                           m->cut->position, ray));
    if (!nearest)
        return;
    Impl::Pick picked;
    picked.q = m->held;
    picked.q.segment<3>(m->isOverAngles() ? kThetaX : kX) = ray.origin + *nearest * ray.direction;
    QStringList words;
    try {
        words = m->describe(picked);
    } catch (const std::invalid_argument&) {
        return; // object and source in one plane: there is no view factor
    }
    m->picked = picked;
    m->remark = true;
    requestFrame();
    emit posePicked(picked.q, words);
}

QImage TargetScene::image(QSize size) {
    if (m->view == nullptr || !m->view->isValid() || size.isEmpty())
        return {};
    const QRect place = m->view->geometry();
    const double ratio = m->view->devicePixelRatioF();
    const double growth = std::min(size.width() / kPlainSize.width(), size.height() / kPlainSize.height());
    m->scale = std::max(1.0, growth / ratio);
    m->view->resize((QSizeF(size) / ratio).toSize());
    const QImage picture = m->view->grabFramebuffer().copy(QRect({}, size));
    m->scale = 1.0;
    m->view->setGeometry(place);
    requestFrame();
    return picture;
}

Result<void> TargetScene::saveImage(const QString& path, QSize size) {
    const QImage picture = image(size);
    if (picture.isNull())
        return Error(MessageCode::FileUnwritable, path.toStdString(), {"there is no picture"});
    if (!picture.save(path, "PNG"))
        return Error(MessageCode::FileUnwritable, path.toStdString(), {"it cannot be written"});
    return {};
}

void TargetScene::changeEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
        m->rebuild = true;
        requestFrame();
        break;
    case QEvent::LanguageChange:
    case QEvent::LocaleChange:
        if (m->view != nullptr)
            m->view->setAccessibleName(tr("3-D scene of the targets"));
        if (m->notice != nullptr)
            m->notice->setText(
                tr("The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. "
                   "Everything else works."));
        requestFrame();
        break;
    default:
        break;
    }
    QWidget::changeEvent(event);
}

void TargetScene::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    requestFrame();
}

} // namespace bask
