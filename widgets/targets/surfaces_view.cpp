#include "widgets/targets/surfaces_view.h"

#include "engine/base/units.h"
#include "widgets/common/display.h"
#include "widgets/scene/target_scene.h"
#include "widgets/targets/verdict_text.h"

#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kStepsPerDegree = 2; // of the slider

TargetGeometry geometryOf(const Experiment& experiment, const Vector6d& held) {
    TargetGeometry geometry{.source = RadiatingContour(experiment.source.shape),
                            .X_RS = poseFromCoordinates(experiment.source.pose),
                            .objects = {},
                            .axes = surfaceAxes(PoseSubset::Translation, experiment.robot, kSurfaceStep_m),
                            .held = held,
                            .clearance_m = experiment.robot.clearance_m};
    for (const ObjectSpec& object : experiment.objects)
        geometry.objects.push_back({RadiatingContour(object.shape), poseFromCoordinates(object.mounting)});
    return geometry;
}

/// The two of the surfaces' points that are farthest apart.
std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> gapOf(const JointVerdict& verdict) {
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> widest;
    for (const Eigen::Vector3d& a : verdict.surfacePoints)
        for (const Eigen::Vector3d& b : verdict.surfacePoints)
            if (!widest || (a - b).norm() > (widest->first - widest->second).norm())
                widest.emplace(a, b);
    return widest;
}

/// Whether the surfaces of two experiments differ by more than their values.
bool isOtherGeometry(const Experiment& a, const Experiment& b) {
    const auto differ = [](const ObjectSpec& x, const ObjectSpec& y) {
        return x.shape != y.shape || x.mounting != y.mounting;
    };
    if (a.source.shape != b.source.shape || a.source.pose != b.source.pose || a.robot != b.robot ||
        a.objects.size() != b.objects.size())
        return true;
    for (std::size_t i = 0; i < a.objects.size(); ++i)
        if (differ(a.objects[i], b.objects[i]))
            return true;
    return false;
}

} // namespace

SurfacesView::SurfacesView(QWidget* parent)
    : QWidget(parent), m_scene(new TargetScene(this)), m_heldLabel(new QLabel(this)),
      m_heldAngle(new QSlider(Qt::Horizontal, this)), m_heldAtPose(new QPushButton(this)),
      m_top(new QToolButton(this)), m_side(new QToolButton(this)), m_isometric(new QToolButton(this)),
      m_save(new QPushButton(this)), m_cutObject(new QComboBox(this)), m_cutAxis(new QComboBox(this)),
      m_cutPlace(new QSlider(Qt::Horizontal, this)), m_pickedWords(new QLabel(this)),
      m_startHere(new QPushButton(this)) {
    m_scene->setObjectName("targetScene");
    m_heldAngle->setObjectName("heldAngle");
    m_heldAtPose->setObjectName("heldAtPose");
    m_top->setObjectName("viewTop");
    m_side->setObjectName("viewSide");
    m_isometric->setObjectName("viewIsometric");
    m_save->setObjectName("savePicture");
    m_cutObject->setObjectName("cutObject");
    m_cutAxis->setObjectName("cutAxis");
    m_cutPlace->setObjectName("cutPlace");
    m_cutAxis->addItems({"x", "y", "z"});
    m_cutAxis->setCurrentIndex(kY);
    m_pickedWords->setObjectName("picked");
    m_startHere->setObjectName("startHere");
    m_pickedWords->setWordWrap(true);
    m_heldLabel->setBuddy(m_heldAngle);

    auto* views = new QHBoxLayout;
    for (QToolButton* button : {m_top, m_side, m_isometric}) {
        button->setAutoRaise(true);
        views->addWidget(button);
    }
    views->addStretch(1);
    views->addWidget(m_save);
    auto* angle = new QHBoxLayout;
    angle->addWidget(m_heldLabel);
    angle->addWidget(m_heldAngle, 1);
    angle->addWidget(m_heldAtPose);
    auto* cut = new QHBoxLayout;
    cut->addWidget(m_cutObject);
    cut->addWidget(m_cutAxis);
    cut->addWidget(m_cutPlace, 1);
    auto* picked = new QHBoxLayout;
    picked->addWidget(m_pickedWords, 1);
    picked->addWidget(m_startHere, 0, Qt::AlignTop);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(views);
    layout->addWidget(m_scene, 1);
    layout->addLayout(angle);
    layout->addLayout(cut);
    layout->addLayout(picked);

    connect(m_top, &QToolButton::clicked, m_scene, &TargetScene::viewAlongMinusZ);
    connect(m_side, &QToolButton::clicked, m_scene, &TargetScene::viewAlongX);
    connect(m_isometric, &QToolButton::clicked, m_scene, &TargetScene::viewIsometric);
    connect(m_save, &QPushButton::clicked, this, &SurfacesView::savePicture);
    connect(m_heldAngle, &QSlider::valueChanged, this,
            [this](int value) { hold(radFromDeg(static_cast<double>(value) / kStepsPerDegree)); });
    connect(m_cutObject, &QComboBox::currentIndexChanged, this, &SurfacesView::showCut);
    connect(m_cutAxis, &QComboBox::currentIndexChanged, this, [this] {
        placeCut();
        showCut();
    });
    connect(m_cutPlace, &QSlider::valueChanged, this, &SurfacesView::showCut);
    connect(m_heldAtPose, &QPushButton::clicked, this, [this] {
        m_held_rad.reset();
        showControls();
        compute();
    });
    connect(m_scene, &TargetScene::posePicked, this, [this](const Vector6d& pose, const QStringList& words) {
        m_picked = pose;
        m_pickedWords->setText(poseText(pose, m_experiment.robot) + QLatin1Char('\n') +
                               words.join(QLatin1Char('\n')));
        showControls();
    });
    connect(m_startHere, &QPushButton::clicked, this, [this] {
        if (m_picked)
            emit startWanted(*m_picked);
    });
    retranslate();
}

