#include "widgets/scene/scene_view.h"

#include "engine/model/hand_warm.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/scene/scene_frame.h"
#include "widgets/scene/scene_overlay.h"
#include "widgets/scene/scene_props.h"
#include "widgets/scene/trail.h"
#include "widgets/scene/vtk_view.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {

namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kBarSteps = 5;
constexpr double kSmallestHeat_K = 10.0; ///< from the room to a source that glows
constexpr double kHotLook = 0.5;         ///< of the glow, at least, of what is too hot for a hand
constexpr double kLift_px = 8.0;         ///< of lines towards the viewer: enough at 80 degrees of tilt

/// What the controller holds for true, else the reading, else the plant's own.
double temperatureOf_K(const ObjectSample& sample) {
    if (std::isfinite(sample.estimated_K) && sample.estimated_K > 0.0)
        return sample.estimated_K;
    if (std::isfinite(sample.measured_K) && sample.measured_K > 0.0)
        return sample.measured_K;
    return std::isfinite(sample.true_K) && sample.true_K > 0.0 ? sample.true_K : kUnknown;
}

} // namespace

struct SceneView::Impl {
    // Values; all of the picture can be made from them at any time.
    Experiment experiment;
    bool hasExperiment = false;
    Box frame;
    Pose X_RE = Pose::Identity();
    Pose X_RS = Pose::Identity();
    std::vector<Pose> X_EO;
    std::vector<std::vector<Eigen::Vector3d>> outlines_O;
    std::vector<Trail> trails;
    std::vector<Vector6d> plan;                        ///< coordinates of the end-effector on the way
    std::vector<std::vector<Eigen::Vector3d>> paths_R; ///< of each object on that way, as they are drawn
    bool planArrives = false;                          ///< its end is where the run settles
    std::vector<double> temperatures_K;
    std::vector<double> targets_K;
    double source_K = kUnknown;
    std::optional<HeatState> heat;
    TemperatureUnit unit = TemperatureUnit::Celsius;
    ViewPreset preset = ViewPreset::Isometric;
    bool cameraIsPersons = false;

    // What the picture does not show yet.
    bool rebuild = true;
    bool recolour = true;
    bool trailsGrew = true;
    bool isPlanNew = true;
    NiceRange shownRange;
    OverlayContent content;

    VtkView* view = nullptr;
    QLabel* notice = nullptr;
    std::unique_ptr<SceneProps> props;
    SceneOverlay overlay;

    void resetTrace();
    double warmth() const;
    NiceRange range() const;
    QColor colourOf(double t_K, bool dark) const;
    std::vector<Eigen::Vector3d> plannedPathOf(std::size_t object) const;
    OverlayContent overlayContent(bool dark) const;
};

void SceneView::Impl::resetTrace() {
    trails.assign(experiment.objects.size(), Trail());
    temperatures_K.assign(experiment.objects.size(), kUnknown);
    source_K = kUnknown;
    targets_K.clear();
    for (const ObjectSpec& object : experiment.objects)
        targets_K.push_back(object.target_K);
    trailsGrew = true;
}

/// Of the objects as they are now: a wrong reading that is gone, though it is still in the trail, does not
/// keep it wide; a trail's colours end at its ends. It holds the room and the targets from the start, so that
/// colours stay as the objects warm up. The source has colours of its own: with it the objects would be
/// alike.
NiceRange SceneView::Impl::range() const {
    double coldest_K = experiment.environment_K, hottest_K = coldest_K;
    const auto see = [&](double t_K) {
        coldest_K = std::fmin(coldest_K, t_K); // the other one where one is NaN
        hottest_K = std::fmax(hottest_K, t_K);
    };
    std::ranges::for_each(targets_K, see);
    std::ranges::for_each(temperatures_K, see);
    return niceRange(displayTemperature(coldest_K, unit), displayTemperature(hottest_K, unit), kBarSteps);
}

