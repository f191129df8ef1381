#include "app/bottom_dock.h"

#include "app/error_text.h"
#include "engine/base/notice.h"
#include "widgets/common/alarm_list.h"
#include "widgets/common/event_list.h"
#include "widgets/common/run_label_words.h"
#include "widgets/common/theme.h"
#include "widgets/recipe/recipe_panel.h"

#include <QApplication>
#include <QEvent>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>

#include <algorithm>

namespace bask {
namespace {

constexpr int kRecipeHeight = 230;
constexpr int kManyAlarms = 99; // their tab has room for so many

/// Tabs that stay where they are when an alarm comes: one with a text as its data has room for that text and
/// a mark.
class SteadyTabs : public QTabWidget {
public:
    explicit SteadyTabs(QWidget* parent) : QTabWidget(parent) { setTabBar(new Bar(this)); }

private:
    class Bar : public QTabBar {
    public:
        using QTabBar::QTabBar;

    protected:
        QSize tabSizeHint(int index) const override {
            QSize size = QTabBar::tabSizeHint(index);
            const QString widest = tabData(index).toString();
            if (widest.isEmpty())
                return size;
            constexpr int kIconGap = 4;
            const QFontMetrics metrics = fontMetrics();
            const int more = metrics.horizontalAdvance(widest) - metrics.horizontalAdvance(tabText(index));
            size.rwidth() += std::max(0, more);
            if (tabIcon(index).isNull())
                size.rwidth() += iconSize().width() + kIconGap;
            return size;
        }
    };
};

} // namespace

BottomDock::BottomDock(QWidget* parent)
    : QDockWidget(parent), m_tabs(new SteadyTabs(this)), m_history(new QToolButton(this)),
      m_alarmList(new AlarmList), m_eventList(new EventList), m_recipe(new RecipePanel) {
    setObjectName(QStringLiteral("eventDock"));
    setFeatures(NoDockWidgetFeatures);
    setTitleBarWidget(new QWidget(this)); // none: the tabs say what is here
    m_tabs->setObjectName(QStringLiteral("dockTabs"));
    m_tabs->setDocumentMode(true);
    m_tabs->setIconSize({14, 14});
    for (QWidget* list : std::initializer_list<QWidget*>{m_alarmList, m_eventList}) {
        list->setContentsMargins(8, 2, 8, 4);
        m_tabs->addTab(list, QString());
    }
    m_tabs->addTab(m_recipe, QString());
    m_history->setObjectName(QStringLiteral("allAlarmsButton"));
    m_history->setAutoRaise(true);
    m_history->setFocusPolicy(Qt::StrongFocus);
    m_tabs->setCornerWidget(m_history);
    m_tabs->setCurrentWidget(m_eventList);
    setWidget(m_tabs);

    connect(m_alarmList, &AlarmList::acknowledgeRequested, this,
            [this](quint64 id) { emit commandIssued(AcknowledgeAlarm{id}); });
    connect(m_alarmList, &AlarmList::acknowledgeAllRequested, this,
            [this] { emit commandIssued(AcknowledgeAll{}); });
    connect(m_alarmList, &AlarmList::shelveRequested, this,
            [this](quint64 id, double for_s, const QString& reason) {
                emit commandIssued(ShelveAlarm{id, for_s, reason.toStdString()});
            });
    connect(m_alarmList, &AlarmList::unshelveRequested, this,
            [this](quint64 id) { emit commandIssued(UnshelveAlarm{id}); });
    connect(m_eventList, &EventList::timeChosen, this, &BottomDock::timeChosen);
    connect(m_tabs, &QTabWidget::currentChanged, this, &BottomDock::fit);
    fit();
    retranslate();
}

/// The recipe, when it is not in front, does not keep the dock from being low.
void BottomDock::fit() {
    const bool isRecipe = m_tabs->currentWidget() == m_recipe;
    const auto policy = isRecipe ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    m_recipe->setSizePolicy(policy, policy);
    for (QWidget* part = m_recipe->parentWidget(); part != this; part = part->parentWidget())
        part->updateGeometry(); // now: the height is asked for before the layouts are told
    if (isRecipe) {
        m_lowHeight = height();
        emit heightWanted(std::max(m_lowHeight, std::min(kRecipeHeight, window()->height() / 3)));
    } else if (m_lowHeight > 0) {
        emit heightWanted(std::min(height(), std::exchange(m_lowHeight, 0)));
    }
}

void BottomDock::showRecipe() {
    m_tabs->setCurrentWidget(m_recipe);
}

void BottomDock::apply(const Snapshot& snapshot) {
    takeRows(snapshot);
    if (snapshot.alarms != m_alarms)
        takeAlarms(snapshot.alarms);
    m_alarmList->setAlarms(snapshot.alarms); // also the day changes
}

void BottomDock::takeAlarms(const std::vector<Alarm>& alarms) {
    const bool isUrgent = std::ranges::any_of(alarms, [this](const Alarm& alarm) {
        return !alarm.isAcknowledged && !isNotice(alarm.message.code) &&
               std::ranges::none_of(m_alarms, [&](const Alarm& known) {
                   return known.id == alarm.id && known.count == alarm.count;
               });
    });
    m_alarms = alarms;
    m_groups = groupAlarms(alarms);
    showParts();
    if (isUrgent)
        bringAlarmsToFront();
}

void BottomDock::bringAlarmsToFront() {
    const bool hadEventsFocus = m_eventList->isAncestorOf(QApplication::focusWidget());
    m_tabs->setCurrentWidget(m_alarmList);
    m_isBackToEvents = false;
    if (hadEventsFocus) // not on a button: the next key would press it
        m_tabs->tabBar()->setFocus();
}

void BottomDock::takeRows(const Snapshot& snapshot) {
    if (snapshot.runId != m_runId) {
        m_runId = snapshot.runId;
        m_events.clear();
        m_notes.clear();
        beginExperiment();
    }
    for (const TraceEvent& event : snapshot.newEvents) {
        m_events.push_back(event);
        addEvent(event);
    }
    for (const TraceNote& note : snapshot.newNotes) {
        m_notes.push_back(note);
        addNote(note);
    }
}

void BottomDock::addEvent(const TraceEvent& event) {
    m_eventList->add(event.time_s, sentence(event.message), eventKind(event.message.code));
}

void BottomDock::addNote(const TraceNote& note) {
    m_eventList->add(note.time_s, noteText(note), EventKind::Note);
}

void BottomDock::beginExperiment() {
    m_firstEvent = m_events.size();
    m_firstNote = m_notes.size();
    m_eventList->clear();
}

void BottomDock::showEvents() {
    m_eventList->clear();
    auto note = m_notes.begin() + static_cast<std::ptrdiff_t>(m_firstNote);
    for (std::size_t k = m_firstEvent; k < m_events.size(); ++k) {
        for (; note != m_notes.end() && note->time_s < m_events[k].time_s; ++note)
            addNote(*note);
        addEvent(m_events[k]);
    }
    for (; note != m_notes.end(); ++note)
        addNote(*note);
}

void BottomDock::setAnswering(bool answering) {
    m_alarmList->setStale(!answering);
}

void BottomDock::setHomeAction(QAction* home) {
    m_alarmList->setHomeAction(home);
}

void BottomDock::setHistoryAction(QAction* history) {
    m_history->setDefaultAction(history);
    connect(m_alarmList, &AlarmList::historyRequested, history, &QAction::trigger);
}

void BottomDock::setTemperatureUnit(TemperatureUnit unit) {
    m_alarmList->setTemperatureUnit(unit);
    m_recipe->setTemperatureUnit(unit);
    showEvents();
}

void BottomDock::setReviewing(bool isReviewing) {
    if (isReviewing && !m_isReviewing) {
        m_isBackToEvents = m_tabs->currentWidget() == m_eventList;
        if (m_isBackToEvents) // else the recipe would come in its place, and with its height
            m_tabs->setCurrentWidget(m_alarmList);
    }
    const bool isOver = m_isReviewing && !isReviewing;
    m_isReviewing = isReviewing;
    showParts();
    if (isOver && m_isBackToEvents)
        m_tabs->setCurrentWidget(m_eventList);
}

void BottomDock::showAlarm(std::uint64_t id) {
    bringAlarmsToFront();
    m_alarmList->choose(id);
}

void BottomDock::showParts() {
    const int alarmTab = m_tabs->indexOf(m_alarmList);
    const std::vector<AlarmGroup>& present = m_groups.present;
    QString title = present.empty() ? tr("Alarms") : tr("Alarms (%1)").arg(present.size());
    if (!m_groups.shelved.empty())
        title += tr(", %1 shelved", "behind the number of alarms").arg(m_groups.shelved.size());
    m_tabs->tabBar()->setTabData(alarmTab, tr("Alarms (%1)").arg(kManyAlarms));
    m_tabs->setTabText(alarmTab, title);
    const AlarmGroup* const first = gravest(m_groups);
    m_tabs->setTabIcon(alarmTab, first == nullptr
                                     ? QIcon()
                                     : QIcon(alarmPixmap(first->alarm.priority, isDark(this), 14,
                                                         devicePixelRatioF(), !first->isActive())));
    m_tabs->setTabVisible(m_tabs->indexOf(m_eventList), !m_isReviewing);
}

void BottomDock::retranslate() {
    setWindowTitle(tr("Alarms and events"));
    m_tabs->setTabText(m_tabs->indexOf(m_recipe), tr("Recipe"));
    m_tabs->setTabText(m_tabs->indexOf(m_eventList), tr("Events"));
    showParts();
    showEvents();
}

void BottomDock::changeEvent(QEvent* event) {
    QDockWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showParts();
}

} // namespace bask
