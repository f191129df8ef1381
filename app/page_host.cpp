#include "app/page_host.h"

#include "app/actions.h"
#include "app/error_text.h"
#include "engine/shape/outline_formats.h"
#include "widgets/calibrate/calibrate_page.h"
#include "widgets/common/countdown_bar.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/message_bar.h"
#include "widgets/common/scrolling.h"
#include "widgets/common/verdict_words.h"
#include "widgets/objects/objects_page.h"
#include "widgets/review/comparison_view.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/review_page.h"
#include "widgets/rig/rig_page.h"
#include "widgets/rig/way_up_question.h"
#include "widgets/run/run_page.h"
#include "widgets/targets/targets_page.h"

#include <QEvent>
#include <QFileInfo>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace bask {

PageHost::PageHost(Document& document, SessionActions& files, QWidget* parent)
    : QWidget(parent), m_document(document), m_files(files), m_countdown(new CountdownBar(this)),
      m_cutOff(new MessageBar(this)), m_recipe(new MessageBar(this)), m_question(new MessageBar(this)),
      m_coach(new MessageBar(this)), m_bar(new MessageBar(this)), m_pages(new QStackedWidget(this)),
      m_rig(new RigPage), m_objects(new ObjectsPage), m_calibrate(new CalibratePage),
      m_targets(new TargetsPage), m_run(new RunPage), m_review(new ReviewPage),
      m_reviewDesk(*m_review, document, files), m_messages(*m_bar) {
    m_cutOff->setObjectName(QStringLiteral("cutOffBar"));
    m_question->setObjectName(QStringLiteral("questionBar"));
    m_recipe->setObjectName(QStringLiteral("recipeBar"));
    m_coach->setObjectName(QStringLiteral("coachBar"));
    m_bar->setObjectName(QStringLiteral("messageBar"));
    m_pages->setObjectName(QStringLiteral("pages"));
    for (QWidget* page :
         std::initializer_list<QWidget*>{m_rig, m_objects, m_calibrate, m_targets, m_run, m_review})
        m_pages->addWidget(scrolled(page));
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(m_pages);
    m_place = new FloatingPlace({m_countdown, m_bar, m_question, m_cutOff, m_coach, m_recipe}, *this);
    connectRig();
    connectObjects();
    connectCalibrate();
    connectDocument();
    connectJudge();
    connectForecast();
    connectReview();
    connect(m_targets, &TargetsPage::targetsEdited, this, [this](const std::vector<double>& targets_K) {
        if (const auto set = m_document.setTargets(targets_K); !set) {
            showProblem(sentence(set.error()));
            m_targets->setExperiment(m_document.experiment());
        }
    });
    connect(m_run, &RunPage::controllerApplied, this, [this](const ControllerSettings& settings) {
        if (const auto set = m_document.setController(settings); !set)
            showProblem(sentence(set.error()));
    });
    connect(m_run, &RunPage::sensorConfirmed, this, &PageHost::askConfirm);
    connect(m_run, &RunPage::noteAdded, this,
            [this](const QString& text) { emit commandIssued(AddNote{text.toStdString()}); });
    connect(m_run, &RunPage::thermalPictureWatched, this, [this](bool isWatched) {
        m_isThermalOnRun = isWatched;
        watchThermal();
    });
    connect(m_run, &RunPage::simulationSpeedChosen, this,
            [this](double factor) { emit commandIssued(SetSimulationSpeed{factor}); });
    connect(&m_document, &Document::changed, this, [this] { m_messages.dropOfEdit(); });
    connect(&m_files, &SessionActions::recipeChosen, m_bar, &MessageBar::clear);
    connect(&m_files, &SessionActions::problem, this, &PageHost::showProblem);
    connect(&m_files, &SessionActions::told, this, &PageHost::showNote);
    connectExports();
}