void SurfacesView::setExperiment(const Experiment& experiment) {
    const bool other = isOtherGeometry(experiment, m_experiment);
    m_experiment = experiment;
    m_angle = -1;
    for (const int k : {kThetaX, kThetaY, kThetaZ})
        if (m_angle < 0 && experiment.robot.free[static_cast<std::size_t>(k)])
            m_angle = k;
    if (other) {
        m_job.forget(); // its fields are of the geometry before
        m_fields.reset();
        m_held_rad.reset();
        m_verdict.reset();
        m_picked.reset();
        m_pickedWords->clear();
    }
    m_scene->setExperiment(experiment);
    if (other)
        placeCut();
    retranslate();
    showCut();
}

void SurfacesView::setVerdict(const JointVerdict& verdict) {
    m_verdict = verdict;
    m_scene->setStale(false);
    if (verdict.anyPose)
        m_scene->setVerdictPoint(
            SceneVerdict{verdict.pose, verdict.feasible, verdict.feasible ? std::nullopt : gapOf(verdict)});
    else
        m_scene->setVerdictPoint(std::nullopt);
    showControls();
    compute();
}

void SurfacesView::setStale(bool stale) {
    m_scene->setStale(stale);
}

void SurfacesView::setTemperatureUnit(TemperatureUnit unit) {
    m_scene->setTemperatureUnit(unit);
}

void SurfacesView::setEditable(bool editable) {
    m_editable = editable;
    showControls();
}

Vector6d SurfacesView::heldPose() const {
    Vector6d held = m_verdict && m_verdict->anyPose ? m_verdict->pose : m_experiment.start;
    if (m_angle >= 0 && m_held_rad)
        held[m_angle] = *m_held_rad;
    held.head<3>().setZero();
    return held;
}

void SurfacesView::hold(double angle_rad) {
    m_held_rad = angle_rad;
    showControls();
    compute();
}

void SurfacesView::compute() {
    if (!m_verdict || m_experiment.objects.empty() || !isVisible())
        return;
    std::vector<double> viewFactors;
    for (const TargetVerdict& own : m_verdict->conditions1)
        viewFactors.push_back(own.neededViewFactor);
    const Vector6d held = heldPose();
    const auto known = m_fields && m_fieldsHeld == held ? m_fields : nullptr;
    m_job.run(
        [experiment = m_experiment, held, known, viewFactors](const std::stop_token& stop) {
            Answer answer{known, held, {}};
            if (!known) {
                auto fields = targetFields(geometryOf(experiment, held), stop);
                if (!fields)
                    return answer;
                answer.fields = std::make_shared<const Fields>(std::move(*fields));
            }
            answer.surfaces = targetSurfaces(*answer.fields, viewFactors, stop);
            return answer;
        },
        [this](Answer answer) { take(std::move(answer)); });
}

