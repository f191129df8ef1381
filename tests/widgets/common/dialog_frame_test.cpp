#include "widgets/common/dialog_frame.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

#include <initializer_list>

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

// Catches a dialog that closes with the old number because the one that was typed is refused.
TEST(DialogFrame, StaysOpenWhenANumberIsRefused) {
    QDialog dialog;
    auto* length = new NumberField(&dialog);
    auto* temperature = new QuantitySpinBox(&dialog);
    QVBoxLayout* column = dialogColumn(dialog);
    column->addWidget(length);
    column->addWidget(temperature);
    const DialogButtons buttons = addDialogButtons(dialog, QStringLiteral("OK"));
    for (NumberField* field : std::initializer_list<NumberField*>{length, temperature}) {
        const auto type = [field](const char* text) {
            field->setFocus();
            field->selectAll();
            QTest::keyClicks(field, QString::fromUtf8(text));
        };
        dialog.show();
        dialog.activateWindow();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
        type("5 mn");
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_TRUE(dialog.isVisible()) << "Enter";
        type("5 mn");
        QTest::mouseClick(buttons.take, Qt::LeftButton);
        EXPECT_TRUE(dialog.isVisible()) << "a click";
        QTest::mouseClick(buttons.take, Qt::LeftButton);
        EXPECT_FALSE(dialog.isVisible()) << "the number is what is shown now";
        dialog.show();
        ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
        type("5");
        QTest::keyClick(field, Qt::Key_Return);
        EXPECT_FALSE(dialog.isVisible());
    }
}