/// Share of the way from the room to the highest set point of a run, and never a little of it for what is too
/// hot for a hand.
double SceneView::Impl::warmth() const {
    if (!std::isfinite(source_K))
        return 1.0;
    const double room_K = experiment.environment_K;
    const double hot_K = std::max(highestSetPoint_K(experiment.source), room_K + kSmallestHeat_K);
    const double share = std::clamp((source_K - room_K) / (hot_K - room_K), 0.0, 1.0);
    return source_K > room_K + kHandWarm_K ? std::max(share, kHotLook) : share;
}

QColor SceneView::Impl::colourOf(double t_K, bool dark) const {
    return mapColour((displayTemperature(t_K, unit) - shownRange.min) / (shownRange.max - shownRange.min),
                     dark);
}

std::vector<Eigen::Vector3d> SceneView::Impl::plannedPathOf(std::size_t object) const {
    std::vector<Eigen::Vector3d> path_R;
    path_R.reserve(plan.size());
    for (const Vector6d& coordinates : plan)
        path_R.emplace_back(poseFromCoordinates(coordinates) * X_EO[object].translation());
    return path_R;
}

OverlayContent SceneView::Impl::overlayContent(bool dark) const {
    OverlayContent result;
    if (!hasExperiment)
        return result;
    result.frame = frame;
    result.hasBar = !experiment.objects.empty();
    result.bar = shownRange;
    result.barTitle = temperatureUnitSymbol(unit);
    if (!plan.empty())
        result.paths_R = paths_R;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        SceneLabel label;
        label.text = QString::fromStdString(experiment.objects[i].name);
        if (std::isfinite(temperatures_K[i]))
            label.value = formatTemperature(temperatures_K[i], unit);
        label.colour = seriesColor(static_cast<int>(i), dark);
        const Pose X_RO = X_RE * X_EO[i];
        for (const Eigen::Vector3d& p_OQ : outlines_O[i])
            label.outline_R.push_back(X_RO * p_OQ);
        result.labels.push_back(label);
    }
    SceneLabel source;
    source.text = SceneView::tr("Source");
    source.optional = true;
    source.value = formatTemperature(source_K, unit, 0);
    for (const Eigen::Vector3d& p_SQ : labelOutline(experiment.source.shape))
        source.outline_R.push_back(X_RS * p_SQ);
    result.labels.push_back(source);
    return result;
}

SceneView::SceneView(QWidget* parent) : QWidget(parent), m(std::make_unique<Impl>()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (VtkView::available())
        makePicture();
    else
        showNotice();
}

SceneView::~SceneView() {
    // The view may still paint while QWidget's destructor takes it down, when the rest is gone.
    if (m->view != nullptr) {
        m->props.reset();
        delete m->view;
        m->view = nullptr;
    }
}

void SceneView::makePicture() {
    m->view = new VtkView(this);
    m->view->setAccessibleName(tr("3-D scene"));
    layout()->addWidget(m->view);
    setFocusProxy(m->view);
    m->props = std::make_unique<SceneProps>(m->view->renderer());
    m->view->setPrepare([this] { prepareFrame(); });
    m->view->setOverlay([this](QPainter& painter) {
        const QSizeF size = m->view->size();
        painter.setFont(font());
        m->overlay.paint(painter, size, palette(), Projection(*m->view->renderer().GetActiveCamera(), size),
                         m->content);
    });
    connect(m->view, &VtkView::cameraMoved, this, [this] { m->cameraIsPersons = true; });
    connect(m->view, &VtkView::cameraResetRequested, this, [this] {
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
        fit();
    });
    connect(m->view, &VtkView::failed, this, [this] {
        m->view->setPrepare({});
        m->view->setOverlay({});
        m->view->hide();
        m->view->deleteLater();
        m->props.reset();
        m->view = nullptr;
        showNotice();
    });
    applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
}

void SceneView::showNotice() {
    m->notice = new QLabel(this);
    m->notice->setAlignment(Qt::AlignCenter);
    m->notice->setWordWrap(true);
    m->notice->setMargin(24);
    m->notice->setText(
        tr("The 3-D scene needs OpenGL 3.2, which this display does not offer. Everything else works."));
    layout()->addWidget(m->notice);
}

