// A normal state is quiet (ISA-101): no page has an alarm's colour, light or dark. And no colour is needed:
// the page tells its states apart in black and white.

#include "engine/base/message_code.h"
#include "engine/recording/session_file.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QOpenGLWidget>
#include <QPainter>
#include <QTabWidget>
#include <QTreeWidget>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

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
                expectQuiet(dark, when + ", page " + std::to_string(page));
            }
        }
    }

    void expectQuiet(bool dark, const std::string& where) {
        const Seen seen = alarmsSeen(dark);
        EXPECT_LE(seen.count, kHandful)
            << where << (dark ? ", dark: in " : ", light: in ") << seen.where.x() << ", " << seen.where.y()
            << ", " << seen.where.width() << " x " << seen.where.height();
    }

    /// All that a tab hides until it is chosen.
    void expectQuietTabs() {
        for (const Theme theme : {Theme::Light, Theme::Dark}) {
            applyTheme(*qApp, theme);
            for (int page = 0; page < kPages; ++page) {
                window->pages().show(static_cast<Page>(page));
                const QWidget& where = page == 0 ? *window : static_cast<QWidget&>(window->pages());
                for (auto* tabs : where.findChildren<QTabWidget*>()) {
                    const int first = tabs->currentIndex();
                    for (int tab = 0; tabs->isVisible() && tab < tabs->count(); ++tab) {
                        if (tab == first || !tabs->isTabVisible(tab))
                            continue;
                        tabs->setCurrentIndex(tab);
                        waitForLayouts();
                        ASSERT_TRUE(isNormal());
                        expectQuiet(theme == Theme::Dark, "page " + std::to_string(page) + ", tab " +
                                                              tabs->tabText(tab).toStdString());
                    }
                    tabs->setCurrentIndex(first);
                }
            }
        }
    }

    /// Recorded runs that ended badly, on two of which an alarm is told, and a file that is none.
    QStringList writePastFaults() {
        const QFileInfo next(window->files().nextRecordingPath());
        QStringList paths;
        const auto record = [&](const char* name, const char* outcome) {
            paths << next.dir().filePath(QLatin1String(name));
            QFile::remove(paths.back());
            auto writer =
                SessionWriter::create(paths.back().toStdString(), window->document().experiment(), true);
            ASSERT_TRUE(writer);
            ASSERT_TRUE(
                (*writer)->add(TraceEvent{1.0, {MessageCode::SafetyObjectHot, {"disk", "160", "150"}}}));
            ASSERT_TRUE((*writer)->finish(outcome));
        };
        record("past-fault.bask", "fault");
        record("past-stop.bask", "emergency-stop");
        paths << next.dir().filePath(QStringLiteral("past-damage.bask"));
        QFile damaged(paths.back());
        EXPECT_TRUE(damaged.open(QIODevice::WriteOnly));
        damaged.write(QByteArray(9000, 'x'));
        return paths;
    }

    /// The window but for the 3-D scene, in greys.
    QImage inGreys() {
        waitForLayouts();
        QPixmap picture = window->grab();
        QPainter painter(&picture);
        for (const QOpenGLWidget* scene : window->findChildren<QOpenGLWidget*>())
            if (scene->isVisible())
                painter.fillRect(QRect(scene->mapTo(window.get(), QPoint(0, 0)), scene->size()), Qt::gray);
        painter.end();
        return picture.toImage().convertToFormat(QImage::Format_Grayscale8);
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

// Catches: an alarm's colour in a tab that is not in front at first.
TEST_F(NormalLookTest, NoTabHasAnAlarmsColour) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_NO_FATAL_FAILURE(expectQuietTabs());
}

