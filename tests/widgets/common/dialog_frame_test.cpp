#include "widgets/common/dialog_frame.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

using namespace bask;

// Catches a dialog that Enter or Cancel does not end, and buttons above its parts.
TEST(DialogFrame, EndsWithButtonsThatEndTheDialog) {
    QDialog dialog;
    auto* field = new QLineEdit(&dialog);
    dialogColumn(dialog)->addWidget(field);
    const DialogButtons buttons = addDialogButtons(dialog, QStringLiteral("Arm"));
    const auto end = [&dialog](const auto& by) {
        dialog.setResult(-1);
        dialog.show();
        by();
        return dialog.result();
    };
    EXPECT_EQ(end([&] { QTest::keyClick(field, Qt::Key_Return); }), QDialog::Accepted);
    EXPECT_EQ(end([&] { QTest::mouseClick(buttons.take, Qt::LeftButton); }), QDialog::Accepted);
    EXPECT_EQ(end([&] { QTest::mouseClick(buttons.cancel, Qt::LeftButton); }), QDialog::Rejected);
    EXPECT_EQ(buttons.take->text(), QStringLiteral("Arm"));
    EXPECT_EQ(buttons.cancel->text(), QStringLiteral("Cancel"));
    EXPECT_GT(buttons.box->y(), field->y());
}
