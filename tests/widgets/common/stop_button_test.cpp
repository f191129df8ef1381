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
