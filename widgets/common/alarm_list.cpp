#include "widgets/common/alarm_list.h"

#include "widgets/common/alarm_words.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextEdit>
#include <QTreeWidget>

#include <algorithm>

namespace bask {
namespace {

enum Column { kPriority, kState, kRaised, kTimes, kWhat, kColumns };
constexpr int kIdRole = Qt::UserRole;
constexpr int kRowMark = 16;
constexpr int kGap = 8;

} // namespace

AlarmList::AlarmList(QWidget* parent)
    : QWidget(parent), m_tree(new QTreeWidget(this)), m_guidance(new QTextEdit(this)),
      m_acknowledge(new QPushButton(this)), m_acknowledgeAll(new QPushButton(this)) {
    setObjectName(QStringLiteral("alarmList"));
    m_tree->setObjectName(QStringLiteral("alarmListTree"));
    m_tree->setColumnCount(kColumns);
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIconSize({kRowMark, kRowMark});
    m_tree->setMinimumWidth(240);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the sentence is elided instead
    m_tree->header()->setStretchLastSection(true);
    for (int column = kPriority; column < kWhat; ++column)
        m_tree->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_guidance->setObjectName(QStringLiteral("alarmGuidance"));
    m_guidance->setReadOnly(true);
    m_guidance->setTabChangesFocus(true);
    m_guidance->setFrameShape(QFrame::NoFrame);
    m_guidance->setMinimumWidth(150);
    m_acknowledge->setObjectName(QStringLiteral("acknowledgeAlarm"));
    m_acknowledgeAll->setObjectName(QStringLiteral("acknowledgeAllAlarms"));

    auto* buttons = new QVBoxLayout;
    buttons->addWidget(m_acknowledge);
    buttons->addWidget(m_acknowledgeAll);
    buttons->addStretch(1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGap);
    row->addWidget(m_tree, 5);
    row->addWidget(m_guidance, 3);
    row->addLayout(buttons);

    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, [this] {
        const auto items = m_tree->selectedItems();
        m_chosen.reset();
        if (!items.isEmpty())
            m_chosen = items.first()->data(kPriority, kIdRole).toULongLong();
        showChosen();
    });
    connect(m_acknowledge, &QPushButton::clicked, this, [this] {
        if (m_chosen)
            emit acknowledgeRequested(*m_chosen);
    });
    connect(m_acknowledgeAll, &QPushButton::clicked, this, &AlarmList::acknowledgeAllRequested);
    retranslateUi();
}

void AlarmList::setAlarms(const std::vector<Alarm>& alarms) {
    const QDate today = QDate::currentDate();
    if (alarms == m_alarms && today == m_today)
        return;
    const auto has = [](const std::vector<Alarm>& in, std::uint64_t id) {
        return std::ranges::find(in, id, &Alarm::id) != in.end();
    };
    if (m_chosen && !has(alarms, *m_chosen))
        m_chosen.reset();
    if (!m_chosen) {
        const auto added =
            std::ranges::find_if(alarms, [&](const Alarm& alarm) { return !has(m_alarms, alarm.id); });
        if (added != alarms.end())
            m_chosen = added->id;
    }
    m_alarms = alarms;
    m_today = today;
    showRows();
}

void AlarmList::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m_unit)
        return;
    m_unit = unit;
    showRows();
}

void AlarmList::setStale(bool isStale) {
    if (isStale == m_isStale)
        return;
    m_isStale = isStale;
    showRows();
}

void AlarmList::choose(std::uint64_t id) {
    if (std::ranges::find(m_alarms, id, &Alarm::id) != m_alarms.end())
        m_chosen = id;
    showRows();
    m_tree->scrollToItem(m_tree->currentItem());
    m_tree->setFocus();
}

/// Rows are filled anew, not made anew, so that the view stays where it is.
void AlarmList::showRows() {
    const QSignalBlocker quiet(m_tree);
    const int scrolled = m_tree->verticalScrollBar()->value();
    const auto wanted = static_cast<int>(m_alarms.size());
    while (m_tree->topLevelItemCount() > wanted)
        delete m_tree->topLevelItem(m_tree->topLevelItemCount() - 1);
    while (m_tree->topLevelItemCount() < wanted)
        new QTreeWidgetItem(m_tree);
    m_tree->clearSelection();
    for (int i = 0; i < wanted; ++i) {
        const Alarm& alarm = m_alarms[static_cast<std::size_t>(i)];
        fill(m_tree->topLevelItem(i), alarm);
        if (alarm.id == m_chosen)
            m_tree->setCurrentItem(m_tree->topLevelItem(i));
    }
    m_tree->verticalScrollBar()->setValue(scrolled);
    showChosen();
}