/// What was written can be opened from its message.
void PageHost::connectExports() {
    connect(&m_files, &SessionActions::exported, this, &PageHost::showExported);
    connect(m_targets, &TargetsPage::exported, this, &PageHost::showExported);
    connect(m_calibrate, &CalibratePage::exported, this, &PageHost::showExported);
    connect(m_bar, &MessageBar::actionClicked, this, [this] {
        if (m_exported.size() == 1 && isSessionFile(m_exported.front())) // its program is this one
            m_files.open(m_exported.front());
        else
            m_desktop.open(m_exported);
    });
    connect(m_bar, &MessageBar::otherClicked, this, [this] { m_desktop.showInFolder(m_exported); });
    connect(&m_desktop, &DesktopFiles::problem, this, &PageHost::showProblem);
}

void PageHost::showExported(const QString& sentence, const QStringList& files) {
    m_exported = files;
    m_messages.showWritten(sentence, tr("Open"), tr("Show in folder"));
}

void PageHost::connectReview() {
    connect(&m_reviewDesk, &ReviewDesk::opening, this, [this] { m_messages.clear(); });
    connect(&m_reviewDesk, &ReviewDesk::opened, this, [this] { show(Page::Review); });
    connect(&m_reviewDesk, &ReviewDesk::problem, this, &PageHost::showProblem);
    connect(&m_reviewDesk, &ReviewDesk::told, this, &PageHost::showNote);
    connect(m_review->replay()->comparison(), &ComparisonView::copied, this,
            [this](const QString& sentence) { m_messages.showBriefly(sentence); });
    connect(&m_reviewDesk, &ReviewDesk::toldAside, this, &PageHost::toldAside);
    connect(&m_reviewDesk, &ReviewDesk::manualRequested, this, &PageHost::manualRequested);
}

void PageHost::connectRig() {
    connect(m_rig, &RigPage::commandIssued, this, [this](const Command& command) {
        m_messages.dropRefusal();
        emit commandIssued(command);
    });
    connect(m_rig, &RigPage::homeRequested, this, &PageHost::homeRequested);
    connect(m_rig, &RigPage::experimentEdited, this, [this](const Experiment& experiment) {
        if (const auto edited = m_document.edit(experiment, Page::Rig); !edited)
            m_rig->showError(sentence(edited.error()));
    });
    connect(m_rig, &RigPage::openRigRequested, &m_files, &SessionActions::openRig);
    connect(m_rig, &RigPage::saveRigRequested, &m_files, &SessionActions::saveRig);
    connect(&m_files, &SessionActions::rigRead, this, [this](const RigSpec& rig) {
        m_rig->useRig(rig);
        show(Page::Rig);
    });
}

void PageHost::connectObjects() {
    connect(m_objects, &ObjectsPage::experimentEdited, this, [this](Experiment experiment) {
        const Experiment before = m_document.experiment();
        experiment.rig = before.rig;
        if (experiment.rig && experiment.rig->thermometer)
            keepChannels(before.objects, experiment.objects, experiment.rig->thermometer->channels);
        if (const auto edited = m_document.edit(experiment, Page::Objects); !edited) {
            m_objects->setExperiment(before);
            m_objects->showError(sentence(edited.error()));
        }
    });
}

