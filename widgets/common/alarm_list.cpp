#include "widgets/common/alarm_list.h"

#include "engine/runtime/command.h"
#include "widgets/common/alarm_words.h"
#include "widgets/common/device_words.h"
#include "widgets/common/shelf_popup.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextEdit>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>
#include <initializer_list>

namespace bask {
namespace {

enum Column { kPriority, kState, kRaised, kTimes, kWhat, kColumns };
constexpr int kUnread_ms = 1000; // after which a person can have seen that another alarm is selected
constexpr int kIdRole = Qt::UserRole;
constexpr int kRowMark = 16;
constexpr int kGap = 8;
constexpr int kIndent = 16;
constexpr int kMinTree = 120, kMinGuidance = 100;
constexpr int kLowGuidance = 36; // with Home under it no higher than the list

/// A clock.
QPixmap shelfPixmap(const QColor& ink, double devicePixelRatio) {
    QPixmap pixmap(QSize(kRowMark, kRowMark) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(ink, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawEllipse(QRectF(1.5, 1.5, kRowMark - 3.0, kRowMark - 3.0));
    painter.drawPolyline(QPolygonF{{8.0, 4.5}, {8.0, 8.3}, {10.6, 9.8}});
    return pixmap;
}

/// On a ground of its own in a selected row, whose colour would hide or tint it.
QIcon rowMark(const QPixmap& mark, const QColor& ground) {
    QPixmap selected(mark.size());
    selected.setDevicePixelRatio(mark.devicePixelRatio());
    selected.fill(Qt::transparent);
    QPainter painter(&selected);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(QRectF(0, 0, kRowMark, kRowMark), 3, 3);
    painter.drawPixmap(0, 0, mark);
    painter.end();
    QIcon icon(mark);
    for (const QIcon::State state : {QIcon::Off, QIcon::On})
        icon.addPixmap(selected, QIcon::Selected, state);
    return icon;
}

void fitRows(QTreeWidgetItem* parent, std::size_t wanted) {
    const auto rows = static_cast<int>(wanted);
    while (parent->childCount() > rows)
        delete parent->child(parent->childCount() - 1);
    while (parent->childCount() < rows)
        new QTreeWidgetItem(parent);
}

} // namespace

AlarmList::AlarmList(QWidget* parent)
    : QWidget(parent), m_tree(new QTreeWidget(this)), m_guidance(new QTextEdit(this)),
      m_buttons(new QGridLayout), m_acknowledge(new QPushButton(this)),
      m_acknowledgeAll(new QPushButton(this)), m_shelve(new QToolButton(this)), m_home(new QToolButton(this)),
      m_shelf(new ShelfPopup(this)) {
    setObjectName(QStringLiteral("alarmList"));
    m_tree->setObjectName(QStringLiteral("alarmListTree"));
    m_tree->setColumnCount(kColumns);
    m_tree->setRootIsDecorated(false);
    m_tree->setIndentation(kIndent);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->setIconSize({kRowMark, kRowMark});
    m_tree->setMinimumWidth(kMinTree);
    m_tree->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // the sentence is elided instead
    m_tree->header()->setStretchLastSection(true);
    m_tree->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_tree, &QWidget::customContextMenuRequested, this, &AlarmList::showMenu);
    for (int column = kPriority; column < kWhat; ++column)
        m_tree->header()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    m_guidance->setObjectName(QStringLiteral("alarmGuidance"));
    m_guidance->setReadOnly(true);
    m_guidance->setTabChangesFocus(true);
    m_guidance->setFrameShape(QFrame::NoFrame);
    m_guidance->setMinimumSize(kMinGuidance, kLowGuidance);
    m_acknowledge->setObjectName(QStringLiteral("acknowledgeAlarm"));
    m_acknowledgeAll->setObjectName(QStringLiteral("acknowledgeAllAlarms"));

    m_shelve->setObjectName(QStringLiteral("shelveAlarm"));
    m_shelve->setFocusPolicy(Qt::StrongFocus);
    m_shelve->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_home->setObjectName(QStringLiteral("homeFromAlarm"));
    m_home->setFocusPolicy(Qt::StrongFocus);
    m_home->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_home->hide();

    m_shelve->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    m_buttons->setHorizontalSpacing(kGap / 2);
    m_buttons->setColumnStretch(0, 1);
    m_buttons->setRowStretch(3, 1);
    placeButtons(false);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGap);
    row->addWidget(m_tree, 5);
    auto* words = new QVBoxLayout;
    words->setSpacing(kGap / 2);
    words->addWidget(m_guidance, 1);
    words->addWidget(m_home);
    row->addLayout(words, 3);
    row->addLayout(m_buttons);

