#include "app/main_window.h"

#include "app/bottom_dock.h"
#include "app/coach.h"
#include "app/cut_off_run.h"
#include "app/data_folder.h"
#include "app/error_text.h"
#include "app/fault_words.h"
#include "app/infeasible_dialog.h"
#include "app/labels_dialog.h"
#include "app/manual_window.h"
#include "app/material_control.h"
#include "app/monitor_control.h"
#include "app/problem_report.h"
#include "app/recipe_control.h"
#include "app/recovery_offer.h"
#include "app/resources.h"
#include "app/silent_engine.h"
#include "app/state_bar.h"
#include "app/status_line.h"
#include "app/undo_actions.h"
#include "app/why_not.h"
#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/experiment/rig_file.h"
#include "engine/model/hand_warm.h"
#include "engine/model/mounting_check.h"
#include "engine/recipe/recipe.h"
#include "widgets/calibrate/calibration_age.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/point_at.h"
#include "widgets/common/run_state_chip.h"
#include "widgets/common/source_words.h"
#include "widgets/rig/way_up_question.h"
#include "widgets/run/run_page.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QScreen>
#include <QScrollArea>
#include <QToolBar>
#include <QUrl>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>
#include <utility>

namespace bask {
namespace {

constexpr double kNear = 0.02; ///< view factor: further away a source of 300 degC does little

bool isNearSource(const Snapshot& snapshot) {
    return std::ranges::any_of(snapshot.latest.objects, [](const ObjectSample& object) {
        return object.viewFactor > kNear; // NaN where the robot's place is not sure
    });
}

/// No run is on, and a hot source warms the objects all the same; a retreat would take them away.
bool isOverHotSource(const Snapshot& snapshot, double environment_K) {
    const bool isHot =
        std::isfinite(snapshot.sourceAge_s) && snapshot.latest.source_K > environment_K + kHandWarm_K;
    const bool isShut = snapshot.simulated && snapshot.heat == HeatState::Off;
    return isHot && !isShut && !isRunOn(snapshot.state) && !snapshot.isAway && isNearSource(snapshot);
}

/// Where Arm or Start may come next, besides *Ready*.
bool isBeforeStart(RunState state) {
    return state == RunState::NotReady || state == RunState::Armed || state == RunState::Stopped;
}

/// Reset waits for a source that heated though its heat is off, and for nothing graver.
bool isUnaskedWaited(const Snapshot& snapshot) {
    const auto cause = messageWithin(snapshot.remedy);
    return cause && cause->code == MessageCode::SafetySourceHeatsUnasked;
}

/// Returns the page on which a reason is dealt with.
Page pageOf(MessageCode reason) {
    if (isUnfitTarget(reason))
        return Page::Targets;
    switch (reason) {
    case MessageCode::ReasonTargetInfeasible:
    case MessageCode::EventCompromise:
        return Page::Targets;
    case MessageCode::ReasonSourcePoseLost:
        return Page::Calibrate;
    case MessageCode::ReasonNoExperiment:
    case MessageCode::MountingOverlap:
        return Page::Objects;
    case MessageCode::ReasonRobotLost:
    case MessageCode::ReasonSourceLost:
    case MessageCode::RobotPlaceUnsure:
    case MessageCode::RobotRestarted:
    case MessageCode::RobotAlarm:
    case MessageCode::RobotHeld:
    case MessageCode::RobotDisabled:
    case MessageCode::RobotOpening:
    case MessageCode::RigIncomplete:
    case MessageCode::LinkNotOpened:
    case MessageCode::LinkLost:
    case MessageCode::DeviceSilent:
    case MessageCode::DeviceOther:
    case MessageCode::ProgramNotConfirmed:
    case MessageCode::ProgramNotStarted:
    case MessageCode::ProgramEnded:
    case MessageCode::ProgramStopped:
    case MessageCode::ProgramSilent:
    case MessageCode::ProgramOther:
    case MessageCode::ProgramRefuses:
    case MessageCode::RobotReports:
        return Page::Rig;
    default:
        return Page::Run;
    }
}

/// The values of an alarm are of when it was raised: first one of the same words, then of the same kind.
auto alarmOf(const std::vector<Alarm>& alarms, const Message& reason) {
    const auto found = std::ranges::find(alarms, reason, &Alarm::message);
    return found != alarms.end() ? found : std::ranges::find_if(alarms, [&](const Alarm& alarm) {
        return alarm.message.code == reason.code;
    });
}

} // namespace

MainWindow::MainWindow()
    : m_autosave(m_document, unsavedFolder()), m_files(m_document, m_settings, this),
      m_actions((initResources(), this)) {
    setFileFolders(&m_settings);
    m_language.set(m_settings.language());
    m_actions.retranslate();
    buildLayout();
    connectActions();
    connectParts();

    m_actions.setRecent(m_settings.recentFiles());
    m_actions.showTheme(m_settings.theme());
    m_actions.showTextSize(m_textSize_percent);
    m_actions.showHornMode(m_settings.hornMode());
    m_horn.setMode(m_settings.hornMode());
    m_actions.showLanguage(m_language.current());
    m_statusLine->showLanguage(m_language.current());
    setTemperatureUnit(m_settings.temperatureUnit());
    retranslate();
    restyle();

    resize(QSize(1280, 800).boundedTo(screen()->availableSize()));
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    m_pages->show(Page::Run);
}

MainWindow::~MainWindow() {
    endEngine(); // before anything is written
    // A signal asks nobody.
    for (const QString& place : m_files.unfinishedExports())
        std::fprintf(stderr, "bask: ended while this was being written: %s\n", qPrintable(place));
    setFileFolders(nullptr);
}

void MainWindow::begin(const QString& path) {
    m_engine.setWatch(m_monitor->inlet());
    m_engine.start(alarmFile(), deviceFile());
    m_monitor->begin();
    m_materials->begin();
    // Again, since the opening of the example clears what is said of a damaged one.
    connect(&m_document, &Document::opened, m_materials, &MaterialControl::begin, Qt::SingleShotConnection);
    m_cutOff->begin();
    m_recovery->begin(unsavedFolder());
    if (!m_settings.isCoachAnswered() && path.isEmpty())
        m_coach->offer();
    const bool isExperiment = !path.isEmpty() && !isSessionFile(path) && !isRigFile(path.toStdString()) &&
                              !isRecipeFile(path.toStdString());
    if (isExperiment)
        return m_files.open(path);
    if (!path.isEmpty()) // over the example, or the example's own opening would clear what is said of it
        connect(
            &m_document, &Document::opened, this, [this, path] { m_files.open(path); },
            Qt::SingleShotConnection);
    m_files.openExample(QStringLiteral("three-objects"), false);
}

void MainWindow::apply(const Snapshot& snapshot) {
    m_last = snapshot;
    m_sinceAnswer.start();
    const QWidget* const focused = focusWidget();
    const bool isVerb = m_stateBar->isAncestorOf(focused);
    m_actions.apply(snapshot);
    m_stateBar->apply(snapshot);
    showNotes();
    if (isVerb && focusWidget() != focused) // or the verb beside it has the keyboard, and Space presses that
        m_stateBar->focusChip();
    m_statusLine->apply(snapshot);
    m_pages->apply(snapshot);
    m_dock->apply(snapshot);
    m_horn.apply(snapshot);
    m_files.setRecording(QString::fromStdString(snapshot.recordingPath));
    m_cutOff->apply(snapshot);
    m_recipe->apply(snapshot);
    if (snapshot.refusal.code != MessageCode::None)
        refuse(snapshot.refusal);
    armWithLabels(snapshot);
    dropOldQuestions(snapshot);
    const QString refused = m_refused ? whyRefused(snapshot, *m_refused) : openQuestion();
    if (!m_pages->messages().keepWhile(refused, snapshot.state))
        m_refused.reset();
    m_undo->setState(snapshot.state);
    emit snapshotApplied(snapshot);
    closeAtRest();
}

void MainWindow::showSilence() {
    m_pages->apply(withoutAnswer(m_last, 1e-3 * static_cast<double>(m_sinceAnswer.elapsed())));
}

void MainWindow::perform(Verb verb) {
    m_pages->messages().dropRefusal();
    if ((verb == Verb::Arm || verb == Verb::Start || verb == Verb::Resume) && isAnswerAwaited())
        return;
    // Before the order goes out: no reset or load of the recipe's may follow it.
    if (verb == Verb::Hold || verb == Verb::Stop || verb == Verb::EmergencyStop)
        m_recipe->takeOver(verb == Verb::Hold);
    switch (verb) {
    case Verb::Arm:
        return m_settings.asksLabels() ? askLabels(true) : askToArm();
    case Verb::Start:
        m_engine.send(Start{false}); // the engine judges the targets; its refusal asks for the tick
        return showRun();
    case Verb::Hold:
        return m_engine.send(Hold{});
    case Verb::Resume:
        return m_engine.send(Resume{});
    case Verb::Stop:
        return m_engine.send(Stop{});
    case Verb::Retreat:
        return askRetreat();
    case Verb::EmergencyStop:
        return m_engine.send(EmergencyStop{});
    case Verb::Reset:
        return m_engine.send(Reset{});
    }
}

/// From another page nobody has seen whether its run is predicted.
void MainWindow::showRun() {
    if (m_pages->page() == Page::Run)
        return;
    const QString why = whyNoForecast(m_pages->forecast().missing());
    m_pages->show(Page::Run);
    if (!why.isEmpty() && m_pages->run()->isPredictionShown())
        m_pages->messages().showBriefly(why);
}

void MainWindow::askLabels(bool isBeforeArm) {
    delete findChild<LabelsDialog*>();
    auto* dialog = new LabelsDialog({m_last.labels, m_settings.recentOperators(), m_settings.asksLabels(),
                                     isBeforeArm, !allowsEdits(m_last.state)},
                                    this);
    connect(dialog, &QDialog::accepted, this, [this, dialog, isBeforeArm] {
        const RunLabels labels = dialog->labels();
        m_settings.setAsksLabels(dialog->isAskedAlways());
        if (!labels.operatorName.empty())
            m_settings.addRecentOperator(QString::fromStdString(labels.operatorName));
        m_engine.send(SetLabels{labels});
        m_armsWith = isBeforeArm ? std::optional(labels) : std::nullopt;
    });
    dialog->show();
}

/// Once the engine has taken them; not if it has refused.
void MainWindow::armWithLabels(const Snapshot& snapshot) {
    if (!m_armsWith)
        return;
    const bool areTaken = snapshot.labels == *m_armsWith;
    if (areTaken || snapshot.refusal.code != MessageCode::None)
        m_armsWith.reset();
    if (areTaken && allows(snapshot, Verb::Arm))
        askToArm();
}

/// On the way up a person decides; STOP can be pressed meanwhile.
void MainWindow::askToArm() {
    QStringList questions;
    if (!m_overlaps.isEmpty())
        questions << tr("%1. Are they mounted so all the same?").arg(m_overlaps.join(QStringLiteral("; ")));
    if (!m_last.simulated)
        questions << tr("This rig is real: once the run is started, the robot moves and the source heats. Is "
                        "everybody and everything out of the way?");
    dropQuestion(this, QStringLiteral("armQuestion"));
    if (questions.isEmpty())
        return arm();
    askOnTheWayUp(this, QStringLiteral("armQuestion"),
                  m_last.simulated ? tr("Arm the simulated rig") : tr("Arm the real rig"),
                  questions.join(QStringLiteral("\n\n")), tr("Arm"), [this] { arm(); });
}

void MainWindow::askRetreat() {
    dropQuestion(this, QStringLiteral("homeQuestion")); // one motion at a time
    m_retreatAskedIn = m_last.state;
    askOnTheWayUp(this, QStringLiteral("retreatQuestion"), tr("Retreat"),
                  tr("The robot will move: it takes the objects away from the source, and the heat goes off. "
                     "Are all hands off "
                     "the robot and is nothing in its way?"),
                  tr("Retreat now"), [this] {
                      m_recipe->takeOver();
                      m_engine.send(Retreat{});
                  });
}

void MainWindow::askHome() {
    if (isAnswerAwaited())
        return;
    m_homeAskedIn = m_last.state;
    askOnTheWayUp(this, QStringLiteral("homeQuestion"), tr("Home the robot"),
                  tr("The robot will move: it seeks its switches to know its place. Are all hands off the "
                     "robot and is nothing in its way?"),
                  tr("Home now"), [this] {
                      m_recipe->takeOverAtRest();
                      m_engine.send(HomeRobot{});
                  });
}

/// Empty, or that a motion is being asked about: with hands at the robot nothing else begins.
QString MainWindow::openQuestion() const {
    for (const char* name : {"retreatQuestion", "homeQuestion"})
        if (const auto* box = findChild<QMessageBox*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
            box != nullptr && box->isVisible())
            return tr("Nothing else begins while the question \"%1\" is open: answer it first. "
                      "Hold, Stop and STOP are possible.")
                .arg(box->windowTitle());
    return {};
}

/// What would begin something is refused in words while a motion is being asked about.
bool MainWindow::isAnswerAwaited() {
    const QString first = openQuestion();
    if (first.isEmpty())
        return false;
    m_refused.reset();
    m_pages->messages().showWhile(first, m_last.state);
    return true;
}

/// What was asked in another state is not answered in this one.
void MainWindow::dropOldQuestions(const Snapshot& snapshot) {
    const auto kindOf = [](RunState state) {
        return std::tuple(isRunOn(state), state == RunState::Armed, state == RunState::Fault);
    };
    const auto isOfKind = [&](RunState askedIn) { return kindOf(snapshot.state) == kindOf(askedIn); };
    const std::pair<QString, bool> questions[] = {
        {QStringLiteral("armQuestion"), allows(snapshot, Verb::Arm)},
        {QStringLiteral("retreatQuestion"), allows(snapshot, Verb::Retreat) && isOfKind(m_retreatAskedIn)},
        {QStringLiteral("homeQuestion"), allowsHome(snapshot) && isOfKind(m_homeAskedIn)}};
    for (const auto& [name, holds] : questions)
        if (const auto* box = findChild<QMessageBox*>(name, Qt::FindDirectChildrenOnly);
            box != nullptr && box->isVisible() && !holds) {
            const QString title = box->windowTitle();
            dropQuestion(this, name);
            m_pages->messages().showBriefly(
                tr("The question \"%1\" was closed: the state has changed since it was asked.").arg(title));
        }
}

void MainWindow::arm() {
    const QString path = m_files.nextRecordingPath();
    if (!path.isEmpty())
        m_engine.send(Arm{path.toStdString()});
}

void MainWindow::refuse(const Message& refusal) {
    if (refusal.code == MessageCode::ReasonTargetInfeasible && m_last.state == RunState::Armed &&
        !m_recipe->isOn())
        return askInfeasible();
    if (refusal.code == MessageCode::SafetySourceHeatsUnasked)
        if (const QString wait = unaskedWait(m_last, m_settings.temperatureUnit()); !wait.isEmpty())
            return m_pages->messages().showRefusal(wait, m_last, refusal);
    // What the fields show is what runs; a newer edit of them has its own answer.
    const auto targets = checkTargets(m_document.experiment());
    const bool isTooHot = !targets && refusal.code == targets.error().code();
    const bool isTooLate =
        refusal.code == MessageCode::CommandNotNow && isVerb(refusal.args.at(0), CommandVerb::SetTargets);
    if (allowsEdits(m_last.state) || !(isTooHot || isTooLate))
        return m_pages->messages().showRefusal(sentence(refusal), m_last, refusal);
    (void)m_document.setTargets(m_last.targets_K);
    m_pages->messages().showRefusal(tr("Not taken: the targets stay as they were.") + u' ' +
                                    sentence(refusal));
}

void MainWindow::sayWhyNot(Verb verb) {
    m_refused = verb;
    m_pages->messages().showWhile(whyRefused(m_last, verb), m_last.state);
}

/// An open question comes first for what would begin a run: no other step brings that nearer.
QString MainWindow::whyRefused(const Snapshot& snapshot, Verb verb) const {
    const bool isBegun = verb == Verb::Arm || verb == Verb::Start || verb == Verb::Resume;
    const QString question = isBegun ? openQuestion() : QString();
    return question.isEmpty() ? whyNot(snapshot, verb) : question;
}

void MainWindow::askInfeasible() {
    const TargetJudge& judge = m_pages->judge();
    const bool known = judge.isCurrent() && !judge.verdict()->feasible;
    const Message reason = known ? judge.verdict()->reason : Message();
    auto* dialog = new InfeasibleDialog(known ? messageText(reason) : QString(), this);
    connect(dialog, &QDialog::accepted, this, [this, known, reason] {
        m_engine.send(Start{true});
        if (known)
            m_engine.send(ReportInfeasible{reason});
    });
    dialog->open();
}

/// Its page, and its alarm in the list; if that page is there already, it is shown to be the one.
void MainWindow::showReason(int index) {
    if (index < 0 || static_cast<std::size_t>(index) >= m_last.reasons.size())
        return;
    const Message& reason = m_last.reasons[static_cast<std::size_t>(index)];
    const Page page = pageOf(reason.code);
    const bool isThere = page == m_pages->page();
    m_pages->show(page);
    const auto alarm = alarmOf(m_last.alarms, reason);
    if (alarm != m_last.alarms.end())
        m_dock->showAlarm(alarm->id);
    else if (isThere)
        pointAt(m_pages);
}

/// The keyboard goes there as well.
void MainWindow::showControl(Page page, const QString& name) {
    m_pages->show(page);
    for (QAction* top : menuBar()->actions())
        if (top->menu()->objectName() == name)
            return pointAt(menuBar(), menuBar()->actionGeometry(top));
    for (QWidget* control : findChildren<QWidget*>(name))
        if (control->isVisible()) {
            for (QWidget* around = control; around != nullptr; around = around->parentWidget())
                if (auto* scroll = qobject_cast<QScrollArea*>(around))
                    scroll->ensureWidgetVisible(control);
            control->setFocus(Qt::TabFocusReason);
            return pointAt(control);
        }
}

void MainWindow::showManual(const QString& page) {
    if (!m_manual) {
        m_manual = new ManualWindow(m_language, this);
        connect(m_manual, &ManualWindow::problem, m_pages, &PageHost::showProblem);
    }
    m_manual->open(page);
}

void MainWindow::reportProblem() {
    delete findChild<ProblemDialog*>();
    auto* dialog = new ProblemDialog(problemReport(m_last, m_dock->events(), m_document.experiment()), this);
    connect(dialog, &ProblemDialog::saveWanted, &m_files, &SessionActions::saveReport);
    dialog->show();
}

void MainWindow::setLanguage(const QString& code) {
    m_settings.setLanguage(code);
    m_language.set(code);
    m_actions.showLanguage(code);
    m_statusLine->showLanguage(code);
}

void MainWindow::setTheme(Theme theme) {
    m_settings.setTheme(theme);
    m_actions.showTheme(theme);
    applyTheme(*qApp, theme);
}

void MainWindow::setTextSize(int percent) {
    m_settings.setTextSize_percent(percent);
    m_actions.showTextSize(percent);
    QString note =
        tr("From the next start of Bask on, text and all that is drawn with it has %1 % of its size.")
            .arg(percent);
    const QSize needed = minimumSizeHint() * percent / m_textSize_percent, room = screen()->availableSize();
    if (needed.width() > room.width() || needed.height() > room.height())
        note += u' ' + tr("The window will then be larger than this screen.");
    m_pages->showNote(note);
}

void MainWindow::setHornMode(HornMode mode) {
    m_settings.setHornMode(mode);
    m_actions.showHornMode(mode);
    m_horn.setMode(mode);
    if (mode != HornMode::Off) {
        m_horn.sample();
        m_pages->showNote(
            tr("This was the horn: the desktop's bell. If you heard nothing, it is off in the desktop's "
               "settings."));
    }
}

void MainWindow::setTemperatureUnit(TemperatureUnit unit) {
    m_settings.setTemperatureUnit(unit);
    setReadersUnit(unit);
    m_actions.showTemperatureUnit(unit);
    m_statusLine->setTemperatureUnit(unit);
    m_pages->setTemperatureUnit(unit);
    m_stateBar->setTemperatureUnit(unit);
    m_dock->setTemperatureUnit(unit);
    m_coach->setTemperatureUnit(unit);
    showNotes();
}

void MainWindow::showTitle() {
    setWindowTitle(QStringLiteral("%1[*] - Bask").arg(m_document.displayName()));
    setWindowModified(m_document.modified());
}

void MainWindow::takeAges() {
    m_ages = calibrationAges(m_document.experiment());
    m_overlaps.clear();
    for (const MountingRemark& remark : overlapsInPlane(m_document.experiment()))
        m_overlaps << sentence(remark.message);
    showNotes();
}

/// What Arm and Start ask about though nothing else stands in the way, and what is not known yet.
QStringList MainWindow::askedFirst() const {
    QStringList lines;
    if (!m_overlaps.isEmpty())
        lines << tr("Ready, but: %1. Arm asks about it.").arg(m_overlaps.join(QStringLiteral("; ")));
    const TargetJudge& judge = m_pages->judge();
    if (!judge.isCurrent())
        lines << tr("Ready; whether the targets can be held is being checked.");
    else if (const QString reason = whyNotHeld(); !reason.isEmpty())
        lines << tr("Ready, but: %1. Start asks about it.").arg(reason);
    return lines;
}

/// Empty where the targets can be held, or nobody knows yet.
QString MainWindow::whyNotHeld() const {
    const TargetJudge& judge = m_pages->judge();
    return judge.isCurrent() && !judge.verdict()->feasible ? messageText(judge.verdict()->reason) : QString();
}

/// The gravest of them that is known, as short as there is room for under the state.
QString MainWindow::askedCaption() const {
    if (!m_overlaps.isEmpty() && m_last.state != RunState::Armed) // Arm has asked
        return tr("objects overlap");
    return whyNotHeld().isEmpty() ? QString() : tr("cannot be held", "the targets");
}

void MainWindow::showNotes() {
    showRemedy();
    QStringList notes;
    if (const QStringList faults = activeFaultWords(m_last); !faults.isEmpty())
        notes << tr("Simulated faults are active: %1. Tools > Simulate fault ends them.")
                     .arg(faults.join(QStringLiteral("; ")));
    const TemperatureUnit unit = m_settings.temperatureUnit();
    const bool isOverHeat = isOverHotSource(m_last, m_document.experiment().environment_K);
    if (isOverHeat)
        notes << tr("The objects are over the source, which has %1: its heat reaches them although no run is "
                    "on. "
                    "Warm sensors cannot be zeroed, and a run begins with objects as warm as they are then. "
                    "Retreat takes them away.")
                     .arg(sourceReadingText(m_last, unit));
    const bool isCold = !isRunOn(m_last.state) && m_last.state != RunState::Fault && isSourceCold(m_last);
    if (isCold)
        notes << coldSourceText(m_last, unit);
    const bool isReady = m_last.state == RunState::Ready, isBefore = isReady || isBeforeStart(m_last.state);
    if (const QString reason = isBefore && !isReady ? whyNotHeld() : QString(); !reason.isEmpty())
        notes << tr("The targets cannot be held: %1. Start asks about it.").arg(reason);
    if (m_last.state == RunState::Holding && isNearSource(m_last))
        notes << tr(
            "The objects stay where they are, near the source, and go on towards the temperature that they "
            "reach there; Retreat takes them away.");
    m_stateBar->chip()->setExplanation(isReady ? askedFirst().join(u'\n') : QString());
    m_stateBar->chip()->setNotes((isReady ? QStringList() : m_overlaps) + notes + m_ages);
    const bool isFilling =
        m_last.reasons.size() == 1 && m_last.reasons.front().code == MessageCode::ReasonEstimatorFilling;
    QString caption;
    if (isOverHeat)
        caption = tr("over hot source: %1", "the objects are over it; its temperature")
                      .arg(formatTemperature(m_last.latest.source_K, unit, 0));
    else if (const QString asked =
                 isBefore && m_last.state != RunState::NotReady ? askedCaption() : QString();
             !asked.isEmpty())
        caption = asked;
    else if (isFilling) // and nothing else stands in the way
        caption = tr("ready in %1 s", "readings are being collected")
                      .arg(QString::fromStdString(m_last.reasons.front().args.at(0).text()));
    else if (isCold)
        caption = tr("source %1 of %2", "temperatures: that of now, and the set point")
                      .arg(formatTemperatureNumber(m_last.latest.source_K, unit, 0),
                           formatTemperature(m_last.warmUp->setPoint_K, unit, 0));
    else if (std::ranges::find(m_last.reasons, MessageCode::ReasonEmergencyStop, &Message::code) !=
             m_last.reasons.end())
        caption = tr("STOP was pressed");
    m_stateBar->chip()->setCaption(caption);
}

/// Its verb is beside it, or why nobody can do it now.
void MainWindow::showRemedy() {
    if (m_last.place == PlaceState::Unsure && allowsHome(m_last))
        return m_stateBar->chip()->setRemedy(placeSteps(m_last), m_actions.homeRobot);
    const std::optional<Verb> verb = remedyVerb(m_last.remedy.code);
    const bool isPossible = verb && allows(m_last, *verb);
    QString words = isUnaskedWaited(m_last) ? unaskedWait(m_last, m_settings.temperatureUnit()) : QString();
    if (words.isEmpty() && m_last.remedy.code != MessageCode::None)
        words = messageText(m_last.remedy);
    if (verb && !isPossible)
        words += u' ' + whyNot(m_last, *verb);
    m_stateBar->chip()->setRemedy(words, isPossible ? m_actions.verb(*verb) : nullptr);
}

void MainWindow::retranslate() {
    m_actions.retranslate();
    m_undo->refresh();
    m_cutOff->retranslate();
    m_recovery->retranslate();
    m_coach->retranslate();
    m_navigation->setWindowTitle(tr("Pages"));
    showTitle();
    takeAges();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::LanguageChange && m_navigation != nullptr)
        retranslate();
    else if (event->type() == QEvent::PaletteChange && m_navigation != nullptr)
        restyle();
}