void PageHost::connectCalibrate() {
    connect(m_calibrate, &CalibratePage::watchWanted, this,
            [this](bool show, const std::optional<Board>& board) {
                emit commandIssued(WatchCamera{show, board});
            });
    connect(m_calibrate, &CalibratePage::cameraWanted, this,
            [this](const QString& name) { emit commandIssued(ChooseCamera{name.toStdString()}); });
    connect(m_calibrate, &CalibratePage::moveWanted, this, [this](const Vector6d& goal) {
        m_messages.dropRefusal();
        emit commandIssued(MoveTo{goal});
    });
    connect(m_calibrate, &CalibratePage::thermalWatchWanted, this,
            [this](bool show, const std::optional<Board>& board) {
                m_thermalOnCalibrate = {show, board};
                watchThermal();
            });
    connect(m_calibrate, &CalibratePage::holdWanted, this, [this] { emit commandIssued(Hold{}); });
    const auto edit = [this](const Experiment& changed) {
        if (const auto edited = m_document.edit(changed, Page::Calibrate); !edited)
            showProblem(sentence(edited.error()));
        m_calibrate->setExperiment(m_document.experiment());
    };
    connect(m_calibrate, &CalibratePage::visionEdited, this, [this, edit](const VisionSpec& vision) {
        Experiment changed = m_document.experiment();
        if (changed.source.tracked && changed.vision.followsSource() && !vision.followsSource()) {
            changed.vision = vision;
            changed.source.tracked = false;
            edit(changed);
            return showNote(
                tr("The source is followed no more: that takes markers on it, a calibrated camera "
                   "and its place."));
        }
        if (const auto set = m_document.setVision(vision); !set) {
            showProblem(sentence(set.error()));
            m_calibrate->setExperiment(m_document.experiment());
        }
    });
    connect(m_calibrate, &CalibratePage::thermalCalibrated, this,
            [this, edit](const ThermalCalibration& calibration) {
                if (!m_editable)
                    return showProblem(
                        tr("A run is armed or on. The thermal camera can be changed once it has stopped."));
                Experiment changed = m_document.experiment();
                calibrateThermalCamera(changed, calibration);
                edit(changed);
            });
    connect(m_calibrate, &CalibratePage::sourceMeasured, this,
            [this, edit](const VisionSpec& vision, const Vector6d& pose) {
                Experiment changed = m_document.experiment();
                if (!changed.simulation.sourcePose) // what is believed moves, not the source
                    changed.simulation.sourcePose = changed.source.pose;
                changed.source.pose = pose;
                changed.vision = vision;
                edit(changed);
            });
    connect(m_calibrate, &CalibratePage::followWanted, this, [this, edit](bool follow) {
        Experiment changed = m_document.experiment();
        changed.source.tracked = follow;
        edit(changed);
    });
}

void PageHost::connectDocument() {
    connect(&m_document, &Document::opened, this, [this] {
        m_messages.clear();
        m_targets->clearKept();
        showDocument();
        emit commandIssued(LoadExperiment{m_document.experiment()});
    });
    connect(&m_document, &Document::visionChanged, this, [this] {
        m_rig->setExperiment(m_document.experiment());
        m_objects->setExperiment(m_document.experiment());
        m_calibrate->setExperiment(m_document.experiment());
        emit commandIssued(SetVision{m_document.experiment().vision});
    });
    connect(&m_document, &Document::edited, this, [this] {
        showDocument();
        emit commandIssued(LoadExperiment{m_document.experiment(), true});
    });
    connect(&m_document, &Document::targetsChanged, this, [this] {
        m_rig->setExperiment(m_document.experiment());
        m_objects->setExperiment(m_document.experiment());
        m_targets->setExperiment(m_document.experiment());
        std::vector<double> targets_K;
        for (const ObjectSpec& object : m_document.experiment().objects)
            targets_K.push_back(object.target_K);
        m_verdictUntold = true;
        emit commandIssued(SetTargets{targets_K});
    });
    connect(&m_document, &Document::controllerChanged, this, [this] {
        m_rig->setExperiment(m_document.experiment());
        m_objects->setExperiment(m_document.experiment());
        emit commandIssued(SetController{m_document.experiment().controller});
    });
    connect(m_targets, &TargetsPage::problem, this, &PageHost::showProblem);
    connect(m_targets, &TargetsPage::startWanted, this, [this](const Vector6d& pose) {
        Experiment changed = m_document.experiment();
        changed.start = pose;
        if (const auto edited = m_document.edit(changed, Page::Targets); !edited)
            return showProblem(sentence(edited.error()));
        showNote(tr("Runs start at %1 from now on.").arg(poseText(pose, changed.robot)));
    });
}

