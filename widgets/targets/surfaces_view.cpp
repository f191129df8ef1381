#include "widgets/targets/surfaces_view.h"

#include "engine/base/message_code.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/display.h"
#include "widgets/common/verdict_words.h"
#include "widgets/scene/target_scene.h"
#include "widgets/targets/cut_controls.h"
#include "widgets/targets/export_bar.h"
#include "widgets/targets/held_controls.h"
#include "widgets/targets/picked_panel.h"
#include "widgets/targets/picture_dialog.h"
#include "widgets/targets/surface_geometry.h"
#include "widgets/targets/view_bar.h"

#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {
SurfacesView::SurfacesView(QWidget* parent)
    : QWidget(parent), m_scene(new TargetScene(this)), m_player(new SweepPlayer(*m_scene, this)),
      m_space(new QComboBox(this)), m_views(new ViewBar(this)), m_heldControls(new HeldControls(this)),
      m_exportBar(new ExportBar(this)), m_cut(new CutControls(this)), m_picked(new PickedPanel(this)) {
    m_scene->setObjectName("targetScene");
    m_space->setObjectName("surfaceSpace");
    m_space->addItems({{}, {}, {}}); // named by retranslate()
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 0, 8, 0);
    layout->addWidget(m_space);
    layout->addWidget(m_views);
    layout->addWidget(m_scene, 1);
    for (QWidget* row : std::initializer_list<QWidget*>{m_heldControls, m_exportBar, m_cut, m_picked})
        layout->addWidget(row);
    connectControls();
    retranslate();
}

void SurfacesView::connectControls() {
    connect(m_space, &QComboBox::currentIndexChanged, this, &SurfacesView::changeSpace);
    connect(m_views, &ViewBar::topWanted, m_scene, &TargetScene::viewAlongMinusZ);
    connect(m_views, &ViewBar::sideWanted, m_scene, &TargetScene::viewAlongX);
    connect(m_views, &ViewBar::isometricWanted, m_scene, &TargetScene::viewIsometric);
    connect(m_views, &ViewBar::pictureWanted, this, [this] {
        if (const auto order = PictureDialog::askPicture(m_scene->size(), this))
            savePicture(order->path, order->size_px);
    });
    connect(m_views, &ViewBar::animationWanted, this, [this] {
        if (const auto order = PictureDialog::askAnimation(m_scene->size(), this))
            saveAnimation(order->path, order->size_px);
    });
    connect(m_heldControls, &HeldControls::fixedManually, this, &SurfacesView::fix);
    connect(m_heldControls, &HeldControls::playWanted, this, &SurfacesView::play);
    connect(m_heldControls, &HeldControls::poseWanted, this, [this] {
        endPlay();
        for (const Coordinate k : fixedCoordinates(subset(), m_experiment.robot))
            m_fixedManually.at(k).reset();
        m_scene->clearPick();
        compute();
    });
    connect(m_cut, &CutControls::changed, this, &SurfacesView::showCut);
    connect(m_exportBar, &ExportBar::cancelled, this, [this] {
        m_player->stop();
        endExport();
    });
    connect(m_player, &SweepPlayer::progressed, m_exportBar, &ExportBar::showProgress);
    connect(m_player, &SweepPlayer::shown, this, [this](const Vector6d& fixed) {
        m_behind = false;
        showStale();
        m_heldControls->setFixed(fixed, true);
    });
    connect(m_player, &SweepPlayer::saved, this, &SurfacesView::tellAnimation);
    connect(m_player, &SweepPlayer::failed, this, [this](const Error& error) {
        emit problem(messageText(error.message));
        compute();
    });
    connect(m_scene, &TargetScene::posePicked, this, [this](const Vector6d& pose, const QStringList& words) {
        Experiment started = m_experiment;
        started.start = pose;
        const auto valid = validate(started);
        m_picked->setPicked(pose, QStringList(poseText(pose, m_experiment.robot)) + words,
                            valid ? QString() : messageText(valid.error().message));
    });
    connect(m_scene, &TargetScene::pickDropped, m_picked, &PickedPanel::clear);
    connect(m_picked, &PickedPanel::startWanted, this, &SurfacesView::startWanted);
}

void SurfacesView::setExperiment(const Experiment& experiment) {
    const bool other = isOtherGeometry(experiment, m_experiment);
    m_experiment = experiment;
    if (other) {
        if (m_player->isSaving())
            emit problem(tr("The animation is not whole: the experiment was changed while it was saved."));
        m_player->stop(); // its frames are of the geometry before
        m_exportBar->hide();
        m_job.forget(); // and so are its fields
        m_fields.reset();
        m_fixedManually.fill({});
        m_verdict.reset();
        m_scene->clearPick();
    }
    if (!m_player->isSaving()) // else once it is done
        m_scene->setExperiment(experiment);
    QStringList names;
    for (const ObjectSpec& object : experiment.objects)
        names << QString::fromStdString(object.name);
    m_cut->setObjects(names);
    showControls();
    showCut();
}