bool SceneView::hasPicture() const {
    return m->view != nullptr;
}
QSize SceneView::sizeHint() const {
    return {640, 480};
}
QSize SceneView::minimumSizeHint() const {
    return {160, 120};
}

void SceneView::requestFrame() {
    if (m->view != nullptr)
        m->view->requestFrame();
}

void SceneView::setExperiment(const Experiment& experiment) {
    const bool sameRoom = m->hasExperiment && frameOf(experiment).isApprox(m->frame);
    m->experiment = experiment;
    m->hasExperiment = true;
    m->frame = frameOf(experiment);
    m->X_RE = poseFromCoordinates(experiment.start);
    m->X_RS = poseFromCoordinates(experiment.source.pose);
    m->X_EO.clear();
    m->outlines_O.clear();
    for (const ObjectSpec& object : experiment.objects) {
        m->X_EO.push_back(poseFromCoordinates(object.mounting));
        m->outlines_O.push_back(labelOutline(object.shape));
    }
    m->resetTrace();
    m->plan.clear();
    m->rebuild = true;
    if (!sameRoom || !m->cameraIsPersons)
        fit();
    requestFrame();
}

void SceneView::clearTrace() {
    m->resetTrace();
    requestFrame();
}

void SceneView::appendSamples(const std::vector<TraceSample>& samples) {
    for (const TraceSample& sample : samples) {
        if (!m->hasExperiment || sample.objects.size() != m->X_EO.size() || !sample.coordinates.allFinite())
            continue;
        m->X_RE = poseFromCoordinates(sample.coordinates);
        if (sample.source.allFinite())
            m->X_RS = poseFromCoordinates(sample.source);
        if (sample.source_K > 0.0)
            m->source_K = sample.source_K;
        for (std::size_t i = 0; i < m->X_EO.size(); ++i) {
            m->temperatures_K[i] = temperatureOf_K(sample.objects[i]);
            if (std::isfinite(sample.objects[i].target_K) && sample.objects[i].target_K > 0.0)
                m->targets_K[i] = sample.objects[i].target_K;
            m->trails[i].append({m->X_RE * m->X_EO[i].translation(), m->temperatures_K[i]});
        }
        m->trailsGrew = true;
    }
    requestFrame();
}

void SceneView::setSamples(const std::vector<TraceSample>& samples) {
    m->resetTrace();
    appendSamples(samples);
}

void SceneView::setPlan(const PredictedRun& run) {
    if (run.samples.empty() && m->plan.empty())
        return;
    m->plan.clear();
    m->plan.reserve(run.samples.size());
    for (const PredictedSample& sample : run.samples)
        if (sample.coordinates.allFinite())
            m->plan.push_back(sample.coordinates);
    m->planArrives = run.end == PredictedEnd::Settled;
    m->isPlanNew = true;
    requestFrame();
}

// What is told again and again and is the same needs no frame: the engine tells 20 times a second.
void SceneView::moveTo(Pose& pose, const Vector6d& coordinates) {
    const Pose next = poseFromCoordinates(coordinates);
    if (next.matrix() == pose.matrix())
        return;
    pose = next;
    requestFrame();
}

void SceneView::setPose(const Vector6d& coordinates) {
    if (coordinates.allFinite())
        moveTo(m->X_RE, coordinates);
}

void SceneView::setSourcePose(const Vector6d& coordinates) {
    if (coordinates.allFinite())
        moveTo(m->X_RS, coordinates);
}

void SceneView::setSourceTemperature_K(double source_K) {
    const double before_K = std::exchange(m->source_K, source_K > 0.0 ? source_K : kUnknown);
    if (m->source_K != before_K && !(std::isnan(m->source_K) && std::isnan(before_K)))
        requestFrame();
}

void SceneView::setSourceHeat(std::optional<HeatState> heat) {
    if (std::exchange(m->heat, heat) != heat)
        requestFrame();
}

void SceneView::setTemperatures(const std::vector<double>& temperatures_K) {
    bool isOther = false;
    for (std::size_t i = 0; i < m->temperatures_K.size(); ++i) {
        const double told_K = i < temperatures_K.size() ? temperatures_K[i] : kUnknown;
        const double t_K = std::isfinite(told_K) && told_K > 0.0 ? told_K : kUnknown;
        const double before_K = std::exchange(m->temperatures_K[i], t_K);
        isOther |= t_K != before_K && !(std::isnan(t_K) && std::isnan(before_K));
    }
    if (isOther)
        requestFrame();
}