void PageHost::connectJudge() {
    using Change = TargetJudge::Change;
    const auto tell = [this](Change change) {
        return [this, change] { m_judge.setExperiment(m_document.experiment(), change); };
    };
    connect(&m_document, &Document::opened, this, tell(Change::All));
    connect(&m_document, &Document::edited, this, tell(Change::All));
    connect(&m_document, &Document::targetsChanged, this, tell(Change::Targets));
    connect(&m_document, &Document::controllerChanged, this, tell(Change::Controller));
    connect(&m_judge, &TargetJudge::verdictChanged, this, [this] {
        if (m_judge.isStale() || !m_judge.verdict())
            m_targets->setStale(true);
        else
            m_targets->setVerdict(*m_judge.verdict(), m_judge.shade());
        reportInfeasible();
    });
    connect(&m_judge, &TargetJudge::predictionChanged, this, [this] {
        if (m_judge.predicted())
            m_targets->setPrediction(m_judge.predictedSettling_s());
        else
            m_targets->dropPrediction();
    });
    connect(m_targets, &TargetsPage::pairsWanted, &m_judge, &TargetJudge::wantPairs);
    connect(&m_judge, &TargetJudge::pairsChanged, this, [this] {
        if (m_judge.pairs())
            m_targets->setPairs(*m_judge.pairs());
    });
    connect(m_targets, &TargetsPage::keptChanged, &m_judge, &TargetJudge::setKept);
    connect(m_targets, &TargetsPage::targetsTried, &m_judge, &TargetJudge::tryTargets);
    connect(m_targets, &TargetsPage::triesDropped, this, [this] {
        m_targets->setExperiment(m_document.experiment());
        m_judge.dropTries();
    });
    connect(m_targets, &TargetsPage::predictionWanted, &m_judge, &TargetJudge::predict);
}

void PageHost::connectForecast() {
    const auto tell = [this] { m_forecast.setExperiment(m_document.experiment()); };
    for (const auto change :
         {&Document::opened, &Document::edited, &Document::targetsChanged, &Document::controllerChanged})
        connect(&m_document, change, this, tell);
    connect(&m_forecast, &RunForecast::changed, this,
            [this] { m_run->setPrediction(m_forecast.predicted()); });
}

/// With the recording of the run that it is of; once more if its band was found at the last moment.
void PageHost::keepPrediction(const Snapshot& snapshot) {
    const PredictedRun& run = m_forecast.predicted();
    const std::pair kept{snapshot.runId, run.hasBand()};
    if (!isRunOn(snapshot.state) || snapshot.recordingPath.empty() || run.samples.empty() ||
        m_keptPrediction == kept)
        return;
    m_keptPrediction = kept;
    emit commandIssued(KeepPrediction{snapshot.runId, std::make_shared<const PredictedRun>(run)});
}

/// A run that is on is told why targets set meanwhile cannot be held.
void PageHost::reportInfeasible() {
    if (!m_verdictUntold || !m_judge.isCurrent())
        return;
    m_verdictUntold = false;
    if (!m_judge.verdict()->feasible)
        emit commandIssued(ReportInfeasible{m_judge.verdict()->reason});
}

void PageHost::showDocument() {
    m_rig->setExperiment(m_document.experiment());
    m_objects->setExperiment(m_document.experiment());
    m_calibrate->setExperiment(m_document.experiment());
    m_targets->setExperiment(m_document.experiment());
    m_run->setExperiment(m_document.experiment());
}

void PageHost::showEditable() {
    m_reviewDesk.setEditable(m_editable);
    m_objects->setEditable(
        m_editable,
        m_editable ? QString() : tr("A run is armed or on. Objects can be changed once it has stopped."));
    m_targets->setStartable(
        m_editable,
        m_editable ? QString() : tr("A run is armed or on. The start can be changed once it has stopped."));
    m_targets->setEditable(m_targetsEditable, tr("The run is stopping. Targets can be changed once it has."));
}

QSize PageHost::minimumSizeHint() const {
    return m_pages->minimumSizeHint();
}

void PageHost::show(Page page) {
    m_pages->setCurrentIndex(static_cast<int>(page));
    QTimer::singleShot(0, m_place, [this] { m_place->place(); }); // when the page is laid out
    if (page == Page::Review)
        m_reviewDesk.showList();
    else
        m_reviewDesk.forgetAlarms();
    emit pageChanged(page);
}

void PageHost::showAllAlarms() {
    m_reviewDesk.showAlarmsOnceListed();
    show(Page::Review);
}

Page PageHost::page() const {
    return static_cast<Page>(m_pages->currentIndex());
}

