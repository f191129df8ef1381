#include "widgets/common/event_list.h"

#include <QSignalSpy>
#include <QTest>
#include <QTreeWidget>

#include <gtest/gtest.h>

using namespace bask;

// Catches rows without time or kind, and a chosen row that tells the wrong moment.
TEST(EventList, ShowsTimeKindAndText) {
    EventList list;
    list.add(12.0, QStringLiteral("Started"));
    list.add(75.5, QStringLiteral("lamp moved"), EventKind::Note);
    list.add(80.0, QStringLiteral("The sensor of \"hand\" gives no plausible value."), EventKind::Alarm1);
    auto* tree = list.findChild<QTreeWidget*>(QStringLiteral("eventListTree"));
    ASSERT_NE(tree, nullptr);
    ASSERT_EQ(list.count(), 3);
    EXPECT_EQ(tree->topLevelItem(1)->text(0), QStringLiteral("1:15"));
    EXPECT_EQ(tree->topLevelItem(1)->text(1), QStringLiteral("Note"));
    EXPECT_EQ(list.textAt(1), QStringLiteral("lamp moved"));
    EXPECT_EQ(tree->topLevelItem(2)->text(1), QStringLiteral("Priority 1"));
    EXPECT_FALSE(tree->topLevelItem(2)->icon(1).isNull());

    QSignalSpy chosen(&list, &EventList::timeChosen);
    emit tree->itemActivated(tree->topLevelItem(1), 0);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_DOUBLE_EQ(chosen.first().first().toDouble(), 75.5);
    list.clear();
    EXPECT_EQ(list.count(), 0);
}
