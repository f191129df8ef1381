#include "widgets/common/folding_splitter.h"

#include <QCoreApplication>

#include <gtest/gtest.h>

namespace bask {
namespace {

struct Parts {
    QWidget window; // a splitter that is a window keeps all its parts beside each other
    FoldingSplitter splitter{&window};
    QWidget* left = new QWidget;
    QWidget* right = new QWidget;

    Parts() {
        for (QWidget* part : {left, right})
            splitter.addWidget(part);
        left->setMinimumSize(300, 50);
        right->setMinimumSize(200, 80);
        splitter.setSizes({400, 200});
        splitter.resize(800, 400);
        window.resize(1000, 800);
        window.show();
        settle();
    }
    void settle() const {
        for (int i = 0; i < 4; ++i)
            QCoreApplication::processEvents();
    }
    void widen(int width) {
        splitter.resize(width, 700);
        settle();
    }
};

} // namespace

// Catches parts that are cut, or pushed over each other, where they have no room beside each other.
TEST(FoldingSplitter, PartsStandBeneathEachOtherWhereTheyAreTooWide) {
    Parts parts;
    EXPECT_FALSE(parts.splitter.isFolded());
    EXPECT_EQ(parts.splitter.minimumSizeHint().width(), 300) << "it can be as narrow as its widest part";
    parts.widen(450);
    EXPECT_TRUE(parts.splitter.isFolded());
    EXPECT_GE(parts.right->y(), parts.left->geometry().bottom());
    EXPECT_EQ(parts.left->width(), 450);
    EXPECT_GE(parts.splitter.minimumSizeHint().height(), 2 * 200) << "each is to be seen";
}

// Catches sizes that a person has dragged and that are lost by a narrow window between.
TEST(FoldingSplitter, KeepsTheSizesOfEitherArrangement) {
    Parts parts;
    parts.widen(900);
    parts.splitter.setSizes({600, 290});
    const int dragged = parts.left->width();
    ASSERT_GT(dragged, 550);
    parts.widen(450);
    ASSERT_TRUE(parts.splitter.isFolded());
    parts.widen(900);
    EXPECT_FALSE(parts.splitter.isFolded());
    EXPECT_NEAR(parts.left->width(), dragged, 2);
}

// Catches a part that is hidden and keeps the others beneath each other.
TEST(FoldingSplitter, AHiddenPartNeedsNoRoom) {
    Parts parts;
    parts.right->hide();
    parts.widen(350);
    EXPECT_FALSE(parts.splitter.isFolded());
    parts.right->show();
    parts.settle();
    EXPECT_TRUE(parts.splitter.isFolded());
}

} // namespace bask
