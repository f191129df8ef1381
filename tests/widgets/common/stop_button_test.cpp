#include "widgets/common/stop_button.h"

#include <QDialog>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

using namespace bask;

// Catches a STOP that waits for the button's release.
TEST(StopButton, ActsOnPress) {
    StopButton button;
    button.show();
    QSignalSpy stop(&button, &StopButton::stopRequested);
    QTest::mousePress(&button, Qt::LeftButton);
    EXPECT_EQ(stop.count(), 1);
    QTest::mouseRelease(&button, Qt::LeftButton, Qt::NoModifier, {-50, -50});
    EXPECT_EQ(stop.count(), 1);
    EXPECT_TRUE(
        button.toolTip().contains(QStringLiteral("software stop, not a safety-rated emergency stop")));
    EXPECT_FALSE(button.accessibleName().isEmpty());
}

// Catches an F12 that is deaf while a person types or a modal dialog is open.
TEST(StopButton, F12WorksEverywhere) {
    StopButton button;
    button.show();
    QSignalSpy stop(&button, &StopButton::stopRequested);
    QDialog dialog;
    QLineEdit edit(&dialog);
    dialog.setModal(true);
    dialog.show();
    edit.setFocus();
    QTest::keyClick(&edit, Qt::Key_F12);
    EXPECT_EQ(stop.count(), 1);
}

// Catches a red button that a file dialog makes deaf to the mouse. (A dialog's own windows are not.)
TEST(StopButton, HasATwinOverAModalDialog) {
    StopButton button;
    button.move(40, 30);
    button.show();
    QSignalSpy stop(&button, &StopButton::stopRequested);
    QDialog dialog;
    dialog.setModal(true);
    const auto twin = [&] { return dialog.findChild<StopButton*>(QStringLiteral("stopTwin")); };
    for (int shown = 1; shown <= 2; ++shown) {
        dialog.show();
        ASSERT_TRUE(QTest::qWaitFor([&] { return twin() != nullptr; }));
        EXPECT_TRUE(twin()->isWindow() && twin()->isVisible());
        EXPECT_EQ(twin()->geometry(), QRect(button.mapToGlobal(QPoint(0, 0)), button.size()));
        EXPECT_EQ(dialog.findChildren<StopButton*>().size(), 1);
        QTest::mousePress(twin(), Qt::LeftButton);
        EXPECT_EQ(stop.count(), shown);
        dialog.hide();
        EXPECT_TRUE(QTest::qWaitFor([&] { return twin() == nullptr; }));
    }
}

// Catches a window whose red button is deaf behind a dialog, since another window's button has a twin there.
TEST(StopButton, EveryWindowsButtonHasATwinOfItsOwn) {
    StopButton button, other;
    button.move(40, 30);
    other.move(300, 200);
    for (StopButton* each : {&button, &other})
        each->show();
    QSignalSpy stop(&button, &StopButton::stopRequested), otherStop(&other, &StopButton::stopRequested);
    QDialog dialog;
    dialog.setModal(true);
    dialog.show();
    const auto twins = [&] { return dialog.findChildren<StopButton*>(QStringLiteral("stopTwin")); };
    ASSERT_TRUE(QTest::qWaitFor([&] { return twins().size() == 2; }));
    for (StopButton* twin : twins())
        QTest::mousePress(twin, Qt::LeftButton);
    EXPECT_EQ(stop.count(), 1);
    EXPECT_EQ(otherStop.count(), 1);
    dialog.hide();
    EXPECT_TRUE(QTest::qWaitFor([&] { return twins().isEmpty(); }));
}