void SurfacesView::take(Answer answer) {
    if (!answer.surfaces)
        return;
    m_fields = std::move(answer.fields);
    m_fieldsHeld = answer.held;
    m_scene->setSurfaces(std::move(*answer.surfaces), answer.held);
    showCut();
}

/// The slider over the workspace along the axis, the cut through its middle.
void SurfacesView::placeCut() {
    constexpr double kMmPerM = 1000.0;
    const QSignalBlocker quiet(m_cutPlace);
    const int axis = m_cutAxis->currentIndex();
    const double low = m_experiment.robot.lower[axis], high = m_experiment.robot.upper[axis];
    m_cutPlace->setRange(static_cast<int>(std::lround(low * kMmPerM)),
                         static_cast<int>(std::lround(high * kMmPerM)));
    m_cutPlace->setValue(static_cast<int>(std::lround(0.5 * (low + high) * kMmPerM)));
}

void SurfacesView::showCut() {
    const int object = m_cutObject->currentIndex() - 1;
    m_cutAxis->setVisible(object >= 0);
    m_cutPlace->setVisible(object >= 0);
    if (object < 0 || !m_fields || static_cast<std::size_t>(object) >= m_fields->size())
        return m_scene->setCut(std::nullopt);
    m_scene->setCut(SceneCut{(*m_fields)[static_cast<std::size_t>(object)], object,
                             static_cast<Coordinate>(m_cutAxis->currentIndex()), m_cutPlace->value() * 1e-3,
                             true});
}

void SurfacesView::savePicture() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Save the picture"), QStringLiteral("targets.png"), "*.png");
    if (path.isEmpty())
        return;
    if (const auto saved = m_scene->saveImage(path, 2 * m_scene->size()); !saved)
        emit problem(QStringLiteral("%1: %2").arg(path, messageText(saved.error().message)));
}

void SurfacesView::showControls() {
    const bool turns = m_angle >= 0;
    for (QWidget* widget : std::initializer_list<QWidget*>{m_heldLabel, m_heldAngle, m_heldAtPose})
        widget->setVisible(turns);
    if (turns) {
        const QSignalBlocker quiet(m_heldAngle);
        const auto steps = [](double angle_rad) {
            return static_cast<int>(std::lround(degFromRad(angle_rad) * kStepsPerDegree));
        };
        const double angle_rad = heldPose()[m_angle];
        m_heldAngle->setRange(steps(m_experiment.robot.lower[m_angle]),
                              steps(m_experiment.robot.upper[m_angle]));
        m_heldAngle->setValue(steps(angle_rad));
        m_heldLabel->setText(tr("&Surfaces at %1").arg(coordinateText(m_angle, angle_rad)));
    }
    m_heldAtPose->setEnabled(m_held_rad.has_value());
    m_startHere->setVisible(m_picked.has_value());
    m_startHere->setEnabled(m_editable);
}

void SurfacesView::retranslate() {
    m_top->setText(tr("Top"));
    m_side->setText(tr("Side"));
    m_isometric->setText(tr("Isometric"));
    for (QToolButton* button : {m_top, m_side, m_isometric})
        button->setAccessibleName(tr("View: %1").arg(button->text()));
    m_save->setText(tr("Save picture\u2026"));
    const int cut = std::max(0, m_cutObject->currentIndex());
    const QSignalBlocker quiet(m_cutObject);
    m_cutObject->clear();
    m_cutObject->addItem(tr("No cut"));
    for (const ObjectSpec& object : m_experiment.objects)
        m_cutObject->addItem(tr("Cut: %1").arg(QString::fromStdString(object.name)));
    m_cutObject->setCurrentIndex(cut < m_cutObject->count() ? cut : 0);
    m_cutObject->setAccessibleName(tr("Plane of steady temperatures of an object"));
    m_cutObject->setToolTip(tr(
        "A plane through the workspace in the colours of the temperature that the object settles at there."));
    m_cutAxis->setAccessibleName(tr("Axis that the plane is square to"));
    m_cutPlace->setAccessibleName(tr("Place of the plane along its axis"));
    m_heldAngle->setAccessibleName(tr("Angle at which the surfaces are drawn"));
    m_heldAtPose->setText(tr("As at the pose"));
    m_heldAtPose->setToolTip(tr("Draw the surfaces at the angle of the pose that was found."));
    m_startHere->setText(tr("Start runs here"));
    m_scene->setAccessibleName(
        tr("3-D scene: where the end-effector may be for each object to hold its target"));
    showControls();
}

void SurfacesView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    compute();
}

void SurfacesView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