void SurfacesView::setVerdict(const JointVerdict& verdict) {
    m_verdict = verdict;
    m_stale = false;
    m_behind = true;
    if (!m_player->isSaving())
        showVerdict();
}

void SurfacesView::showVerdict() {
    showStale();
    if (m_verdict && m_verdict->anyPose)
        m_scene->setVerdictPoint(SceneVerdict{m_verdict->pose, m_verdict->feasible,
                                              m_verdict->feasible ? std::nullopt : surfaceGap(*m_verdict)});
    else
        m_scene->setVerdictPoint(std::nullopt);
    if (m_player->isPlaying())
        play(true);
    else
        compute();
}

void SurfacesView::setStale(bool stale) {
    m_stale = stale;
    showStale();
    showControls();
}

void SurfacesView::showStale() {
    m_scene->setStale((m_stale || m_behind) && !m_player->isSaving());
}

void SurfacesView::setTemperatureUnit(TemperatureUnit unit) {
    m_scene->setTemperatureUnit(unit);
    m_scene->clearPick(); // its words are in the other one
}

void SurfacesView::setStartable(bool startable, const QString& why) {
    m_picked->setStartable(startable, why);
}

PoseSubset SurfacesView::subset() const {
    return static_cast<PoseSubset>(m_space->currentIndex());
}

bool SurfacesView::ready() const {
    return m_verdict && !m_experiment.objects.empty();
}

/// The verdict's; without one the start.
Vector6d SurfacesView::foundPose() const {
    return m_verdict && m_verdict->anyPose ? m_verdict->pose : m_experiment.start;
}

/// The held three; the others are 0.
Vector6d SurfacesView::fixedPose() const {
    Vector6d fixed = foundPose();
    for (const Coordinate k : fixedCoordinates(subset(), m_experiment.robot))
        fixed[k] = m_fixedManually.at(k).value_or(fixed[k]);
    fixed.segment<3>(subset() == PoseSubset::Rotation ? kThetaX : kX).setZero();
    return fixed;
}

void SurfacesView::fix(int coordinate, double value) {
    endPlay();
    m_fixedManually.at(static_cast<std::size_t>(coordinate)) = value;
    m_scene->clearPick();
    compute();
}

void SurfacesView::changeSpace() {
    endPlay();
    m_job.forget();
    m_fields.reset();
    m_behind = true;
    showStale();
    m_scene->clearPick();
    showCut();
    compute();
}

void SurfacesView::compute() {
    computeOn(SurfaceGrid::Coarse);
}

/// On the coarse grid only what takes long on the fine one.
void SurfacesView::computeOn(SurfaceGrid grid) {
    showControls();
    if (!ready() || !isVisible() || m_player->isSaving())
        return;
    const Vector6d fixed = fixedPose();
    const bool same =
        m_fields && m_fieldsFixed == fixed && m_fieldsSubset == subset() && m_fieldsGrid == SurfaceGrid::Fine;
    m_job.run(
        [experiment = m_experiment, fixed, subset = subset(), known = same ? m_fields : nullptr, grid,
         viewFactors = neededViewFactors(*m_verdict)](const std::stop_token& stop) {
            Answer answer{known, fixed, subset, SurfaceGrid::Fine, {}, {}};
            if (!known) {
                if (grid == SurfaceGrid::Coarse && mayShade(experiment))
                    answer.grid = SurfaceGrid::Coarse;
                auto fields = targetFields(surfaceGeometry(experiment, subset, fixed, answer.grid), stop);
                if (!fields) {
                    answer.problem = fields.error();
                    return answer;
                }
                answer.fields = std::make_shared<const Fields>(std::move(*fields));
            }
            if (auto surfaces = targetSurfaces(*answer.fields, viewFactors, stop))
                answer.surfaces = *std::move(surfaces);
            return answer;
        },
        [this](Answer answer) { take(std::move(answer)); });
}

void SurfacesView::take(Answer answer) {
    if (answer.problem.code() != MessageCode::None)
        emit problem(messageText(answer.problem.message));
    const bool isFirstLook = answer.grid == SurfaceGrid::Coarse && answer.problem.code() == MessageCode::None;
    m_fields = std::move(answer.fields);
    m_fieldsFixed = answer.fixed;
    m_fieldsSubset = answer.subset;
    m_fieldsGrid = answer.grid;
    m_scene->setSurfaces(std::move(answer.surfaces), answer.fixed, answer.subset);
    m_behind = isFirstLook;
    showStale();
    showCut();
    if (isFirstLook)
        computeOn(SurfaceGrid::Fine);
}

std::optional<Sweep> SurfacesView::sweep(SurfaceGrid grid) const {
    const auto varied = sweptCoordinate(subset(), m_experiment.robot);
    if (!ready() || !varied)
        return std::nullopt;
    return Sweep{surfaceGeometry(m_experiment, subset(), fixedPose(), grid), subset(), *varied,
                 sweptValues(m_experiment.robot, *varied, Sweep::kFrames), neededViewFactors(*m_verdict)};
}