void PageHost::show(const VisionView& view) {
    m_calibrate->setView(view);
}

void PageHost::show(const ThermalView& view) {
    m_run->setThermalView(view);
    m_calibrate->setThermalView(view);
}

void PageHost::watchThermal() {
    emit commandIssued(m_thermalOnCalibrate.show ? m_thermalOnCalibrate
                                                 : WatchThermalCamera{m_isThermalOnRun});
}

void PageHost::apply(const Snapshot& snapshot) {
    m_messages.keepRefusal(snapshot);
    m_messages.dropWritten(snapshot.state);
    m_countdown->setPending(snapshot.pending);
    m_told_K = snapshot.toldReadings_K;
    m_run->apply(snapshot);
    m_forecast.apply(snapshot, m_run->isPredictionSeen());
    keepPrediction(snapshot);
    m_reviewDesk.setRecording(QString::fromStdString(snapshot.recordingPath));
    const bool editable = allowsEdits(snapshot.state);
    m_rig->apply(snapshot, editable);
    m_calibrate->setRobot(snapshot.latest.coordinates, snapshot.isMoving,
                          editable && snapshot.state != RunState::Fault);
    const bool targetsEditable = snapshot.state != RunState::Stopping; // the engine refuses them then
    if (editable != m_editable || targetsEditable != m_targetsEditable) {
        m_editable = editable;
        m_targetsEditable = targetsEditable;
        showEditable();
    }
}

void PageHost::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_countdown->setTemperatureUnit(unit);
    m_rig->setTemperatureUnit(unit);
    m_objects->setTemperatureUnit(unit);
    m_targets->setTemperatureUnit(unit);
    m_calibrate->setTemperatureUnit(unit);
    m_run->setTemperatureUnit(unit);
    m_review->setTemperatureUnit(unit);
    m_reviewDesk.retranslate(); // its events speak of temperatures
}

void PageHost::showMoment(double time_s) {
    show(Page::Run);
    m_run->showMoment(time_s);
}

void PageHost::showUndone(const EditStep& step) {
    showStep(step, tr("Undone: %1"));
}

void PageHost::showRedone(const EditStep& step) {
    showStep(step, tr("Redone: %1"));
}

void PageHost::showStep(const EditStep& step, const QString& words) {
    if (step.edit.page == Page::Objects && step.edit.object >= 0)
        m_objects->selectObject(step.edit.object);
    if (page() == step.edit.page)
        return;
    if (m_editable)
        show(step.edit.page);
    m_messages.showOfEdit(words.arg(editWords(step.edit, *step.before, *step.after)));
}

/// A sensor is believed again only by a person who has looked.
void PageHost::askConfirm(std::size_t object) {
    if (object >= m_document.experiment().objects.size() || object >= m_told_K.size())
        return;
    askOnTheWayUp(this, QStringLiteral("confirmQuestion"), tr("Confirm a sensor"),
                  tr("The sensor of \"%1\" reads %2. Have you looked, and is it on its object and right?")
                      .arg(QString::fromStdString(m_document.experiment().objects[object].name),
                           formatTemperature(m_told_K[object], m_unit)),
                  tr("Confirm"), [this, object] { emit commandIssued(ConfirmSensor{object}); });
}

void PageHost::takeFile(const QString& path) {
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (suffix == QLatin1String("json") || suffix == QLatin1String("bask"))
        return m_files.open(path);
    if (!ObjectsPage::isReadable(path))
        return showProblem(
            tr("%1 cannot be opened. Bask opens experiments and rigs (JSON), recorded sessions "
               "(BASK) and outlines (%2, pictures).",
               "%2 names of file formats, with commas")
                .arg(QFileInfo(path).fileName(),
                     QString::fromStdString(outlineFormatNames(OutlineKind::Drawing) + ", " +
                                            outlineFormatNames(OutlineKind::List))));
    show(Page::Objects);
    m_objects->offerFile(path);
}

void PageHost::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        m_messages.clear(); // it speaks the old language
        showEditable();
        m_reviewDesk.retranslate();
    }
}

} // namespace bask