void MainWindow::restyle() {
    m_actions.restyle(palette());
    // Flat bars with a hairline; Fusion would shade them.
    const QString line = hairline(isDark(this)).name();
    for (QToolBar* bar : findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
        bar->setStyleSheet(
            QStringLiteral("QToolBar { background: palette(window); border: 0; border-%1: 1px solid %2; }")
                .arg(bar == m_navigation ? QStringLiteral("right") : QStringLiteral("bottom"), line));
}

bool MainWindow::runIsOn() const {
    return isRunOn(m_last.state);
}

/// What a person ends here ends before any question about unsaved work: nothing may begin behind it.
bool MainWindow::mayClose() {
    if (!runIsOn() && !m_recipe->isOn())
        return mayEndRecording();
    const Closing closing =
        m_closeQuestion ? m_closeQuestion() : askToClose(this, runIsOn(), m_recipe->isOn());
    m_closesAtRest = closing == Closing::Stop;
    if (closing == Closing::Stop) {
        m_recipe->isOn() ? m_recipe->stopNow() : endRun();
        closeAtRest(); // the run may have ended behind the question
        if (m_closesAtRest)
            m_pages->messages().showNote(tr("Bask closes when the objects are away from the source."));
        return false;
    }
    if (closing == Closing::Now)
        runIsOn() ? perform(Verb::EmergencyStop) : m_recipe->stopNow();
    return closing == Closing::Now;
}

bool MainWindow::mayEndRecording() {
    if (!m_last.isRecordedUntilCold || !m_engine.answering())
        return true;
    if (m_closeQuestion)
        return m_closeQuestion() == Closing::Now;
    return askToEndRecording(this, recordedUntilColdText(m_last, m_settings.temperatureUnit()));
}

bool MainWindow::mayLeaveExports() {
    const QStringList places = m_files.unfinishedExports();
    return places.isEmpty() || askToLeaveExports(this, places);
}

void MainWindow::endRun() {
    if (runIsOn() && m_last.state != RunState::Stopping)
        perform(Verb::Stop);
}

void MainWindow::closeAtRest() {
    if (!m_closesAtRest || runIsOn() || m_recipe->isOn())
        return;
    m_closesAtRest = false;
    if (m_last.state != RunState::Fault)
        QMetaObject::invokeMethod(this, &QWidget::close, Qt::QueuedConnection);
    else
        m_pages->messages().showNote(tr("Bask stays open: the run ended by a fault. Look at the alarms."));
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!mayClose() || !m_files.mayDiscard() || !m_recipe->mayDiscard() || !mayLeaveExports()) {
        event->ignore();
        return;
    }
    const bool hasEnded = endEngine(); // first: the disk may hang in all that follows
    if (m_isHeatLeft)
        tellHeatLeft(this);
    m_settings.setWindow(saveGeometry(), saveState());
    m_autosave.end();
    if (hasEnded)
        m_cutOff->end();
    event->accept();
}

bool MainWindow::endEngine() {
    const bool hasEnded = m_engine.shutDown(EngineClient::kEnd);
    const bool isUnheard = !hasEnded && !m_last.simulated && m_last.heat != HeatState::Off;
    if ((m_engine.isHeatLeft() || isUnheard) && !std::exchange(m_isHeatLeft, true))
        std::fputs("bask: the heat of the real rig is not known to be off: look at the plate\n", stderr);
    return hasEnded;
}

/// Any file: what cannot be opened is refused in words.
void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.isEmpty())
        return;
    event->acceptProposedAction();
    if (urls.size() > 1)
        m_pages->showProblem(tr("Only one file can be opened at a time."));
    else if (!urls.first().isLocalFile())
        m_pages->showProblem(tr("Only files of this computer can be opened: save it here first."));
    else
        m_pages->takeFile(urls.first().toLocalFile());
}

} // namespace bask
