// How the window is put together and wired; main_window.cpp is what it does.

#include "app/about.h"
#include "app/bottom_dock.h"
#include "app/coach.h"
#include "app/cut_off_run.h"
#include "app/data_folder.h"
#include "app/error_text.h"
#include "app/large_numbers_control.h"
#include "app/main_window.h"
#include "app/material_control.h"
#include "app/monitor_control.h"
#include "app/page_bar.h"
#include "app/plot_windows_control.h"
#include "app/recipe_control.h"
#include "app/recovery_offer.h"
#include "app/state_bar.h"
#include "app/status_line.h"
#include "app/undo_actions.h"
#include "widgets/common/scrolling.h"
#include "widgets/objects/objects_page.h"
#include "widgets/plots/plot_place.h"
#include "widgets/run/run_page.h"

#include <QApplication>
#include <QMenuBar>
#include <QTimer>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <chrono>

namespace bask {
namespace {

constexpr std::chrono::seconds kWhyNot{8}; ///< as long as a sentence takes to be read twice

/// Moves or heats the rig outside of a run.
bool isManual(const Command& command) {
    if (const auto* heat = std::get_if<SetHeat>(&command))
        return heat->setPoint_K.has_value();
    return std::holds_alternative<MoveTo>(command) || std::holds_alternative<Jog>(command) ||
           std::holds_alternative<HomeRobot>(command) || std::holds_alternative<ClearRobotAlarm>(command);
}

/// Sets the robot or the heat going.
bool beginsByHand(const Command& command) {
    if (const auto* jog = std::get_if<Jog>(&command))
        return !jog->twist.isZero();
    return isManual(command) && !std::holds_alternative<ClearRobotAlarm>(command);
}

} // namespace

void MainWindow::buildLayout() {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowIcon(QIcon(QStringLiteral(":/icons/bask.svg")));
    setAcceptDrops(true);
    m_actions.fillMenus(menuBar());

    m_stateBar = new StateBar(m_actions);
    m_pages = new PageHost(m_document, m_files);
    buildNavigation();

    // The state bar spans the window, over navigation and docks: it sits under the menu bar as the only top
    // tool bar.
    auto* top = new QToolBar(this);
    top->setObjectName(QStringLiteral("stateToolBar"));
    top->setMovable(false);
    top->setFloatable(false);
    top->setContextMenuPolicy(Qt::PreventContextMenu);
    m_stateBar->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    top->addWidget(m_stateBar);
    addToolBar(Qt::TopToolBarArea, top);
    addToolBar(Qt::LeftToolBarArea, m_navigation);
    setCentralWidget(m_pages);
    setContextMenuPolicy(Qt::NoContextMenu);

    m_dock = new BottomDock(this);
    addDockWidget(Qt::BottomDockWidgetArea, m_dock);
    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    resizeDocks({m_dock}, {110}, Qt::Vertical);

    m_statusLine = new StatusLine(m_actions.unitMenu(), m_actions.languageMenu());
    setStatusBar(m_statusLine);
    new ScrollHabits(this);
}

void MainWindow::buildNavigation() {
    auto* pages = new PageBar;
    m_navigation = pages;
    for (int i = 0; i < kPages; ++i)
        connect(pages->addPage(m_actions.page(i)), &QToolButton::toggled, this, &MainWindow::turnToChosenPage,
                Qt::QueuedConnection);
}

/// A screen reader toggles a page's button: its action is checked or unchecked by that, and not triggered.
void MainWindow::turnToChosenPage() {
    for (int i = 0; i < kPages; ++i)
        if (m_actions.page(i)->isChecked()) {
            if (m_pages->page() != static_cast<Page>(i))
                m_pages->show(static_cast<Page>(i));
            return;
        }
    m_actions.page(static_cast<int>(m_pages->page()))->setChecked(true);
}

void MainWindow::connectActions() {
    const auto on = [this](QAction* action, auto slot) { connect(action, &QAction::triggered, this, slot); };
    on(m_actions.newExperiment, [this] { m_files.newExperiment(); });
    on(m_actions.open, [this] { m_files.askAndOpen(); });
    on(m_actions.save, [this] { m_files.save(); });
    on(m_actions.saveAs, [this] { m_files.saveAs(); });
    on(m_actions.saveSession, [this] { m_files.saveSession(); });
    on(m_actions.quit, [this] { close(); });
    on(m_actions.labels, [this] { askLabels(false); });
    connect(m_stateBar, &StateBar::labelsRequested, this, [this] { askLabels(false); });
    on(m_actions.allAlarms, [this] { m_pages->showAllAlarms(); });
    on(m_actions.homeRobot, [this] { askHome(); });
    on(m_actions.endRecording, [this] { m_engine.send(EndRecording{}); });
    on(m_actions.acknowledgeAlarms, [this] { m_engine.send(AcknowledgeAll{}); });
    on(m_actions.manual, [this] { showManual(QStringLiteral("manual.md")); });
    on(m_actions.firstFiveMinutes, [this] { m_coach->begin(); });
    on(m_actions.reportProblem, [this] { reportProblem(); });
    on(m_actions.about, [this] { showAbout(this); });
    m_undo = new UndoActions(m_document, m_actions.undo, m_actions.redo, this);
    m_pages->objects()->setUndoActions(m_actions.undo, m_actions.redo);
    connect(m_undo, &UndoActions::undone, m_pages, &PageHost::showUndone);
    connect(m_undo, &UndoActions::redone, m_pages, &PageHost::showRedone);
    connect(&m_actions, &Actions::verbTriggered, this, &MainWindow::perform);
    connect(&m_actions, &Actions::verbRefused, this, &MainWindow::sayWhyNot);
    connect(m_stateBar, &StateBar::verbRefused, this, &MainWindow::sayWhyNot);
    const auto sayAtTheFoot = [this](const QString& words) {
        m_statusLine->showMessage(words, static_cast<int>(std::chrono::milliseconds(kWhyNot).count()));
    };
    connect(&m_actions, &Actions::keyRefused, this, sayAtTheFoot);
    connect(m_pages, &PageHost::toldAside, this, sayAtTheFoot);
    connect(&m_actions, &Actions::pageChosen, this,
            [this](int page) { m_pages->show(static_cast<Page>(page)); });
    connect(&m_actions, &Actions::unitChosen, this, &MainWindow::setTemperatureUnit);
    connect(&m_actions, &Actions::themeChosen, this, &MainWindow::setTheme);
    connect(&m_actions, &Actions::textSizeChosen, this, &MainWindow::setTextSize);
    connect(&m_actions, &Actions::hornModeChosen, this, &MainWindow::setHornMode);
    connect(&m_actions, &Actions::languageChosen, this, &MainWindow::setLanguage);
    connect(&m_actions, &Actions::exampleChosen, this,
            [this](const QString& name) { m_files.openExample(name); });
    connect(&m_actions, &Actions::recentChosen, this, [this](const QString& path) { m_files.open(path); });
    connect(&m_actions, &Actions::recentCleared, this, [this] {
        m_settings.clearRecentFiles();
        m_actions.setRecent({});
    });
    connect(&m_actions.faults(), &FaultMenu::faultChosen, this,
            [this](const SimulateFault& fault) { m_engine.send(fault); });
}

void MainWindow::connectParts() {
    m_files.setRunGuard([this] { return !allowsEdits(m_last.state); });
    m_files.setRigGuard([this] { return m_last.heatOn || m_last.isMoving || m_last.pending.has_value(); });
    connect(&m_engine, &EngineClient::snapshot, this, &MainWindow::apply);
    connect(&m_engine, &EngineClient::looked, m_pages,
            [this](const std::shared_ptr<const VisionView>& view) { m_pages->show(*view); });
    connect(&m_engine, &EngineClient::sawHeat, m_pages,
            [this](const std::shared_ptr<const ThermalView>& view) { m_pages->show(*view); });
    connect(&m_engine, &EngineClient::answeringChanged, m_stateBar, &StateBar::setAnswering);
    connect(&m_engine, &EngineClient::answeringChanged, m_statusLine, &StatusLine::setAnswering);
    connect(&m_engine, &EngineClient::answeringChanged, &m_horn, &Horn::setAnswering);
    connect(&m_engine, &EngineClient::answeringChanged, m_dock, &BottomDock::setAnswering);
    connect(&m_engine, &EngineClient::answeringChanged, m_pages->run(), &RunPage::setAnswering);
    connect(&m_silence, &QTimer::timeout, this, &MainWindow::showSilence);
    connect(&m_engine, &EngineClient::answeringChanged, this, [this](bool answering) {
        if (answering)
            return m_silence.stop();
        m_silence.start(std::chrono::seconds(1));
        showSilence();
    });
    connect(m_pages, &PageHost::commandIssued, this, [this](const Command& command) {
        if (beginsByHand(command) && isAnswerAwaited())
            return;
        if (isManual(command))
            m_recipe->takeOverAtRest();
        else if (std::holds_alternative<Hold>(command))
            m_recipe->takeOver();
        m_engine.send(command);
    });
    connect(m_pages, &PageHost::homeRequested, this, &MainWindow::askHome);
    connect(m_pages, &PageHost::manualRequested, this, &MainWindow::showManual);
    connect(m_pages, &PageHost::pageChanged, this, [this](Page page) {
        m_actions.showPage(static_cast<int>(page));
        m_dock->setReviewing(page == Page::Review);
    });
    connect(m_stateBar, &StateBar::stopRequested, this, [this] { perform(Verb::EmergencyStop); });
    connect(m_stateBar, &StateBar::reasonActivated, this, &MainWindow::showReason);
    connect(m_stateBar, &StateBar::alarmChosen, m_dock, &BottomDock::showAlarm);
    m_dock->setHomeAction(m_actions.homeRobot);
    m_dock->setHistoryAction(m_actions.allAlarms);
    connect(m_dock, &BottomDock::commandIssued, &m_engine, &EngineClient::send);
    connect(m_dock, &BottomDock::timeChosen, m_pages, &PageHost::showMoment);
    connect(&m_files, &SessionActions::recentChanged, this,
            [this] { m_actions.setRecent(m_settings.recentFiles()); });
    connect(&m_files, &SessionActions::recordingChanged, this,
            [this] { m_actions.saveSession->setEnabled(true); });
    connect(&m_document, &Document::opened, m_dock, &BottomDock::beginExperiment);
    connect(&m_document, &Document::changed, this, &MainWindow::showTitle);
    const auto faults = [this] { m_actions.faults().setExperiment(m_document.experiment()); };
    connect(&m_document, &Document::changed, this, &MainWindow::takeAges);
    connect(&m_pages->judge(), &TargetJudge::verdictChanged, this, &MainWindow::showNotes);
    auto* minute = new QTimer(this);
    connect(minute, &QTimer::timeout, this, &MainWindow::takeAges);
    minute->start(std::chrono::minutes(1));
    connect(&m_document, &Document::opened, this, faults);
    connect(&m_document, &Document::edited, this, faults);
    connect(&m_document, &Document::visionChanged, this, faults);
    m_cutOff = new CutOffRun(m_pages->cutOffBar(), runMarkFolder(), this);
    connect(m_cutOff, &CutOffRun::openWanted, &m_files, &SessionActions::open);
    m_recovery = new RecoveryOffer(m_pages->questionBar(), m_document, m_autosave, m_files, this);
    connect(&m_autosave, &Autosave::failed, this, [this](const Error& error) {
        m_pages->showProblem(tr("Unsaved edits cannot be kept for a crash: %1").arg(sentence(error)));
    });
    m_monitor = new MonitorControl(monitorFile(), m_files, this);
    connect(m_monitor, &MonitorControl::stateTold, m_statusLine,
            qOverload<const MonitorState&>(&StatusLine::showMonitor));
    connect(m_monitor, &MonitorControl::problem, m_pages, &PageHost::showProblem);
    connect(m_actions.monitoring, &QAction::triggered, m_monitor, &MonitorControl::askSettings);
    m_materials = new MaterialControl(materialFile(), m_files, *m_pages->objects(), this);
    connect(m_materials, &MaterialControl::problem, m_pages, &PageHost::showProblem);
    connect(m_materials, &MaterialControl::exported, m_pages, &PageHost::showExported);
    auto* largeNumbers = new LargeNumbersControl(*m_pages->run(), this);
    connect(m_actions.largeNumbers, &QAction::triggered, largeNumbers, &LargeNumbersControl::setOpen);
    connect(largeNumbers, &LargeNumbersControl::openChanged, m_actions.largeNumbers, &QAction::setChecked);
    connect(largeNumbers, &LargeNumbersControl::stopRequested, m_stateBar, &StateBar::stopRequested);
    connect(&m_engine, &EngineClient::answeringChanged, largeNumbers, &LargeNumbersControl::setAnswering);
    auto* plotWindows = new PlotWindowsControl(this);
    connect(this, &MainWindow::snapshotApplied, plotWindows, &PlotWindowsControl::apply);
    connect(&m_engine, &EngineClient::answeringChanged, plotWindows, &PlotWindowsControl::setAnswering);
    for (const PlotPlace* place : findChildren<PlotPlace*>())
        connect(place, &PlotPlace::exportRequested, &m_files,
                [this, place](PlotForm form) { m_files.exportPlot(*place, form); });
    connectRecipe();
    connectCoach();
}

void MainWindow::connectRecipe() {
    m_recipe = new RecipeControl(m_document, m_files, m_dock->recipe(), m_pages->recipeBar(), this);
    connect(m_recipe, &RecipeControl::commandIssued, &m_engine, &EngineClient::send);
    connect(m_recipe, &RecipeControl::problem, m_pages, &PageHost::showProblem);
    connect(m_recipe, &RecipeControl::told, this, // also of its end, to who comes back later
            [this](const QString& sentence) { m_pages->messages().showNote(sentence); });
    connect(m_recipe, &RecipeControl::showWanted, m_dock, &BottomDock::showRecipe);
    m_files.setRecipeGuard([this] { return m_recipe->isOn(); });
    connect(&m_files, &SessionActions::recipeChosen, m_recipe, &RecipeControl::open);
    connect(m_dock, &BottomDock::heightWanted, this, [this](int height) {
        resizeDocks({m_dock}, {height}, Qt::Vertical);
        layout()->invalidate();
        layout()->activate(); // a busy window's would follow later, when something else may be in front
    });
}

void MainWindow::connectCoach() {
    m_coach = new Coach(m_pages->coachBar(), this);
    connect(&m_document, &Document::changed, m_coach, [this] {
        if (const EditStep* step = m_document.toUndo())
            m_coach->see(*step);
    });
    connect(m_undo, &UndoActions::undone, m_coach, &Coach::seeUndone);
    connect(&m_pages->judge(), &TargetJudge::verdictChanged, m_coach, [this] {
        const auto& verdict = m_pages->judge().verdict();
        if (verdict && !m_pages->judge().isStale())
            m_coach->seeVerdict(verdict->feasible);
    });
    connect(this, &MainWindow::snapshotApplied, m_coach, qOverload<const Snapshot&>(&Coach::see));
    connect(&m_files, &SessionActions::sessionOpened, m_coach, &Coach::seeReview);
    connect(&m_engine, &EngineClient::sawHeat, m_coach, &Coach::seeThermalPicture);
    connect(m_coach, &Coach::showWanted, this, &MainWindow::showControl);
    connect(m_coach, &Coach::answered, this, [this] { m_settings.setCoachAnswered(); });
}

} // namespace bask
