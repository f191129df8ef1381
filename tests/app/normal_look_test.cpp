// A normal state is quiet (ISA-101): no page has an alarm's colour, light or dark.

#include "tests/app/window_fixture.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"

#include <QImage>
#include <QOpenGLWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace bask::test {
namespace {

constexpr double kLeastShare =
    0.12; ///< of an alarm's colour over a ground; tints of chips have 14 % and more
/// Channels off the line from the ground to the alarm's colour: rounding, and in shares of that colour a
/// third of the way to its nearest neighbours, the yellow end of the colour map and the third object's
/// purple.
constexpr double kRounding = 1.5, kOff = 8.0;
/// In a picture of the rig only the very colour counts: the source glows in it, from red to orange.
constexpr int kSameColour = 12;
constexpr int kHandful = 8; ///< pixels, where lines that are blended cross

using Channels = std::array<double, 3>;

Channels channelsOf(QRgb colour) {
    return {1.0 * qRed(colour), 1.0 * qGreen(colour), 1.0 * qBlue(colour)};
}

/// Whether it is the ground with some of the alarm's colour over it, or that colour alone.
bool isBetween(const Channels& colour, const Channels& ground, const Channels& alarm) {
    double along = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
        along += (colour[k] - ground[k]) * (alarm[k] - ground[k]);
        whole += (alarm[k] - ground[k]) * (alarm[k] - ground[k]);
    }
    const double share = std::min(1.0, along / whole);
    if (share < kLeastShare)
        return false;
    for (std::size_t k = 0; k < 3; ++k)
        if (std::abs(colour[k] - ground[k] - share * (alarm[k] - ground[k])) > kRounding + share * kOff)
            return false;
    return true;
}

bool isLikeAlarm(QRgb colour, bool dark) {
    if (qRed(colour) - qBlue(colour) < 8) // soon told: all of them are warm, and the greys are not
        return false;
    for (const QPalette::ColorRole role : {QPalette::Window, QPalette::Base})
        for (int priority = 1; priority <= 3; ++priority)
            if (isBetween(channelsOf(colour), channelsOf(themePalette(dark).color(role).rgb()),
                          channelsOf(alarmColor(priority, dark).rgb())))
                return true;
    return false;
}

bool isAlarm(QRgb colour, bool dark) {
    for (int priority = 1; priority <= 3; ++priority) {
        const QRgb alarm = alarmColor(priority, dark).rgb();
        if (std::abs(qRed(colour) - qRed(alarm)) + std::abs(qGreen(colour) - qGreen(alarm)) +
                std::abs(qBlue(colour) - qBlue(alarm)) <
            kSameColour)
            return true;
    }
    return false;
}

class NormalLookTest : public WindowTest {
protected:
    struct Seen {
        int count = 0;
        QRect where;
    };

    /// Pixels with an alarm's colour, but for STOP, which is red always.
    Seen alarmsSeen(bool dark) {
        const QImage picture = window->grab().toImage();
        const double ratio = picture.devicePixelRatio();
        const auto placeOf = [&](const QWidget* part) {
            const QRect place(part->mapTo(window.get(), QPoint(0, 0)), part->size());
            return QRectF(place.topLeft() * ratio, place.size() * ratio).toAlignedRect();
        };
        const QRect stop = placeOf(find<QWidget>("stopButton"));
        QList<QRect> scenes;
        for (const QOpenGLWidget* scene : window->findChildren<QOpenGLWidget*>())
            if (scene->isVisible())
                scenes << placeOf(scene);
        Seen seen;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) {
                if (stop.contains(x, y))
                    continue;
                const bool isInScene =
                    std::ranges::any_of(scenes, [&](const QRect& scene) { return scene.contains(x, y); });
                const QRgb colour = picture.pixel(x, y);
                if (isInScene ? isAlarm(colour, dark) : isLikeAlarm(colour, dark)) {
                    ++seen.count;
                    seen.where |= QRect(x, y, 1, 1);
                }
            }
        return seen;
    }

    bool isNormal() const {
        const Snapshot& now = window->lastSnapshot();
        return now.alarms.empty() && (now.state == RunState::Ready || now.state == RunState::Armed ||
                                      now.state == RunState::Running || now.state == RunState::Settled);
    }

    void expectQuietPages(const std::string& when) {
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            const bool dark = theme == Theme::Dark;
            applyTheme(*qApp, theme);
            for (int page = 0; page < kPages; ++page) {
                window->pages().show(static_cast<Page>(page));
                waitForLayouts();
                ASSERT_EQ(isDark(window.get()), dark);
                ASSERT_TRUE(isNormal())
                    << when << ", page " << page << ": " << runStateName(window->lastSnapshot().state);
                const Seen seen = alarmsSeen(dark);
                EXPECT_LE(seen.count, kHandful)
                    << when << ", page " << page << (dark ? ", dark: in " : ", light: in ") << seen.where.x()
                    << ", " << seen.where.y() << ", " << seen.where.width() << " x " << seen.where.height();
            }
        }
    }
};

// Catches: an alarm's colour where nothing is wrong, in a mark, a frame, a tint or a picture, on any page.
TEST_F(NormalLookTest, NoPageHasAnAlarmsColour) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_NO_FATAL_FAILURE(expectQuietPages("ready"));
    ASSERT_NO_FATAL_FAILURE(startRun(6));
    ASSERT_NO_FATAL_FAILURE(expectQuietPages("running"));
}

// Catches: a look that would find nothing anyway.
TEST_F(NormalLookTest, AnAlarmsColoursAreFound) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    window->pages().show(Page::Run);
    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(waitForState(RunState::Fault));
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        const bool dark = theme == Theme::Dark;
        applyTheme(*qApp, theme);
        waitForLayouts();
        EXPECT_GT(alarmsSeen(dark).count, 500) << "the chip";
        const QPalette palette = themePalette(dark);
        for (int priority = 1; priority <= 3; ++priority) {
            const QColor alarm = alarmColor(priority, dark);
            EXPECT_TRUE(isLikeAlarm(alarm.rgb(), dark)) << priority;
            EXPECT_TRUE(isLikeAlarm(mixed(alarm, palette.color(QPalette::Window), 0.14).rgb(), dark))
                << priority;
        }
        for (int object = 0; object < 5; ++object)
            for (double weight = 0.05; weight <= 1.0; weight += 0.05)
                EXPECT_FALSE(isLikeAlarm(
                    mixed(seriesColor(object, dark), palette.color(QPalette::Base), weight).rgb(), dark))
                    << object << ' ' << weight;
        EXPECT_FALSE(isLikeAlarm(mapColour(1.0, dark).rgb(), dark));
    }
}

} // namespace
} // namespace bask::test