    connect(m_tree, &QTreeWidget::itemSelectionChanged, this, [this] {
        const auto items = m_tree->selectedItems();
        m_chosen.reset();
        if (!items.isEmpty() && items.first()->data(kPriority, kIdRole).isValid())
            m_chosen = items.first()->data(kPriority, kIdRole).toULongLong();
        m_isChosenByPerson = m_chosen.has_value();
        showChosen();
    });
    connect(m_tree, &QTreeWidget::itemExpanded, this,
            [this](const QTreeWidgetItem* item) { setFolded(item, false); });
    connect(m_tree, &QTreeWidget::itemCollapsed, this, [this](QTreeWidgetItem* item) {
        setFolded(item, true);
        const auto items = m_tree->selectedItems();
        if (!items.isEmpty() && items.first()->parent() == item)
            m_tree->setCurrentItem(item); // Acknowledge is of a row that is seen
    });
    connect(m_shelve, &QToolButton::clicked, this, &AlarmList::openShelf);
    connect(m_shelf, &ShelfPopup::shelveRequested, this, &AlarmList::shelveRequested);
    connect(m_acknowledge, &QPushButton::clicked, this, [this] {
        if (m_unread.isActive())
            return;
        m_acknowledged = m_chosen;
        if (m_chosen)
            emit acknowledgeRequested(*m_chosen);
    });
    connect(m_acknowledgeAll, &QPushButton::clicked, this, &AlarmList::acknowledgeAllRequested);
    m_unread.setSingleShot(true);
    retranslateUi();
}

void AlarmList::arrange() {
    const bool isNarrow = width() < minWidth(false);
    if (isNarrow != m_isNarrow)
        placeButtons(isNarrow);
}

void AlarmList::placeButtons(bool isNarrow) {
    m_isNarrow = isNarrow;
    for (QWidget* button : std::initializer_list<QWidget*>{m_acknowledge, m_shelve, m_acknowledgeAll})
        m_buttons->removeWidget(button);
    m_buttons->addWidget(m_acknowledge, 0, 0, 1, isNarrow ? 2 : 1);
    m_buttons->addWidget(m_shelve, isNarrow ? 1 : 0, isNarrow ? 0 : 1, 1, isNarrow ? 2 : 1);
    m_buttons->addWidget(m_acknowledgeAll, isNarrow ? 2 : 1, 0, 1, 2);
}

int AlarmList::minWidth(bool isNarrow) const {
    const int one = m_acknowledge->minimumSizeHint().width(), shelve = m_shelve->minimumSizeHint().width(),
              all = m_acknowledgeAll->minimumSizeHint().width();
    const int buttons = std::max(all, isNarrow ? std::max(one, shelve) : one + kGap / 2 + shelve);
    const QMargins margins = contentsMargins();
    return margins.left() + kMinTree + kGap + kMinGuidance + kGap + buttons + margins.right();
}

QSize AlarmList::minimumSizeHint() const {
    return {minWidth(true), QWidget::minimumSizeHint().height()};
}

void AlarmList::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void AlarmList::setAlarms(const std::vector<Alarm>& alarms) {
    const QDate today = QDate::currentDate();
    if (alarms == m_alarms && today == m_today)
        return;
    m_alarms = alarms;
    m_groups = groupAlarms(alarms);
    m_today = today;
    const bool isMoved = chooseGravest();
    showRows();
    if (isMoved && m_chosen)
        m_tree->scrollToItem(m_tree->currentItem());
}

/// Returns whether another alarm is selected now, or its row is under that of its cause now.
bool AlarmList::chooseGravest() {
    const std::optional<std::uint64_t> before = m_chosen;
    const Alarm* const kept = chosen();
    const AlarmGroup* const top = gravest(m_groups);
    // What a person has selected and is over, seen or shelved hides no graver one that nobody has seen.
    const bool isDealtWith =
        kept != nullptr && (!kept->isActive || kept->isAcknowledged || kept->shelvedUntil_s > 0.0);
    const bool isGraver = kept != nullptr && top != nullptr && top->alarm.isActive &&
                          top->alarm.priority < kept->priority &&
                          (!m_isChosenByPerson || (isDealtWith && !top->alarm.isAcknowledged));
    const bool isUnfolded = m_isChosenByPerson && m_chosen && !isGraver && unfoldOver(*m_chosen);
    const bool isReplaced = isGraver || (kept != nullptr && isFolded(kept->id));
    if (kept != nullptr && !isReplaced &&
        (m_isChosenByPerson || !kept->isAcknowledged || before == m_acknowledged))
        return isUnfolded;
    if (isReplaced)
        m_unread.start(kUnread_ms);
    const bool isDone = before && kept == nullptr && (m_isChosenByPerson || before == m_acknowledged);
    const AlarmGroup* const first = isDone ? nullptr : top;
    m_isChosenByPerson = false;
    m_chosen = first != nullptr ? std::optional(first->alarm.id) : std::nullopt;
    return m_chosen != before;
}

/// Whether its row is hidden under that of its cause.
bool AlarmList::isFolded(std::uint64_t id) const {
    const AlarmGroup* const over = groupOver(id);
    return over != nullptr && !m_unfolded.contains(over->alarm.id);
}

/// Returns whether the row was hidden.
bool AlarmList::unfoldOver(std::uint64_t id) {
    const AlarmGroup* const over = groupOver(id);
    return over != nullptr && m_unfolded.insert(over->alarm.id).second;
}

/// The group that lists the alarm under its cause; null if it has none over it.
const AlarmGroup* AlarmList::groupOver(std::uint64_t id) const {
    for (const std::vector<AlarmGroup>* groups : {&m_groups.present, &m_groups.shelved})
        for (const AlarmGroup& group : *groups)
            if (std::ranges::find(group.consequences, id, &Alarm::id) != group.consequences.end())
                return &group;
    return nullptr;
}

void AlarmList::setHomeAction(QAction* home) {
    m_home->setDefaultAction(home);
    showChosen();
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
    if (std::ranges::find(m_alarms, id, &Alarm::id) != m_alarms.end()) {
        m_chosen = id;
        m_isChosenByPerson = true;
    }
    unfoldOver(id);
    showRows();
    m_tree->scrollToItem(m_tree->currentItem());
    m_tree->setFocus();
}

void AlarmList::setFolded(const QTreeWidgetItem* item, bool isFolded) {
    const QVariant id = item->data(kPriority, kIdRole);
    if (!id.isValid())
        m_isShelfFolded = isFolded;
    else if (isFolded)
        m_unfolded.erase(id.toULongLong());
    else
        m_unfolded.insert(id.toULongLong());
}

/// Rows are filled anew, not made anew, so that the view stays where it is.
void AlarmList::showRows() {
    const QSignalBlocker quiet(m_tree);
    const int scrolled = m_tree->verticalScrollBar()->value();
    const bool hasShelf = !m_groups.shelved.empty();
    m_tree->setRootIsDecorated(hasShelf || !std::ranges::all_of(m_groups.present, &std::vector<Alarm>::empty,
                                                                &AlarmGroup::consequences));
    fitRows(m_tree->invisibleRootItem(), m_groups.present.size() + (hasShelf ? 1 : 0));
    for (std::size_t i = 0; i < m_groups.present.size(); ++i)
        fitRows(m_tree->topLevelItem(static_cast<int>(i)), m_groups.present[i].consequences.size());
    if (hasShelf) {
        QTreeWidgetItem* const shelf = m_tree->topLevelItem(static_cast<int>(m_groups.present.size()));
        fitRows(shelf, m_groups.shelved.size());
        for (std::size_t i = 0; i < m_groups.shelved.size(); ++i)
            fitRows(shelf->child(static_cast<int>(i)), m_groups.shelved[i].consequences.size());
    }
    m_tree->clearSelection(); // the neighbour of a row that left has got it
    int row = 0;
    for (const AlarmGroup& group : m_groups.present)
        showGroup(m_tree->topLevelItem(row++), group);
    if (hasShelf)
        showShelf(m_tree->topLevelItem(row));
    m_tree->verticalScrollBar()->setValue(scrolled);
    showChosen();
}

void AlarmList::showGroup(QTreeWidgetItem* item, const AlarmGroup& group) {
    item->setFirstColumnSpanned(false);
    fill(item, group.alarm, group.consequences.size());
    for (std::size_t i = 0; i < group.consequences.size(); ++i)
        fill(item->child(static_cast<int>(i)), group.consequences[i]);
    item->setExpanded(m_unfolded.contains(group.alarm.id));
}

void AlarmList::showShelf(QTreeWidgetItem* item) {
    for (int column = kPriority; column < kColumns; ++column) {
        item->setText(column, QString());
        item->setFont(column, m_tree->font());
        item->setForeground(column, secondaryText(isDark(this)));
    }
    item->setData(kPriority, kIdRole, QVariant());
    item->setIcon(kPriority, QIcon(shelfPixmap(secondaryText(isDark(this)), devicePixelRatioF())));
    item->setText(kPriority, tr("Shelved: %1").arg(m_groups.shelved.size()));
    item->setData(kPriority, Qt::AccessibleTextRole, item->text(kPriority));
    item->setToolTip(kWhat, QString());
    item->setFirstColumnSpanned(true);
    for (std::size_t i = 0; i < m_groups.shelved.size(); ++i)
        showGroup(item->child(static_cast<int>(i)), m_groups.shelved[i]);
    item->setExpanded(!m_isShelfFolded);
}

/// Bold is what still is so and nobody has seen; what is over is grey.
void AlarmList::fill(QTreeWidgetItem* item, const Alarm& alarm, std::size_t following) const {
    const bool dark = isDark(this);
    item->setData(kPriority, kIdRole, QVariant::fromValue<qulonglong>(alarm.id));
    item->setText(kPriority, QString());
    item->setIcon(kPriority,
                  rowMark(alarmPixmap(alarm.priority, dark, kRowMark, devicePixelRatioF(), !alarm.isActive),
                          palette().color(QPalette::Base)));
    item->setData(kPriority, Qt::AccessibleTextRole, tr("Priority %1").arg(alarm.priority));
    QString state = alarm.shelvedUntil_s > 0.0 ? shelfWords(alarm, m_today) : alarmStateWords(alarm);
    if (following > 0)
        state += tr(", %n follow(s)", "from this alarm", static_cast<int>(following));
    item->setText(kState, state);
    item->setToolTip(kState, state);
    item->setText(kRaised, alarmTime(alarm.raised_s, m_today));
    item->setText(kTimes, alarm.count > 1 ? tr("%1×").arg(alarm.count) : QString());
    const QString sentence = alarmSentence(alarm, m_unit);
    item->setText(kWhat, sentence);
    item->setToolTip(kWhat, sentence);
    const bool isShelved = alarm.shelvedUntil_s > 0.0;
    const bool isQuiet = !alarm.isActive || isShelved;
    QFont font = m_tree->font();
    font.setBold(!alarm.isAcknowledged && !isQuiet);
    font.setItalic(!alarm.isActive);
    const QBrush ink = m_isStale ? palette().brush(QPalette::Disabled, QPalette::Text)
                       : isQuiet ? QBrush(secondaryText(dark))
                                 : palette().brush(QPalette::Active, QPalette::Text);
    for (int column = kPriority; column < kColumns; ++column) {
        item->setFont(column, font);
        item->setForeground(column, ink);
    }
    if (alarm.id == m_chosen)
        m_tree->setCurrentItem(item);
}

/// Causes only: what follows from one goes with it.
bool AlarmList::isShelvable(const Alarm& alarm) const {
    return std::ranges::any_of(m_groups.present,
                               [&](const AlarmGroup& group) { return group.alarm.id == alarm.id; });
}

/// Of the row under the pointer.
void AlarmList::showMenu(const QPoint& at) {
    if (QTreeWidgetItem* item = m_tree->itemAt(at))
        m_tree->setCurrentItem(item);
    auto* menu = new QMenu(this);
    m_menu = menu;
    m_menuId = m_chosen;
    menu->setObjectName(QStringLiteral("alarmMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{m_acknowledge, m_shelve}) {
        QAction* action = menu->addAction(button->text(), this, [this, button, id = m_chosen] {
            if (id == m_chosen)
                button->click();
        });
        action->setEnabled(button->isEnabled());
    }
    menu->addSeparator();
    menu->addAction(tr("All alarms…"), this, &AlarmList::historyRequested);
    menu->popup(m_tree->viewport()->mapToGlobal(at));
}

void AlarmList::openShelf() {
    const Alarm* alarm = chosen();
    if (alarm == nullptr)
        return;
    if (alarm->shelvedUntil_s > 0.0)
        return emit unshelveRequested(alarm->id);
    m_shelf->open(alarm->id, alarm->priority == 1 ? ShelveAlarm::kLongestGrave_s : ShelveAlarm::kLongest_s,
                  *m_shelve);
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
    if (!alarm->cause.empty() && !isShelvable(*alarm) && alarm->shelvedUntil_s <= 0.0)
        facts << tr("It follows from the alarm over it, and goes with that.");
    if (alarm->shelvedUntil_s > 0.0)
        facts << shelfWords(*alarm, m_today) + u'.';
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
    if (text != m_shown) {
        const int scrolled = m_shownId == m_chosen ? m_guidance->verticalScrollBar()->value() : 0;
        m_guidance->setHtml(m_shown = text);
        m_guidance->verticalScrollBar()->setValue(scrolled); // only its value may be another
        m_shownId = m_chosen;
    }
    if (m_menu && m_menuId != m_chosen)
        m_menu->close(); // it is of the alarm that was chosen
    const Alarm* alarm = chosen();
    const bool needsAnswer = !m_isStale && alarm != nullptr && !alarm->isAcknowledged;
    if (!needsAnswer && m_acknowledge->hasFocus())
        m_tree->setFocus(); // else the button for all has the keyboard, and Space presses that
    m_acknowledge->setEnabled(needsAnswer);
    m_acknowledgeAll->setEnabled(!m_isStale && !std::ranges::all_of(m_alarms, &Alarm::isAcknowledged));
    m_home->setVisible(m_home->defaultAction() != nullptr && alarm != nullptr && alarm->isActive &&
                       isAboutPlace(alarm->message.code));
    const bool isShelved = alarm != nullptr && alarm->shelvedUntil_s > 0.0;
    m_shelve->setEnabled(!m_isStale && alarm != nullptr && (isShelved || isShelvable(*alarm)));
    const QString verb = isShelved ? tr("Take the alarm back from the shelf")
                                   : tr("Shelve: put the alarm aside for a time, with a reason");
    m_shelve->setText(isShelved ? tr("Unshelve") : tr("Shelve…"));
    if (verb != m_shelve->accessibleName()) {
        m_shelve->setAccessibleName(verb);
        m_shelve->setToolTip(verb);
    }
    m_shelve->setCheckable(isShelved);
    m_shelve->setChecked(isShelved);
}

void AlarmList::retranslateUi() {
    setAccessibleName(tr("Alarms"));
    m_tree->setAccessibleName(accessibleName());
    m_tree->setHeaderLabels({tr("Priority"), tr("State"), tr("Raised"), tr("Times"), tr("What is wrong")});
    // The other columns may leave it little room.
    m_tree->headerItem()->setToolTip(kWhat, tr("What is wrong"));
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
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) {
        retranslateUi();
        arrange();
    }
}

} // namespace bask