void AlarmList::fill(QTreeWidgetItem* item, const Alarm& alarm) const {
    item->setData(kPriority, kIdRole, QVariant::fromValue<qulonglong>(alarm.id));
    item->setIcon(kPriority, QIcon(alarmPixmap(alarm.priority, isDark(this), kRowMark, devicePixelRatioF())));
    item->setData(kPriority, Qt::AccessibleTextRole, tr("Priority %1").arg(alarm.priority));
    item->setText(kState, alarmStateWords(alarm));
    item->setText(kRaised, alarmTime(alarm.raised_s, m_today));
    item->setText(kTimes, alarm.count > 1 ? tr("%1×").arg(alarm.count) : QString());
    const QString sentence = alarmSentence(alarm, m_unit);
    item->setText(kWhat, sentence);
    item->setToolTip(kWhat, sentence);
    QFont font = m_tree->font();
    font.setBold(!alarm.isAcknowledged);
    font.setItalic(!alarm.isActive);
    const QBrush ink = m_isStale         ? palette().brush(QPalette::Disabled, QPalette::Text)
                       : !alarm.isActive ? QBrush(secondaryText(isDark(this)))
                                         : palette().brush(QPalette::Active, QPalette::Text);
    for (int column = kPriority; column < kColumns; ++column) {
        item->setFont(column, font);
        item->setForeground(column, ink);
    }
}

const Alarm* AlarmList::chosen() const {
    const auto found =
        std::ranges::find_if(m_alarms, [&](const Alarm& alarm) { return alarm.id == m_chosen; });
    return found == m_alarms.end() ? nullptr : &*found;
}

QString AlarmList::guidance() const {
    const Alarm* alarm = chosen();
    if (alarm == nullptr)
        return m_alarms.empty() ? tr("No alarms.") : tr("Choose an alarm to read what to do.");
    QStringList facts{tr("Priority %1. %2.").arg(alarm->priority).arg(alarmStateWords(*alarm))};
    const QString raised = alarmTime(alarm->raised_s, m_today);
    facts << (alarm->count > 1
                  ? tr("Raised at %1, %2 times since it was last acknowledged.").arg(raised).arg(alarm->count)
                  : tr("Raised at %1.").arg(raised));
    if (!alarm->isActive && alarm->cleared_s > 0.0)
        facts << tr("Over at %1.").arg(alarmTime(alarm->cleared_s, m_today));
    if (alarm->isFirst)
        facts << tr("The first of those that came together: likely their cause.");
    if (alarm->isFromBefore)
        facts << tr("It was active when Bask was last left.");
    return QStringLiteral("<p style=\"margin:0\">%1</p><p style=\"margin:4px 0 0 0; color:%2\">%3</p>")
        .arg(alarmSentence(*alarm, m_unit).toHtmlEscaped(), secondaryText(isDark(this)).name(),
             facts.join(u' ').toHtmlEscaped());
}

void AlarmList::showChosen() {
    QString text = guidance();
    if (m_isStale)
        text.prepend(QStringLiteral("<p style=\"margin:0 0 4px 0\"><b>%1</b></p>")
                         .arg(tr("The engine is not answering: these alarms may be old.")));
    if (text != m_shown) // else it would scroll back
        m_guidance->setHtml(m_shown = text);
    const Alarm* alarm = chosen();
    m_acknowledge->setEnabled(!m_isStale && alarm != nullptr && !alarm->isAcknowledged);
    m_acknowledgeAll->setEnabled(!m_isStale && !std::ranges::all_of(m_alarms, &Alarm::isAcknowledged));
}

void AlarmList::retranslateUi() {
    setAccessibleName(tr("Alarms"));
    m_tree->setAccessibleName(accessibleName());
    m_tree->setHeaderLabels({tr("Priority"), tr("State"), tr("Raised"), tr("Times"), tr("What is wrong")});
    m_guidance->setAccessibleName(tr("What to do about the alarm"));
    m_acknowledge->setText(tr("Acknowledge"));
    m_acknowledge->setToolTip(
        tr("You have seen this alarm. It stays in the list while its condition holds."));
    m_acknowledgeAll->setText(tr("Acknowledge all"));
    m_acknowledgeAll->setToolTip(tr("You have seen all alarms. Those that are over leave the list."));
    showRows();
}

void AlarmList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslateUi();
}

} // namespace bask
