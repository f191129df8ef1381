// The dialog that asks for the size of a figure.

#include "widgets/plots/figure_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

#include <gtest/gtest.h>

namespace bask {

// Catches a list that does not fill the field in, another width that is not kept, and a heading that is lost.
TEST(FigureDialog, OffersColumnsAndTakesAnotherWidth) {
    FigureDialog dialog({120.0, false});
    auto* columns = dialog.findChild<QComboBox*>("figureColumns");
    auto* width = dialog.findChild<QDoubleSpinBox*>("figureWidth");
    EXPECT_EQ(dialog.chosen(), (FigureLayout{120.0, false}));
    EXPECT_EQ(columns->currentIndex(), columns->count() - 1);
    const int one = columns->findData(kOneColumn_mm);
    ASSERT_GE(one, 0);
    EXPECT_EQ(columns->itemText(one), QString("One column: 89 mm"));
    columns->setCurrentIndex(one);
    emit columns->activated(one);
    EXPECT_EQ(dialog.chosen().width_mm, kOneColumn_mm);
    width->setValue(kTwoColumns_mm);
    EXPECT_EQ(columns->currentData().toDouble(), kTwoColumns_mm);
    width->setValue(5.0);
    EXPECT_EQ(dialog.chosen().width_mm, kNarrowest_mm);
    dialog.findChild<QCheckBox*>("figureHeading")->setChecked(true);
    EXPECT_TRUE(dialog.chosen().hasHeading);
}

} // namespace bask