void SceneView::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m->unit)
        return;
    m->unit = unit;
    m->recolour = true;
    requestFrame();
}

void SceneView::viewAlongMinusZ() {
    m->preset = ViewPreset::AlongMinusZ;
    if (m->view != nullptr)
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
    fit();
}

void SceneView::viewAlongX() {
    m->preset = ViewPreset::AlongX;
    if (m->view != nullptr)
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
    fit();
}

void SceneView::viewIsometric() {
    m->preset = ViewPreset::Isometric;
    if (m->view != nullptr)
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
    fit();
}

void SceneView::fit() {
    m->cameraIsPersons = false;
    if (m->view == nullptr || !m->hasExperiment)
        return;
    const QSizeF size = m->view->size();
    fitCamera(*m->view->renderer().GetActiveCamera(), m->frame, size, SceneOverlay::margins(font(), size));
    requestFrame();
}

void SceneView::prepareFrame() {
    const bool dark = isDark(palette());
    if (!m->cameraIsPersons)
        fitCamera(*m->view->renderer().GetActiveCamera(), m->frame, m->view->size(),
                  SceneOverlay::margins(font(), m->view->size()));
    m->props->setLineScale(
        m->view->devicePixelRatioF() *
        std::clamp(std::min(m->view->width() / 800.0, m->view->height() / 560.0), 0.5, 1.0));
    if (m->rebuild || m->recolour)
        m->props->setColours(sceneColours(palette()));
    if (m->hasExperiment) {
        if (m->rebuild)
            m->props->build(m->experiment, m->frame);
        const NiceRange range = m->range();
        const bool newRange = range.min != m->shownRange.min || range.max != m->shownRange.max;
        m->shownRange = range;
        vtkCamera* camera = m->view->renderer().GetActiveCamera();
        const Eigen::Vector3d direction(camera->GetDirectionOfProjection());
        const double metresPerPixel = 2.0 * camera->GetParallelScale() / std::max(1, m->view->height());
        m->props->setSourceWarmth(m->warmth());
        m->props->setSourceHeat(m->heat);
        m->props->setViewDirection(direction);
        m->props->setPoses(m->X_RE, m->X_RS, -kLift_px * metresPerPixel * direction);
        const bool allTrails = m->rebuild || m->recolour || newRange || m->trailsGrew;
        for (std::size_t i = 0; i < m->trails.size(); ++i) {
            m->props->setObjectColour(i, m->colourOf(m->temperatures_K[i], dark));
            if (allTrails)
                m->props->setTrail(i, m->trails[i],
                                   [this, dark](double t_K) { return m->colourOf(t_K, dark); });
        }
        m->trailsGrew = false;
        if (m->rebuild || m->isPlanNew) {
            m->paths_R.clear();
            for (std::size_t i = 0; i < m->X_EO.size(); ++i) {
                m->paths_R.push_back(m->plannedPathOf(i));
                m->props->setPlan(i, m->paths_R.back(), m->planArrives);
            }
        }
        m->isPlanNew = false;
        m->props->setPlansDim(std::ranges::any_of(m->trails, [](const Trail& t) { return !t.empty(); }));
    }
    m->content = m->overlayContent(dark);
    m->rebuild = m->recolour = false;
}

void SceneView::changeEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
        m->recolour = true;
        requestFrame();
        break;
    case QEvent::LanguageChange:
    case QEvent::LocaleChange:
        if (m->view != nullptr)
            m->view->setAccessibleName(tr("3-D scene"));
        if (m->notice != nullptr)
            m->notice->setText(tr(
                "The 3-D scene needs OpenGL 3.2, which this display does not offer. Everything else works."));
        requestFrame();
        break;
    default:
        break;
    }
    QWidget::changeEvent(event);
}

void SceneView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    requestFrame();
}

} // namespace bask