// Catches: red in a list of runs that are over: nothing is to be done about them now.
TEST_F(NormalLookTest, PastFaultsAreNoAlarms) {
    openWindow();
    ASSERT_TRUE(waitForState(RunState::Ready));
    const QStringList past = writePastFaults();
    window->pages().show(Page::Review);
    auto* tree = find<QTreeWidget>("sessionTree");
    ASSERT_TRUE(waitFor([&] { return tree->topLevelItemCount() >= past.size(); }));
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        waitForLayouts();
        expectQuiet(theme == Theme::Dark, "past faults");
        keepPicture(QStringLiteral("past-faults-%1").arg(static_cast<int>(theme)));
    }
    for (const QString& path : past)
        EXPECT_TRUE(QFile::remove(path));
}

// Catches: a state that its colour alone tells from another.
TEST_F(NormalLookTest, StatesAreToldApartInBlackAndWhite) {
    openWindow();
    const Snapshot calm = freeze();
    window->pages().show(Page::Run);
    const auto with = [&](const std::function<void(Snapshot&)>& change) {
        Snapshot snapshot = calm;
        snapshot.state = RunState::Running;
        change(snapshot);
        return snapshot;
    };
    const auto withAlarm = [&](int priority, bool isActive, bool isSeen) {
        return with([=](Snapshot& snapshot) {
            Alarm alarm;
            alarm.id = 1;
            alarm.message = {MessageCode::SafetyObjectHot, {"disk", "152.3", "150"}};
            alarm.priority = priority;
            alarm.isActive = isActive;
            alarm.isAcknowledged = isSeen;
            snapshot.alarms = {alarm};
        });
    };
    const std::vector<std::pair<std::string, Snapshot>> states{
        {"running", with([](Snapshot&) {})},
        {"live", with([](Snapshot& snapshot) { snapshot.simulated = false; })},
        {"settled", with([](Snapshot& snapshot) { snapshot.state = RunState::Settled; })},
        {"holding", with([](Snapshot& snapshot) { snapshot.state = RunState::Holding; })},
        {"fault", with([](Snapshot& snapshot) { snapshot.state = RunState::Fault; })},
        {"stale", with([](Snapshot& snapshot) { snapshot.sensors[0] = SensorTrust::Stale; })},
        {"not believed", with([](Snapshot& snapshot) { snapshot.sensors[0] = SensorTrust::Distrusted; })},
        {"no reading", with([](Snapshot& snapshot) { snapshot.latest.objects[0].valid = false; })},
        {"above its trip limit",
         with([](Snapshot& snapshot) { snapshot.latest.objects[0].measured_K = 900.0; })},
        {"place not known", with([](Snapshot& snapshot) { snapshot.place = PlaceState::Unknown; })},
        {"heat not known", with([](Snapshot& snapshot) { snapshot.heat = HeatState::Unknown; })},
        {"heat on", with([](Snapshot& snapshot) { snapshot.heat = HeatState::On; })},
        {"alarm 1", withAlarm(1, true, false)},
        {"alarm 2", withAlarm(2, true, false)},
        {"alarm 3", withAlarm(3, true, false)},
        {"alarm 1, seen", withAlarm(1, true, true)},
        {"alarm 1, over", withAlarm(1, false, false)},
    };
    std::vector<QImage> looks;
    for (const auto& [name, snapshot] : states) {
        emit window->engine().snapshot(calm);
        emit window->engine().snapshot(snapshot);
        looks.push_back(inGreys());
        keepPicture(QStringLiteral("grey-") + QString::fromStdString(name).replace(u' ', u'-'));
    }
    constexpr int kSeen = 60, kShape = 12; // levels of 255, and pixels of the smallest mark's figure
    for (std::size_t i = 0; i < looks.size(); ++i)
        for (std::size_t j = i + 1; j < looks.size(); ++j) {
            ASSERT_EQ(looks[i].size(), looks[j].size());
            int differ = 0;
            for (int y = 0; y < looks[i].height(); ++y) {
                const uchar *one = looks[i].constScanLine(y), *other = looks[j].constScanLine(y);
                for (int x = 0; x < looks[i].width(); ++x)
                    differ += std::abs(one[x] - other[x]) >= kSeen ? 1 : 0;
            }
            EXPECT_GE(differ, kShape) << states[i].first << " and " << states[j].first;
        }
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
