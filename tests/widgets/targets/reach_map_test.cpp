// A map of reachable pairs as a person sees and uses it: by pixels, mouse and keys.

#include "widgets/targets/reach_map.h"

#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"

#include <QApplication>
#include <QHelpEvent>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

constexpr int kCells = 10;
constexpr double kCell_K = 4.0; // along the first axis; 5 K along the second

Eigen::Vector2d cellCentre_K(int x, int y) {
    return {kelvinFromCelsius(30.0 + kCell_K * (x + 0.5)), kelvinFromCelsius(40.0 + 5.0 * (y + 0.5))};
}

/// Only cell (2, 7) can be reached; the target is its centre.
ReachableMap oneCell() {
    ReachableMap map;
    map.second = 1;
    map.cells = kCells;
    map.lower_K = {kelvinFromCelsius(30.0), kelvinFromCelsius(40.0)};
    map.upper_K = {kelvinFromCelsius(70.0), kelvinFromCelsius(90.0)};
    map.density.assign(kCells * kCells, 0.0);
    map.reachable.assign(kCells * kCells, false);
    map.density[7 * kCells + 2] = 1.0;
    map.reachable[7 * kCells + 2] = true;
    const Eigen::Vector2d centre_K = cellCentre_K(2, 7), half_K(kCell_K / 2.0, 2.5);
    const Eigen::Vector2d a_K = centre_K - half_K, b_K = centre_K + half_K;
    map.boundary = {{a_K, {a_K.x(), b_K.y()}},
                    {Eigen::Vector2d(b_K.x(), a_K.y()), b_K},
                    {a_K, {b_K.x(), a_K.y()}},
                    {Eigen::Vector2d(a_K.x(), b_K.y()), b_K}};
    map.target_K = map.nearest_K = centre_K;
    map.targetReachable = true;
    map.distance_K = 2.0;
    return map;
}

/// The same from a target that no pose holds.
ReachableMap outside(const Eigen::Vector2d& target_K) {
    ReachableMap map = oneCell();
    map.target_K = target_K;
    map.targetReachable = false;
    map.distance_K = (map.nearest_K - target_K).norm();
    return map;
}

struct ReachMapTest : testing::Test {
    ReachMap map;
    QSignalSpy picked{&map, &ReachMap::targetsPicked};

    ReachMapTest() {
        map.resize(360, 360);
        map.setNames("circle", "bunny");
        map.setMap(oneCell());
        map.show();
        map.activateWindow();
        QApplication::processEvents();
    }
    ~ReachMapTest() override { applyTheme(*qApp, Theme::Light); }
    /// Shown as what it is for `target_K`.
    void show(const ReachableMap& made) {
        map.setTarget_K(made.target_K);
        map.setMap(made);
    }
    /// The extent of the only cell, found by its colour.
    QRect cell() {
        map.setTarget_K(cellCentre_K(9, 0)); // away from it
        const QImage picture = map.picture(map.size(), 1.0);
        QRect found;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                if (picture.pixelColor(x, y) == mapColour(0.0, isDark(&map)))
                    found |= QRect(x, y, 1, 1);
        EXPECT_GT(found.width(), 10);
        return found;
    }
    void moveTo(QPoint place) { // with the button down
        QMouseEvent move(QEvent::MouseMove, place, map.mapToGlobal(place), Qt::NoButton, Qt::LeftButton, {});
        QApplication::sendEvent(&map, &move);
    }
    Eigen::Vector2d last_K() { return {picked.last()[0].toDouble(), picked.last()[1].toDouble()}; }
};

// Catches: axes that are swapped, turned over, or other than what a double click means; in any unit.
TEST_F(ReachMapTest, ADoubleClickTakesTheTemperaturesOfThePlace) {
    const QPoint place = cell().center();
    for (const auto unit : {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit}) {
        map.setTarget_K(cellCentre_K(9, 0));
        map.setTemperatureUnit(unit);
        picked.clear();
        QTest::mouseDClick(&map, Qt::LeftButton, {}, place);
        ASSERT_EQ(picked.count(), 1);
        EXPECT_NEAR(last_K().x(), cellCentre_K(2, 7).x(), 0.3);
        EXPECT_NEAR(last_K().y(), cellCentre_K(2, 7).y(), 0.3);
        const double shown = displayTemperature(last_K().x(), unit) * 10.0;
        EXPECT_NEAR(shown, std::round(shown), 1e-6) << "fields show tenths";
    }
    picked.clear();
    QTest::mousePress(&map, Qt::LeftButton, {}, {2, 2}); // not in the frame
    moveTo({150, 150});
    QTest::mouseRelease(&map, Qt::LeftButton, {}, {150, 150});
    map.setEditable(false);
    QTest::mouseDClick(&map, Qt::LeftButton, {}, {200, 100});
    QTest::keyClick(&map, Qt::Key_Right);
    EXPECT_EQ(picked.count(), 0);
}

