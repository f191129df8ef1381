#include "widgets/common/event_list.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr int kKindRole = Qt::UserRole;
constexpr int kTimeRole = Qt::UserRole + 1;
constexpr int kMaxRows = 10000;

int priorityOf(EventKind kind) {
    switch (kind) {
    case EventKind::Alarm1:
        return 1;
    case EventKind::Alarm2:
        return 2;
    case EventKind::Alarm3:
        return 3;
    default:
        return 0;
    }
}

} // namespace

EventKind eventKind(MessageCode code) {
    switch (alarmPriority(code)) {
    case 1:
        return EventKind::Alarm1;
    case 2:
        return EventKind::Alarm2;
    case 3:
        return EventKind::Alarm3;
    default:
        return EventKind::Event;
    }
}

EventList::EventList(QWidget* parent) : QWidget(parent), m_tree(new QTreeWidget(this)) {
    setObjectName(QStringLiteral("eventList"));
    m_tree->setObjectName(QStringLiteral("eventListTree"));
    m_tree->setColumnCount(3);
    m_tree->setRootIsDecorated(false);
    m_tree->setUniformRowHeights(true);
    m_tree->setAlternatingRowColors(true);
    m_tree->setFrameShape(QFrame::NoFrame);
    m_tree->header()->setStretchLastSection(true);
    m_tree->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_tree->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_tree);
    connect(m_tree, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { emit timeChosen(item->data(0, kTimeRole).toDouble()); });
    retranslateUi();
}

void EventList::add(double time_s, const QString& text, EventKind kind) {
    const QScrollBar* bar = m_tree->verticalScrollBar();
    const bool atEnd = bar->value() >= bar->maximum();
    auto* item = new QTreeWidgetItem(m_tree, {formatDuration(time_s), QString(), text});
    item->setTextAlignment(0, Qt::AlignRight | Qt::AlignVCenter);
    item->setData(0, kKindRole, static_cast<int>(kind));
    item->setData(0, kTimeRole, time_s);
    item->setToolTip(2, text);
    decorate(item);
    if (m_tree->topLevelItemCount() > kMaxRows)
        delete m_tree->takeTopLevelItem(0);
    if (atEnd)
        m_tree->scrollToItem(item);
}

void EventList::setChosenByClick() {
    connect(m_tree, &QTreeWidget::itemClicked, this,
            [this](QTreeWidgetItem* item) { emit timeChosen(item->data(0, kTimeRole).toDouble()); });
}

void EventList::clear() {
    m_tree->clear();
}

int EventList::count() const {
    return m_tree->topLevelItemCount();
}

QString EventList::textAt(int row) const {
    const QTreeWidgetItem* item = m_tree->topLevelItem(row);
    return item != nullptr ? item->text(2) : QString();
}

void EventList::decorate(QTreeWidgetItem* item) const {
    const auto kind = static_cast<EventKind>(item->data(0, kKindRole).toInt());
    if (const int priority = priorityOf(kind); priority > 0) {
        item->setText(1, tr("Priority %1").arg(priority));
        item->setIcon(1, QIcon(alarmPixmap(priority, isDark(this), 16, devicePixelRatioF())));
    } else {
        item->setText(1, kind == EventKind::Note ? tr("Note") : tr("Event"));
    }
}

void EventList::retranslateUi() {
    setAccessibleName(tr("Events and notes"));
    m_tree->setAccessibleName(accessibleName());
    m_tree->setHeaderLabels({tr("Time"), tr("Kind"), tr("What happened")});
    for (int i = 0; i < m_tree->topLevelItemCount(); ++i)
        decorate(m_tree->topLevelItem(i));
}

void EventList::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslateUi();
}

} // namespace bask
