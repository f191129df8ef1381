// The dialog that asks for a picture's size.

#include "widgets/targets/picture_dialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QTest>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct PictureDialogTest : testing::Test {
    PictureDialog dialog{QStringLiteral("Save"), {1400, 1000}, PictureDialog::kMax_px, nullptr};
    QComboBox* sizes = dialog.findChild<QComboBox*>("pictureSize");
    QDoubleSpinBox* width = dialog.findChild<QDoubleSpinBox*>("pictureWidth");
    QDoubleSpinBox* height = dialog.findChild<QDoubleSpinBox*>("pictureHeight");

    void type(QDoubleSpinBox* side, const QString& text) {
        side->setFocus();
        side->selectAll();
        QTest::keyClicks(side, text);
        QTest::keyClick(side, Qt::Key_Tab);
    }
};

// Catches a list that does not fill the fields in, or whose names are of other sizes.
TEST_F(PictureDialogTest, StartsWithTheViewAndOffersSizes) {
    EXPECT_EQ(dialog.size_px(), QSize(1400, 1000));
    EXPECT_EQ(sizes->itemText(0), QString::fromUtf8("As the view: 1400 × 1000"));
    EXPECT_EQ(sizes->itemText(1), QString::fromUtf8("Twice the view: 2800 × 2000"));
    const int a4 = sizes->findData(QSize(3508, 2480));
    ASSERT_GE(a4, 0);
    sizes->setCurrentIndex(a4);
    emit sizes->activated(a4);
    EXPECT_EQ(dialog.size_px(), QSize(3508, 2480));
    dialog.show();
    EXPECT_TRUE(dialog.grab().save("picture_dialog.png"));
}

// Catches a list that says another size than the fields, and sizes that no picture can have.
TEST_F(PictureDialogTest, TakesATypedSizeWithinItsBounds) {
    dialog.show();
    dialog.activateWindow(); // else no field loses the focus
    ASSERT_TRUE(QTest::qWaitForWindowActive(&dialog));
    type(width, QStringLiteral("4000"));
    type(height, QStringLiteral("3000"));
    EXPECT_EQ(dialog.size_px(), QSize(4000, 3000));
    EXPECT_EQ(sizes->currentIndex(), sizes->count() - 1);
    type(width, QStringLiteral("1920"));
    type(height, QStringLiteral("1080"));
    EXPECT_EQ(sizes->currentData().toSize(), QSize(1920, 1080));
    type(width, QStringLiteral("99"));
    type(height, QStringLiteral("81920"));
    EXPECT_EQ(width->value(), 1920) << "99 is refused";
    EXPECT_EQ(height->value(), 1080) << "81920 is refused";
    type(width, QStringLiteral("192.5"));
    EXPECT_EQ(dialog.size_px(), QSize(1920, 1080)) << "not 1925, nor 193";
}

// Catches sizes on the list that the fields then cut down to others.
TEST(PictureDialog, OffersNoSizeBeyondItsBound) {
    PictureDialog dialog(QStringLiteral("Save"), {2600, 90}, 2000, nullptr);
    EXPECT_EQ(dialog.size_px(), QSize(2000, 100));
    const auto* sizes = dialog.findChild<QComboBox*>("pictureSize");
    for (int i = 0; i < sizes->count(); ++i)
        EXPECT_LE(sizes->itemData(i).toSize().width(), 2000);
}

} // namespace
} // namespace bask
