#include "widgets/common/colour_map.h"
#include "widgets/common/label_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace bask {
namespace {

constexpr QRectF kArea(0.0, 0.0, 600.0, 400.0);
constexpr QSizeF kLabel(90.0, 20.0);

double luminance(const QColor& c) {
    return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF();
}

// Catches labels drawn over each other when objects stand close together.
TEST(LabelLayout, LabelsOfCloseObjectsDoNotOverlap) {
    LabelLayout layout;
    layout.begin(kArea);
    std::vector<QRectF> placed;
    for (std::size_t i = 0; i < 4; ++i) {
        const QRectF rect =
            layout.place(i, QRectF(300.0 + 4.0 * static_cast<double>(i), 200.0, 10.0, 10.0), kLabel);
        for (const QRectF& other : placed)
            EXPECT_FALSE(rect.intersects(other)) << i;
        placed.push_back(rect);
    }
}

// Catches clipped labels of objects at the edge of the view.
TEST(LabelLayout, LabelsStayInsideTheView) {
    LabelLayout layout;
    layout.begin(kArea);
    for (const QPointF corner :
         {QPointF(0, 0), QPointF(595, 0), QPointF(0, 395), QPointF(595, 395), QPointF(-500, 900)})
        EXPECT_TRUE(kArea.contains(layout.place(0, QRectF(corner, QSizeF(5.0, 5.0)), kLabel)));
}

// Catches labels that flicker from side to side while an obstacle passes.
TEST(LabelLayout, ALabelStaysWhereItWasWhenThatIsAsGood) {
    LabelLayout layout;
    const QRectF anchor(300.0, 200.0, 10.0, 10.0);
    layout.begin(kArea);
    layout.take(QRectF(310.0, 150.0, 120.0, 100.0));
    const QRectF first = layout.place(0, anchor, kLabel);
    EXPECT_LT(first.right(), anchor.left());
    layout.begin(kArea); // the obstacle on the right, the side liked best, has gone
    EXPECT_EQ(layout.place(0, anchor, kLabel), first);
}

// Catches a name over the path that its object is to take, and one pushed away though nothing runs there.
TEST(LabelLayout, ALineStaysVisible) {
    LabelLayout layout;
    const QRectF anchor(300.0, 200.0, 10.0, 10.0);
    layout.begin(kArea);
    const QRectF liked = layout.place(0, anchor, kLabel);
    ASSERT_GT(liked.left(), anchor.right()) << "on the right";

    LabelLayout other;
    other.begin(kArea);
    const QPolygonF path{anchor.center(), QPointF(420.0, 206.0), QPointF(420.0, 320.0)};
    other.takeLine(path);
    EXPECT_TRUE(other.crossesLine(liked));
    const QRectF place = other.place(0, anchor, kLabel);
    EXPECT_FALSE(other.crossesLine(place));
    EXPECT_LT((place.center() - anchor.center()).manhattanLength(), 100.0) << "no further than it must";

    other.begin(kArea); // the next picture has none
    EXPECT_FALSE(other.crossesLine(liked));
    other.takeLine({QPointF(-1e4, 0.0), QPointF(-1e3, 0.0)});
    EXPECT_FALSE(other.crossesLine(QRectF(-2e3, -10.0, 500.0, 20.0))) << "out of sight";
}

// Catches a label of little importance laid over others, and one left out although there is room.
TEST(LabelLayout, AnOptionalLabelGivesWay) {
    LabelLayout layout;
    const QRectF anchor(300.0, 200.0, 10.0, 10.0);
    layout.begin(kArea);
    EXPECT_FALSE(layout.place(0, anchor, kLabel, 0.5).isEmpty());
    layout.begin(kArea);
    layout.take(kArea);
    EXPECT_TRUE(layout.place(0, anchor, kLabel, 0.5).isEmpty());
    EXPECT_FALSE(layout.place(0, anchor, kLabel).isEmpty());
}

// Catches bars that end on odd numbers, and the empty interval of a run at room temperature.
TEST(NiceRange, EndsOnWholeStepsAndHoldsTheInterval) {
    const NiceRange range = niceRange(23.4, 51.2, 5);
    EXPECT_DOUBLE_EQ(range.step, 10.0);
    EXPECT_DOUBLE_EQ(range.min, 20.0);
    EXPECT_DOUBLE_EQ(range.max, 60.0);
    const NiceRange empty = niceRange(25.0, 25.0, 5);
    EXPECT_LE(empty.min, 25.0);
    EXPECT_GT(empty.max, 25.0);
    EXPECT_GT(niceRange(std::nan(""), 3.0, 5).step, 0.0);
}

// Catches colours outside of the table, and an unknown temperature shown as a cold one.
TEST(ColourMap, ClampsAndKnowsTheUnknown) {
    for (const bool dark : {false, true}) {
        EXPECT_EQ(mapColour(-1.0, dark), mapColour(0.0, dark));
        EXPECT_EQ(mapColour(7.0, dark), mapColour(1.0, dark));
        EXPECT_EQ(mapColour(std::nan(""), dark), unknownColour(dark));
        EXPECT_NE(mapColour(0.0, dark), unknownColour(dark));
        for (int i = 1; i <= 20; ++i)
            EXPECT_GT(luminance(mapColour(i / 20.0, dark)), luminance(mapColour((i - 1) / 20.0, dark))) << i;
    }
}

} // namespace
} // namespace bask