// Catches: cells that a search found, taken for ones with the fewest poses or for ones that none reaches.
TEST_F(ReachMapTest, CellsWithoutACountedPoseHaveATone) {
    for (const auto theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        QApplication::processEvents();
        const QColor tone = rareColour(map.palette());
        EXPECT_LT(tone.saturation(), 40) << "neutral";
        for (const QColor& other : {mapColour(0.0, isDark(&map)), map.palette().color(QPalette::Base)})
            EXPECT_GT(std::abs(tone.lightness() - other.lightness()), 24);
        const auto toned = [&] {
            const QImage picture = map.picture(map.size(), 1.0);
            int pixels = 0;
            for (int y = 0; y < picture.height(); ++y)
                for (int x = 0; x < picture.width(); ++x)
                    pixels += picture.pixelColor(x, y) == tone;
            return pixels;
        };
        map.setMap(oneCell());
        const int before = toned();
        ReachableMap found = oneCell();
        found.reachable[3 * kCells + 8] = true;
        map.setMap(found);
        EXPECT_GT(toned(), before + 300);
    }
}

// Catches: a boundary that is not drawn, or elsewhere than around the cells.
TEST_F(ReachMapTest, TheBoundaryIsAroundTheCells) {
    for (const auto theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        QApplication::processEvents();
        const QRect inner = cell();
        const QImage picture = map.picture(map.size(), 1.0);
        const auto lineAt = [&](QPoint at) { // in the two pixels outwards, mixed by antialiasing
            const int cellLight = mapColour(0.0, isDark(&map)).lightness();
            const int baseLight = map.palette().color(QPalette::Base).lightness();
            const int textLight = map.palette().color(QPalette::WindowText).lightness();
            int nearest = 255;
            for (const QPoint step : {QPoint(-1, 0), QPoint(1, 0), QPoint(0, -1), QPoint(0, 1)})
                nearest = std::min(nearest, std::abs(picture.pixelColor(at + step).lightness() - textLight));
            return nearest < std::min(std::abs(cellLight - textLight), std::abs(baseLight - textLight));
        };
        EXPECT_TRUE(lineAt({inner.left() - 1, inner.center().y()}));
        EXPECT_TRUE(lineAt({inner.right() + 1, inner.center().y()}));
        EXPECT_TRUE(lineAt({inner.center().x(), inner.top() - 1}));
        EXPECT_TRUE(lineAt({inner.center().x(), inner.bottom() + 1}));
    }
}

// Catches: a target's point elsewhere than the target, also at twice the pixels; no mark where no pose holds
// it, no way to the nearest pair, and an answer to the target before shown as the present one's.
TEST_F(ReachMapTest, TheTargetIsMarked) {
    const QRect inner = cell();
    const QPoint reachable = inner.center();
    show(oneCell());
    EXPECT_EQ(map.picture(map.size(), 1.0).pixelColor(reachable), QColor(Qt::white));
    EXPECT_EQ(map.picture(map.size(), 2.0).pixelColor(2 * reachable), QColor(Qt::white));
    EXPECT_EQ(map.words(), QString::fromUtf8("2.0\u00a0K inside"));

    const QPoint off = reachable + 5 * QPoint(inner.width(), 0);
    QTest::mouseDClick(&map, Qt::LeftButton, {}, off);
    EXPECT_EQ(map.picture(map.size(), 1.0).pixelColor(off), QColor(Qt::white)) << "the point follows at once";
    EXPECT_TRUE(map.words().startsWith("Checking"));
    show(outside(last_K()));
    const QImage picture = map.picture(map.size(), 1.0);
    const QColor mark = alarmColor(3, false);
    EXPECT_EQ(picture.pixelColor(off - QPoint(7, 0)), mark);
    int ink = 0;
    for (int x = inner.right() + 6; x < off.x() - 12; ++x)
        ink += picture.pixelColor(x, off.y()).lightness() < 90;
    EXPECT_GT(ink, 20) << "dashes to the nearest pair";
    EXPECT_TRUE(map.words().endsWith("K outside")) << map.words().toStdString();
    EXPECT_TRUE(map.accessibleDescription().contains(map.words()));
    map.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    EXPECT_TRUE(map.words().contains(QString::fromUtf8("°F")));
}

// Catches: a target beyond the axes that is not seen at all.
TEST_F(ReachMapTest, ATargetBeyondTheAxesIsAtTheirEdge) {
    const QImage before = map.picture(map.size(), 1.0);
    show(outside({kelvinFromCelsius(300.0), cellCentre_K(2, 7).y()}));
    const QImage picture = map.picture(map.size(), 1.0);
    const int y = cell().center().y();
    int marked = 0;
    for (int x = picture.width() / 2; x < picture.width(); ++x)
        marked += picture.pixelColor(x, y) == alarmColor(3, false);
    EXPECT_GT(marked, 2);
}

// Catches: a map of other objects that looks like the present ones'.
TEST_F(ReachMapTest, StaleIsVisible) {
    show(oneCell());
    const QImage fresh = map.picture(map.size(), 1.0);
    map.setStale(true);
    const QImage stale = map.picture(map.size(), 1.0);
    EXPECT_TRUE(stale.save("reach_map_stale.png"));
    EXPECT_NE(stale, fresh);
    EXPECT_TRUE(map.words().startsWith("Checking"));
}

