#include "app/actions.h"

#include "app/examples.h"
#include "app/icons.h"
#include "app/page.h"
#include "app/settings_store.h"
#include "app/why_not.h"
#include "engine/base/message_code.h"
#include "widgets/common/language.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QMenu>
#include <QMenuBar>
#include <QRegularExpression>

#include <algorithm>

namespace bask {
namespace {

constexpr auto kArmKey = Qt::Key_F5; ///< on Review it reads the list again
constexpr std::array kVerbNames{"arm",  "start",   "hold",          "resume",
                                "stop", "retreat", "emergencyStop", "reset"};
constexpr std::array kVerbIcons{"arm", "start", "hold", "resume", "stop", "retreat", "", "reset"};
constexpr std::array kPageNames{"rig", "objects", "calibrate", "targets", "run", "review"};
constexpr std::array kUnits{TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit};
constexpr std::array kUnitNames{"celsius", "kelvin", "fahrenheit"};
constexpr std::array kThemes{Theme::System, Theme::Light, Theme::Dark};
constexpr std::array kHornModes{HornMode::Off, HornMode::RealRig, HornMode::Always};
constexpr std::array kHornNames{"hornOff", "hornOnRealRig", "hornAlways"};
constexpr std::array kThemeNames{"system", "light", "dark"};

/// Names of files and objects are shown as they are: no mnemonics in them.
QString plain(QString text) {
    return text.replace(u'&', QStringLiteral("&&"));
}

} // namespace

bool allows(const Snapshot& snapshot, Verb verb) {
    const RunState state = snapshot.state;
    switch (verb) {
    case Verb::Arm:
        return state == RunState::Ready ||
               (state == RunState::Stopped &&
                std::ranges::none_of(snapshot.reasons, isUnfitTarget, &Message::code));
    case Verb::Start:
        return state == RunState::Armed;
    case Verb::Hold:
        return state == RunState::Running || state == RunState::Settled || snapshot.isMoving;
    case Verb::Resume:
        return state == RunState::Holding;
    case Verb::Stop:
        return state == RunState::Armed || state == RunState::Running || state == RunState::Holding ||
               state == RunState::Settled;
    case Verb::Retreat:
        return snapshot.canRetreat;
    case Verb::EmergencyStop:
        return true;
    case Verb::Reset:
        return state == RunState::Fault;
    }
    return false;
}

bool allowsEdits(RunState state) {
    return state != RunState::Armed && !isRunOn(state);
}

bool isUnfitTarget(MessageCode reason) {
    return reason == MessageCode::TargetAboveWarning || reason == MessageCode::TargetNotTold;
}

Actions::Actions(QWidget* window) : QObject(window), m_window(window), m_deafKeys(window), m_faults(window) {
    newExperiment = make("newExperiment", QKeySequence::New);
    open = make("open", QKeySequence::Open);
    save = make("save", QKeySequence::Save);
    saveAs = make("saveAs", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    saveSession = make("saveSession", QKeySequence(Qt::CTRL | Qt::Key_E));
    quit = make("quit", QKeySequence(Qt::CTRL | Qt::Key_Q));
    quit->setMenuRole(QAction::QuitRole);
    undo = make("editUndo", QKeySequence::Undo);
    redo = make("editRedo");
    redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    homeRobot = make("homeTheRobot");
    endRecording = make("endRecording");
    acknowledgeAlarms = make("acknowledgeAlarms", QKeySequence(Qt::Key_F9));
    allAlarms = make("allAlarms");
    largeNumbers = make("largeNumbers");
    largeNumbers->setCheckable(true);
    monitoring = make("monitoring");
    labels = make("labels", QKeySequence(Qt::CTRL | Qt::Key_L));
    m_clearRecent = make("clearRecent");
    connect(m_clearRecent, &QAction::triggered, this, &Actions::recentCleared);
    manual = make("manual", QKeySequence(Qt::Key_F1));
    firstFiveMinutes = make("firstFiveMinutes");
    reportProblem = make("reportProblem");
    about = make("about");
    about->setMenuRole(QAction::AboutRole);
    saveSession->setEnabled(false);

    for (QMenu** menu :
         {&m_fileMenu, &m_exampleMenu, &m_recentMenu, &m_editMenu, &m_runMenu, &m_viewMenu, &m_unitMenu,
          &m_themeMenu, &m_textSizeMenu, &m_hornMenu, &m_languageMenu, &m_toolsMenu, &m_helpMenu})
        *menu = new QMenu(window);
    m_fileMenu->setToolTipsVisible(true);
    m_editMenu->setToolTipsVisible(true);
    m_runMenu->setToolTipsVisible(true);
    m_toolsMenu->setToolTipsVisible(true);
    m_recentMenu->setObjectName(QStringLiteral("recentMenu"));
    m_fileMenu->setObjectName(QStringLiteral("fileMenu"));
    m_editMenu->setObjectName(QStringLiteral("editMenu"));
    m_toolsMenu->setObjectName(QStringLiteral("toolsMenu"));
    for (const QString& name : exampleNames())
        connect(m_exampleMenu->addAction(name), &QAction::triggered, this,
                [this, name] { emit exampleChosen(name); });
    makeVerbs();
    makeView();
    for (QAction* action : m_window->actions())
        m_deafKeys.watch(action);
    connect(&m_deafKeys, &DeafKeys::pressed, this, &Actions::hear);
    connect(saveSession, &QAction::enabledChanged, this, &Actions::showReasons);
    retranslate();
}

/// The tip of an action that is not possible says why.
void Actions::hear(QAction* deaf) {
    const auto verb = std::ranges::find(m_verbs, deaf);
    if (verb != m_verbs.end())
        emit verbRefused(static_cast<Verb>(verb - m_verbs.begin()));
    else
        emit keyRefused(deaf->toolTip().replace(u'\n', u' '));
}

QAction* Actions::make(const char* name, const QKeySequence& keys) {
    auto* action = new QAction(m_window);
    action->setObjectName(QLatin1String(name));
    action->setShortcut(keys);
    m_window->addAction(action);
    return action;
}

void Actions::makeVerbs() {
    const std::array keys{QKeySequence(kArmKey),    QKeySequence(Qt::Key_F6),
                          QKeySequence(Qt::Key_F7), QKeySequence(Qt::SHIFT | Qt::Key_F7),
                          QKeySequence(Qt::Key_F8), QKeySequence(Qt::SHIFT | Qt::Key_F8),
                          QKeySequence(),           QKeySequence()};
    for (std::size_t i = 0; i < m_verbs.size(); ++i) {
        m_verbs[i] = make(kVerbNames[i], keys[i]);
        m_verbs[i]->setEnabled(static_cast<Verb>(i) == Verb::EmergencyStop);
        connect(m_verbs[i], &QAction::triggered, this,
                [this, i] { emit verbTriggered(static_cast<Verb>(i)); });
    }
}

void Actions::makeView() {
    const auto group = [this] {
        auto* made = new QActionGroup(this);
        made->setExclusive(true);
        return made;
    };
    const auto checkable = [this](QActionGroup* in, const char* name, const QKeySequence& keys = {}) {
        QAction* action = make(name, keys);
        action->setCheckable(true);
        in->addAction(action);
        return action;
    };
    m_pageGroup = group();
    m_unitGroup = group();
    m_themeGroup = group();
    m_textSizeGroup = group();
    m_hornGroup = group();
    m_languageGroup = group();
    for (std::size_t i = 0; i < kPageNames.size(); ++i) {
        m_pages[i] =
            checkable(m_pageGroup, kPageNames[i], QKeySequence(Qt::CTRL | (Qt::Key_1 + static_cast<int>(i))));
        connect(m_pages[i], &QAction::triggered, this, [this, i] { emit pageChosen(static_cast<int>(i)); });
    }
    for (std::size_t i = 0; i < kUnits.size(); ++i) {
        m_units[i] = checkable(m_unitGroup, kUnitNames[i]);
        connect(m_units[i], &QAction::triggered, this, [this, i] { emit unitChosen(kUnits[i]); });
        m_themes[i] = checkable(m_themeGroup, kThemeNames[i]);
        connect(m_themes[i], &QAction::triggered, this, [this, i] { emit themeChosen(kThemes[i]); });
        m_horns[i] = checkable(m_hornGroup, kHornNames[i]);
        connect(m_horns[i], &QAction::triggered, this, [this, i] { emit hornModeChosen(kHornModes[i]); });
    }
    for (const int percent : SettingsStore::kTextSizes_percent) {
        QAction* action = checkable(m_textSizeGroup, "textSize");
        action->setText(QStringLiteral("%1 %").arg(percent));
        action->setData(percent);
        m_textSizes << action;
        connect(action, &QAction::triggered, this, [this, percent] { emit textSizeChosen(percent); });
    }
    for (const QString& code : Language::codes()) {
        QAction* action = checkable(m_languageGroup, "language");
        action->setText(Language::ownName(code));
        action->setData(code);
        m_languages << action;
        connect(action, &QAction::triggered, this, [this, code] { emit languageChosen(code); });
    }
}

void Actions::fillMenus(QMenuBar* bar) {
    m_fileMenu->addActions({newExperiment, open});
    m_fileMenu->addMenu(m_exampleMenu);
    m_fileMenu->addMenu(m_recentMenu);
    m_fileMenu->addSeparator();
    m_fileMenu->addActions({save, saveAs, saveSession});
    m_fileMenu->addSeparator();
    m_fileMenu->addAction(quit);
    m_editMenu->addActions({undo, redo});
    for (const Verb each : {Verb::Arm, Verb::Start, Verb::Hold, Verb::Resume, Verb::Stop, Verb::Retreat})
        m_runMenu->addAction(verb(each));
    m_runMenu->addSeparator();
    m_runMenu->addActions({verb(Verb::EmergencyStop), homeRobot, verb(Verb::Reset)});
    m_runMenu->addSeparator();
    m_runMenu->addActions({labels, endRecording, acknowledgeAlarms});
    for (QAction* action : m_pages)
        m_viewMenu->addAction(action);
    m_viewMenu->addSeparator();
    m_viewMenu->addMenu(m_unitMenu);
    m_viewMenu->addMenu(m_themeMenu);
    m_viewMenu->addMenu(m_textSizeMenu);
    m_viewMenu->addMenu(m_hornMenu);
    m_viewMenu->addMenu(m_languageMenu);
    m_viewMenu->addSeparator();
    m_viewMenu->addActions({allAlarms, largeNumbers, monitoring});
    for (QAction* action : m_units)
        m_unitMenu->addAction(action);
    for (QAction* action : m_themes)
        m_themeMenu->addAction(action);
    for (QAction* action : m_horns)
        m_hornMenu->addAction(action);
    m_textSizeMenu->addActions(m_textSizes);
    m_languageMenu->addActions(m_languages);
    m_toolsMenu->addMenu(m_faults.menu());
    m_helpMenu->addActions({manual, firstFiveMinutes, reportProblem});
    m_helpMenu->addSeparator();
    m_helpMenu->addAction(about);
    for (QMenu* menu : {m_fileMenu, m_editMenu, m_runMenu, m_viewMenu, m_toolsMenu, m_helpMenu})
        bar->addMenu(menu);
}

void Actions::retranslate() {
    retranslateFile();
    retranslateRun();
    retranslateView();
    showReasons();
}

void Actions::retranslateFile() {
    m_fileMenu->setTitle(tr("&File"));
    m_exampleMenu->setTitle(tr("&Examples"));
    m_recentMenu->setTitle(tr("&Recent files"));
    m_editMenu->setTitle(tr("&Edit"));
    m_helpMenu->setTitle(tr("&Help"));
    newExperiment->setText(tr("&New experiment"));
    open->setText(tr("&Open…"));
    open->setToolTip(tr("Open an experiment (*.json) or a recorded session (*.bask)"));
    save->setText(tr("&Save experiment"));
    saveAs->setText(tr("Save experiment &as…"));
    saveSession->setText(tr("Save sess&ion…"));
    quit->setText(tr("&Quit"));
    m_clearRecent->setText(tr("&Clear the list"));
    manual->setText(tr("&Manual"));
    firstFiveMinutes->setText(tr("The &first five minutes"));
    reportProblem->setText(tr("Report a &problem…"));
    about->setText(tr("&About Bask"));
}

void Actions::retranslateRun() {
    m_runMenu->setTitle(tr("&Run"));
    const auto say = [this](Verb which, const QString& text, const QString& meaning) {
        QAction* action = verb(which);
        action->setText(text);
        // A button does without the letter that stands behind a Chinese word in the menu.
        action->setIconText(QString(text).remove(QRegularExpression(QStringLiteral("\\(&.\\)|&|…"))));
        m_meanings.at(static_cast<std::size_t>(which)) = meaning;
        showTip(which);
    };
    say(Verb::Arm, tr("&Arm"),
        tr("Zero the sensors at ambient and open the recording. Nothing moves or heats yet."));
    say(Verb::Start, tr("S&tart"), tr("Open the heat and servo every object to its target."));
    say(Verb::Hold, tr("&Hold"),
        tr("Zero velocity; the controller keeps its state and Resume goes on from here."));
    say(Verb::Resume, tr("R&esume"), tr("Go on from where the run was held."));
    say(Verb::Stop, tr("Sto&p"),
        tr("End the run: heat off, retreat upwards, close the recording. While armed: disarm."));
    say(Verb::Retreat, tr("&Retreat…"),
        tr("The robot takes the objects away from the source and the heat goes off, in every state in which "
           "the "
           "robot answers. A fault stays latched."));
    // The key belongs to the STOP button, which hears it even with a menu or a dialog open.
    say(Verb::EmergencyStop, tr("STOP now") + QStringLiteral("\tF12"),
        tr("Zero velocity and heat off now, latched. A software stop, not a safety-rated emergency stop."));
    say(Verb::Reset, tr("Re&set"), tr("Clear a latched stop or fault. It never starts anything."));
    labels->setText(tr("&Operator and sample…"));
    labels->setToolTip(
        tr("Who operates, and what is heated: recordings, reports and the list of runs show it."));
    homeRobot->setText(tr("Ho&me the robot…"));
    endRecording->setText(tr("End the re&cording"));
    acknowledgeAlarms->setText(tr("Ac&knowledge all alarms"));
}

/// With the key that it has now; its button may have its icon alone.
void Actions::showTip(Verb which) {
    const QString keys = verb(which)->shortcut().toString(QKeySequence::NativeText);
    const QString tip = verb(which)->iconText() + u'\n' + m_meanings.at(static_cast<std::size_t>(which));
    verb(which)->setToolTip(keys.isEmpty() ? tip : tip + QStringLiteral(" (%1)").arg(keys));
}

void Actions::retranslateView() {
    m_viewMenu->setTitle(tr("&View"));
    const std::array pages{tr("Rig"), tr("Objects"), tr("Calibrate"), tr("Targets"), tr("Run"), tr("Review")};
    const std::array tips{tr("The devices, what must be so before a run, and the robot and the heat by hand"),
                          tr("What is held in front of the source: outlines, materials, mounting"),
                          tr("The camera: its lens, where it stands, and where the source is"),
                          tr("What temperature each object shall have, and whether it can be reached"),
                          tr("Temperatures, the scene and the controller during a run"),
                          tr("A recorded run, opened again")};
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        m_pages[i]->setText(pages[i]);
        m_pages[i]->setToolTip(QStringLiteral("%1 (%2)").arg(
            tips[i], m_pages[i]->shortcut().toString(QKeySequence::NativeText)));
    }
    m_unitMenu->setTitle(tr("Temperature &unit"));
    m_units[0]->setText(tr("Degrees Celsius (°C)"));
    m_units[1]->setText(tr("Kelvin (K)"));
    m_units[2]->setText(tr("Degrees Fahrenheit (°F)"));
    m_themeMenu->setTitle(tr("&Theme"));
    m_themes[0]->setText(tr("As the desktop"));
    m_themes[1]->setText(tr("Light"));
    m_themes[2]->setText(tr("Dark"));
    m_textSizeMenu->setTitle(tr("Te&xt size"));
    m_hornMenu->setTitle(tr("Alarm &horn"));
    m_horns[0]->setText(tr("Off"));
    m_horns[1]->setText(tr("On a real rig"));
    m_horns[2]->setText(tr("Always"));
    for (QAction* action : m_horns)
        action->setToolTip(tr("The desktop's bell, until alarms of priority 1 and 2 are acknowledged or "
                              "over; once for priority 3"));
    m_languageMenu->setTitle(tr("&Language"));
    allAlarms->setText(tr("All &alarms…"));
    allAlarms->setToolTip(tr("The alarms of all recorded runs, with how often and when"));
    largeNumbers->setText(tr("Large &numbers"));
    monitoring->setText(tr("&Monitoring…"));
    m_toolsMenu->setTitle(tr("&Tools"));
    m_faults.retranslate();
}

void Actions::restyle(const QPalette& palette) {
    for (std::size_t i = 0; i < m_verbs.size(); ++i)
        if (*kVerbIcons[i] != '\0')
            m_verbs[i]->setIcon(themedIcon(QLatin1String(kVerbIcons[i]), palette));
    for (std::size_t i = 0; i < m_pages.size(); ++i)
        m_pages[i]->setIcon(themedIcon(QLatin1String(kPageNames[i]), palette));
}

void Actions::apply(const Snapshot& snapshot) {
    for (std::size_t i = 0; i < m_verbs.size(); ++i) {
        m_verbs[i]->setEnabled(allows(snapshot, static_cast<Verb>(i)));
    }
    m_told.state = snapshot.state;
    m_told.place = snapshot.place;
    m_told.recordingPath = snapshot.recordingPath;
    m_told.alarms = snapshot.alarms;
    showReasons();
    m_faults.apply(snapshot);
}

void Actions::showReasons() {
    const auto show = [](QAction* action, const QString& usual, const QString& why) {
        action->setEnabled(why.isEmpty());
        action->setToolTip(why.isEmpty() ? usual : why);
    };
    const QString whyNotOther = whyNotAnother(m_told);
    show(newExperiment, {}, whyNotOther);
    m_exampleMenu->setEnabled(whyNotOther.isEmpty());
    m_exampleMenu->menuAction()->setToolTip(whyNotOther);
    show(homeRobot, tr("The robot seeks its switches to know its place: it moves"), whyNotHome(m_told));
    show(endRecording,
         tr("After a stop or a fault the recording goes on until everything is cold. This ends it now."),
         whyNotEndRecording(m_told));
    show(acknowledgeAlarms, tr("You have seen all alarms. Those that are over leave the list. (F9)"),
         whyNotAcknowledge(m_told));
    saveSession->setToolTip(saveSession->isEnabled()
                                ? tr("Copy the recording of the present or last run to a file of your choice")
                                : whyNotSaveSession());
}

void Actions::setRecent(const QStringList& files) {
    m_recentMenu->clear();
    m_recentMenu->setEnabled(!files.isEmpty());
    m_recentMenu->setToolTipsVisible(true);
    for (const QString& file : files) {
        const QFileInfo info(file);
        const auto namesake = [&](const QString& other) {
            return other != file && QFileInfo(other).fileName() == info.fileName();
        };
        QString text = info.fileName();
        if (std::ranges::any_of(files, namesake))
            text += QStringLiteral(" (%1)").arg(info.path());
        QAction* action = m_recentMenu->addAction(plain(text));
        action->setToolTip(file);
        connect(action, &QAction::triggered, this, [this, file] { emit recentChosen(file); });
    }
    m_recentMenu->addSeparator();
    m_recentMenu->addAction(m_clearRecent);
}

void Actions::showTemperatureUnit(TemperatureUnit unit) {
    for (std::size_t i = 0; i < kUnits.size(); ++i)
        m_units[i]->setChecked(kUnits[i] == unit);
}

void Actions::showTheme(Theme theme) {
    for (std::size_t i = 0; i < kThemes.size(); ++i)
        m_themes[i]->setChecked(kThemes[i] == theme);
}

void Actions::showHornMode(HornMode mode) {
    for (std::size_t i = 0; i < kHornModes.size(); ++i)
        m_horns[i]->setChecked(kHornModes[i] == mode);
}

void Actions::showTextSize(int percent) {
    for (QAction* action : m_textSizes)
        action->setChecked(action->data().toInt() == percent);
}

void Actions::showLanguage(const QString& code) {
    for (QAction* action : m_languages)
        action->setChecked(action->data().toString() == code);
}

void Actions::showPage(int index) {
    page(index)->setChecked(true);
    const bool isForReading = index == static_cast<int>(Page::Review);
    verb(Verb::Arm)->setShortcut(isForReading ? QKeySequence() : QKeySequence(kArmKey));
    showTip(Verb::Arm);
}

} // namespace bask