void SurfacesView::play(bool on) {
    if (!on)
        return endPlay();
    auto frames = sweep(mayShade(m_experiment) ? SurfaceGrid::Coarse : SurfaceGrid::Fine);
    if (frames && isVisible() && !m_player->isSaving()) {
        m_job.forget();
        m_scene->clearPick();
        m_player->play(*std::move(frames));
    }
    showCut();
    showControls();
}

/// Back to what was held before.
void SurfacesView::endPlay() {
    if (!m_player->isPlaying())
        return;
    m_player->stop();
    compute();
}

void SurfacesView::endExport() {
    m_exportBar->hide();
    m_scene->setExperiment(m_experiment); // it kept the one before while pictures were made
    showVerdict();
}

void SurfacesView::showCut() {
    const auto object = m_cut->object();
    const bool known = m_fields && m_fieldsSubset == subset() && object &&
                       static_cast<std::size_t>(*object) < m_fields->size();
    const Vector6d pose = foundPose();
    Eigen::Vector3d home = pose.segment<3>(subset() == PoseSubset::Rotation ? kThetaX : kX);
    if (known && subset() == PoseSubset::OwnTranslation)
        home += centreOffset(
            poseFromCoordinates(m_experiment.objects[static_cast<std::size_t>(*object)].mounting),
            fixedPose());
    m_cut->setAxes(known ? m_fields->at(static_cast<std::size_t>(*object))->axes
                         : surfaceAxes(subset(), m_experiment.robot,
                                       subset() == PoseSubset::Rotation ? kSurfaceStep_rad : kSurfaceStep_m),
                   home);
    const auto choice = m_cut->choice();
    if (!choice || !known || m_player->isPlaying())
        return m_scene->setCut(std::nullopt);
    m_scene->setCut(SceneCut{m_fields->at(static_cast<std::size_t>(choice->object)), choice->object,
                             choice->axis, choice->position, choice->asTemperature});
}

void SurfacesView::savePicture(const QString& path, QSize size) {
    if (const auto saved = m_scene->saveImage(path, size); !saved)
        emit problem(QStringLiteral("%1: %2").arg(path, messageText(saved.error().message)));
    else
        emit exported(tr("Picture saved: %1").arg(QDir::toNativeSeparators(path)), {path});
}

void SurfacesView::saveAnimation(const QString& folder, QSize size) {
    auto frames = sweep(SurfaceGrid::Fine);
    if (!frames)
        return;
    endPlay();
    m_job.forget();
    m_scene->clearPick();
    m_scene->setCut(std::nullopt);
    m_exportFolder = folder;
    m_player->save(*std::move(frames), folder, size);
    showControls();
}

void SurfacesView::tellAnimation(const Error& error) {
    endExport();
    if (error.code() == MessageCode::None)
        emit exported(tr("Animation saved in %1: frame-1.png to frame-9.png, and all in panels.png")
                          .arg(QDir::toNativeSeparators(m_exportFolder)),
                      {SceneSequence::sheetPath(m_exportFolder)});
    else
        emit problem(
            QStringLiteral("%1: %2").arg(QString::fromStdString(error.where), messageText(error.message)));
}

void SurfacesView::showControls() {
    const bool saving = m_player->isSaving();
    const std::vector<Coordinate> fixed = fixedCoordinates(subset(), m_experiment.robot);
    m_heldControls->setCoordinates(saving ? std::vector<Coordinate>() : fixed, m_experiment.robot);
    if (!m_player->isPlaying())
        m_heldControls->setFixed(fixedPose(), std::ranges::any_of(fixed, [this](Coordinate k) {
                                     return m_fixedManually.at(k).has_value();
                                 }));
    m_heldControls->setPlaying(m_player->isPlaying());
    m_space->setEnabled(!saving);
    m_cut->setEnabled(!saving && !m_player->isPlaying());
    m_views->setEnabled(!saving); // all pictures from one direction
    m_scene->setAttribute(Qt::WA_TransparentForMouseEvents, saving);
    m_views->setExports(!saving && m_scene->hasPicture(),
                        !saving && m_scene->hasPicture() && ready() && !fixed.empty() && !m_stale);
}

void SurfacesView::retranslate() {
    const std::array<QString, 3> spaces{tr("End-effector positions"),
                                        tr("Each object's own positions (as in the paper)"),
                                        tr("End-effector angles")};
    for (int i = 0; i < 3; ++i)
        m_space->setItemText(i, spaces.at(static_cast<std::size_t>(i)));
    m_space->setAccessibleName(tr("What the surfaces are drawn over"));
    m_space->setToolTip(tr("What the surfaces are drawn over. On its surface an object holds its target."));
    m_scene->setAccessibleName(
        tr("3-D scene: where the end-effector may be for each object to hold its target"));
    m_scene->clearPick(); // its words are in the language before
}

void SurfacesView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    compute();
}

void SurfacesView::hideEvent(QHideEvent* event) {
    endPlay();
    showControls();
    QWidget::hideEvent(event);
}

void SurfacesView::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