// Catches: arrow keys that move the wrong target or by other than half a degree of the unit.
TEST_F(ReachMapTest, ArrowKeysMoveByHalfADegree) {
    show(oneCell());
    const Eigen::Vector2d start_K = oneCell().target_K;
    QTest::keyClick(&map, Qt::Key_Right);
    EXPECT_TRUE(last_K().isApprox(start_K + Eigen::Vector2d(0.5, 0.0), 1e-9));
    QTest::keyClick(&map, Qt::Key_Down);
    EXPECT_TRUE(last_K().isApprox(start_K + Eigen::Vector2d(0.5, -0.5), 1e-9));
    map.setTemperatureUnit(TemperatureUnit::Fahrenheit);
    map.setTarget_K(start_K);
    QTest::keyClick(&map, Qt::Key_Up);
    EXPECT_NEAR(last_K().y() - start_K.y(), 0.5 / 1.8, 0.05 / 1.8 + 1e-9);
    EXPECT_NEAR(displayTemperature(last_K().y(), TemperatureUnit::Fahrenheit) * 10.0,
                std::round(displayTemperature(last_K().y(), TemperatureUnit::Fahrenheit) * 10.0), 1e-6);
}

// Catches: a point that cannot be dragged, a drag that edits at each step or not at its end, and a click
// beside the point that changes targets.
TEST_F(ReachMapTest, ThePointIsDragged) {
    QSignalSpy dragged{&map, &ReachMap::targetsDragged};
    const QPoint point = cell().center();
    show(oneCell());
    QTest::mouseClick(&map, Qt::LeftButton, {}, point + QPoint(40, 0));
    QTest::mouseClick(&map, Qt::LeftButton, {}, point);
    EXPECT_EQ(dragged.count() + picked.count(), 0);
    QTest::mousePress(&map, Qt::LeftButton, {}, point + QPoint(7, 7));
    moveTo(point + QPoint(8, 7)); // a hand that trembles
    EXPECT_EQ(dragged.count(), 0);
    moveTo(point + QPoint(37, 7));
    moveTo(point + QPoint(67, 7));
    EXPECT_EQ(dragged.count(), 2);
    EXPECT_EQ(picked.count(), 0);
    EXPECT_NEAR(dragged[1][1].toDouble(), oneCell().target_K.y(), 0.3) << "it jumped to the pointer";
    EXPECT_EQ(map.picture(map.size(), 1.0).pixelColor(point + QPoint(60, 0)), QColor(Qt::white));
    QTest::mouseRelease(&map, Qt::LeftButton, {}, point + QPoint(67, 7));
    ASSERT_EQ(picked.count(), 1);
    EXPECT_EQ(picked[0], dragged[1]);
}

// Catches a drag that goes on, or is taken over, after the map was hidden, the targets were locked or the
// button was let go elsewhere; and one whose end nobody hears of.
TEST_F(ReachMapTest, ADragThatIsBrokenOffIsDropped) {
    QSignalSpy dragged{&map, &ReachMap::targetsDragged};
    QSignalSpy dropped{&map, &ReachMap::dragDropped};
    const QPoint point = cell().center();
    const auto drag = [&] {
        show(oneCell());
        QTest::mousePress(&map, Qt::LeftButton, {}, point);
        moveTo(point + QPoint(40, 0));
    };
    drag();
    map.hide();
    EXPECT_EQ(dropped.count(), 1);
    map.show();
    drag();
    map.setEditable(false);
    EXPECT_EQ(dropped.count(), 2);
    map.setEditable(true);
    drag();
    QMouseEvent move(QEvent::MouseMove, point, map.mapToGlobal(point), Qt::NoButton, Qt::NoButton, {});
    QApplication::sendEvent(&map, &move);
    EXPECT_EQ(dropped.count(), 3);
    moveTo(point + QPoint(80, 0));
    QTest::mouseRelease(&map, Qt::LeftButton, {}, point + QPoint(80, 0));
    EXPECT_EQ(dragged.count(), 3);
    EXPECT_EQ(picked.count(), 0);
}

// Catches: a tip about another place, or that says the contrary.
TEST_F(ReachMapTest, TheTipSaysWhatGoesTogether) {
    const QPoint place = cell().center();
    const auto tipAt = [this](QPoint at) {
        QHelpEvent help(QEvent::ToolTip, at, map.mapToGlobal(at));
        QApplication::sendEvent(&map, &help);
        return QToolTip::text();
    };
    EXPECT_TRUE(tipAt(place).contains("some pose has both")) << QToolTip::text().toStdString();
    EXPECT_TRUE(tipAt(place).contains(QRegularExpression("circle (39.[89]|40.[012])")));
    EXPECT_TRUE(tipAt(place + QPoint(100, 0)).contains("no pose has both"));
    map.setNames("<b>circle</b>", "bunny");
    EXPECT_TRUE(tipAt(place).startsWith("&lt;b&gt;")) << "a name is no mark-up";
    QToolTip::hideText();
}

} // namespace
} // namespace bask
