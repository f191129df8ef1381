// The large numbers as they are seen: in their pixels, at every size, in every state.

#include "widgets/run/large_numbers.h"

#include "engine/base/message_code.h"
#include "tests/support/longer_translator.h"
#include "widgets/common/stop_button.h"
#include "widgets/common/theme.h"
#include "widgets/run/large_text.h"
#include "widgets/run/large_tile.h"

#include <QApplication>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

namespace bask {
namespace {

constexpr QSize kSmallest{640, 400}, kUsual{1920, 1080}, kLargest{3840, 2160};

/// What an object's tile shows of this reading.
ShownObject shownOf(double measured_K, const SensorView& sensor = {}, bool isValid = true,
                    const char* name = "bunny") {
    ObjectTile tile(0);
    tile.setName(QString::fromUtf8(name));
    ObjectSample sample;
    sample.measured_K = sensor.told_K;
    sample.target_K = 313.15;
    sample.valid = true;
    if (!isValid) // it was believed before
        tile.setSample(0.0, sample);
    sample.measured_K = measured_K;
    sample.valid = isValid;
    tile.setSample(1.0, sample, sensor);
    return tile.shown();
}

std::vector<ShownObject> objects(int count) {
    const char* const names[] = {"circle", "aluminium hand with a painted palm", "bunny", "plate 7"};
    std::vector<ShownObject> out;
    out.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        out.push_back(shownOf(298.15 + 31.7 * i, {}, true, names[i % 4]));
    return out;
}

Snapshot running() {
    Snapshot snapshot;
    snapshot.state = RunState::Running;
    snapshot.runTime_s = 723.0;
    snapshot.source_K = snapshot.latest.source_K = 455.45;
    snapshot.sourceAge_s = 0.1;
    snapshot.heat = HeatState::On;
    return snapshot;
}

Alarm hotObject() {
    Alarm alarm;
    alarm.id = 1;
    alarm.priority = 2;
    alarm.message = {MessageCode::SafetyObjectHot, {"aluminium hand with a painted palm", "152.3", "150"}};
    return alarm;
}

int difference(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
}

constexpr int kInk = 60; ///< more is not the ground's own colour

/// Where the picture differs from its corner.
QRect inkIn(const QImage& picture) {
    QRect ink;
    const QRgb ground = picture.pixel(0, 0);
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            if (difference(picture.pixel(x, y), ground) > kInk)
                ink |= QRect(x, y, 1, 1);
    return ink;
}

struct Large {
    LargeNumbers window;

    explicit Large(QSize size = kUsual) {
        window.resize(size);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    }
    void tell(const Snapshot& snapshot, const std::vector<ShownObject>& shown,
              TemperatureUnit unit = TemperatureUnit::Celsius) {
        window.apply(snapshot, shown, unit);
        for (int i = 0; i < 3; ++i)
            QCoreApplication::processEvents();
    }
    LargeText* text(const char* name, const QWidget* in = nullptr) const {
        auto* found = (in ? in : &window)->findChild<LargeText*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    QString words(const char* name) const { return text(name)->text(); }
    LargeTile* tile(int i) const {
        return window.findChild<LargeTile*>(QStringLiteral("largeTile.%1").arg(i));
    }
    StopButton* stop() const { return window.findChild<StopButton*>(QStringLiteral("largeStop")); }
    QImage picture() { return window.grab().toImage().convertToFormat(QImage::Format_RGB32); }
    QRect placeOf(const QWidget* part) const { return {part->mapTo(&window, QPoint()), part->size()}; }

    /// Everything is inside of the window, beside everything else, and neither an end of a line nor a figure
    /// of a temperature touches an edge of its place.
    void expectWhole(const std::string& where) {
        EXPECT_TRUE(window.rect().contains(placeOf(stop()))) << where;
        EXPECT_GE(stop()->width(), stop()->sizeHint().width()) << where;
        EXPECT_GE(stop()->height(), stop()->sizeHint().height()) << where;
        const QImage all = picture();
        const QList<LargeText*> texts = window.findChildren<LargeText*>();
        int looked = 0;
        for (const LargeText* each : texts) {
            if (each->text().isEmpty())
                continue;
            ++looked;
            const std::string what = where + ": " + each->text().toStdString();
            const QRect place = placeOf(each);
            ASSERT_TRUE(window.rect().contains(place)) << what;
            EXPECT_FALSE(place.intersects(placeOf(stop()))) << what;
            EXPECT_FALSE(each->isShortened()) << what;
            const QRect ink = inkIn(all.copy(place));
            EXPECT_FALSE(ink.isEmpty()) << what;
            const int high = each->objectName() == QLatin1String("largeTemperature") ? 1 : 0;
            EXPECT_TRUE(QRect(QPoint(), place.size()).adjusted(1, high, -1, -high).contains(ink)) << what;
            for (const LargeText* other : texts)
                EXPECT_FALSE(other != each && place.intersects(placeOf(other))) << what;
        }
        EXPECT_GT(looked, 5) << where;
    }
    /// Height of the lowest figures of a temperature on the screen, in px.
    int figureHeight(int count) {
        const QImage all = picture();
        int lowest = all.height();
        for (int i = 0; i < count; ++i)
            lowest = std::min(lowest, inkIn(all.copy(placeOf(text("largeTemperature", tile(i))))).height());
        return lowest;
    }
    /// The darkest that a text is drawn with; the theme is light.
    int darkest(const QWidget* part) {
        const QImage picture = this->picture().copy(placeOf(part));
        int least = 255;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                least = std::min(least, qGray(picture.pixel(x, y)));
        return least;
    }
    /// Pixels of this colour outside of STOP.
    int count(const QColor& colour) {
        const QImage all = picture();
        const QRect place = placeOf(stop());
        int found = 0;
        for (int y = 0; y < all.height(); ++y)
            for (int x = 0; x < all.width(); ++x)
                if (!place.contains(x, y) && difference(all.pixel(x, y), colour.rgb()) < 12)
                    ++found;
        return found;
    }
};

std::string sizeWords(QSize size, int count) {
    return QStringLiteral("%1 x %2, %3 objects")
        .arg(size.width())
        .arg(size.height())
        .arg(count)
        .toStdString();
}

} // namespace

// Catches: figures that nobody reads from 4 m, in any unit, with an alarm, with a negative one among them.
TEST(LargeNumbers, AFigureIsAnEighthOfTheScreensHeight) {
    for (const QSize size : {kUsual, QSize(1920, 1200), kLargest}) {
        Large large(size);
        for (int count = 1; count <= 4; ++count)
            for (const TemperatureUnit unit :
                 {TemperatureUnit::Celsius, TemperatureUnit::Kelvin, TemperatureUnit::Fahrenheit}) {
                Snapshot snapshot = running();
                snapshot.alarms = {hotObject()};
                large.tell(snapshot, objects(count), unit);
                ASSERT_EQ(large.window.size(), size);
                EXPECT_GE(large.figureHeight(count), size.height() / 8) << sizeWords(size, count);
            }
        large.tell(running(), {shownOf(268.0), shownOf(313.0), shownOf(313.0), shownOf(313.0)});
        EXPECT_GE(large.figureHeight(4), size.height() / 8) << "beside a negative one";
    }
}

// Catches: a text that is cut off, shortened or under another one, at any size and in a longer language.
TEST(LargeNumbers, NothingIsCutOffAtAnySize) {
    Snapshot snapshot = running();
    snapshot.state = RunState::Fault; // the longest word
    snapshot.runTime_s = 36000.0;
    snapshot.source_K.reset();
    snapshot.sourceAge_s = 12.0;
    snapshot.heat = HeatState::Unknown;
    snapshot.alarms = {hotObject()};
    std::vector<ShownObject> shown = objects(4);
    shown[1] = shownOf(413.4, {SensorTrust::Distrusted, 12.0, 413.4});
    shown[2] = shownOf(313.4, {SensorTrust::Stale, 125.0, 313.4});
    for (const QSize size : {kSmallest, QSize(1024, 768), kUsual, QSize(1080, 1920), kLargest}) {
        Large large(size);
        for (int count = 1; count <= 8; ++count) {
            large.tell(snapshot, count == 4 ? shown : objects(count));
            ASSERT_NO_FATAL_FAILURE(large.expectWhole(sizeWords(size, count)));
        }
        ASSERT_EQ(large.window.size(), size) << "it grew";
    }
    LongerTranslator longer;
    QApplication::installTranslator(&longer);
    {
        Large large(kSmallest);
        large.tell(snapshot, shown);
        large.window.setAnswering(false);
        ASSERT_NO_FATAL_FAILURE(large.expectWhole("in a longer language"));
        EXPECT_TRUE(large.window.grab().save(QStringLiteral("large_numbers_long.png")));
    }
    QApplication::removeTranslator(&longer);
}

// Catches: "Heat off" across the room beside a plate that heats all the same.
TEST(LargeNumbers, ASourceThatHeatsUnaskedIsNotSimplyOff) {
    Large large;
    Snapshot snapshot = running();
    snapshot.heat = HeatState::Off;
    large.tell(snapshot, objects(1));
    EXPECT_EQ(large.text("largeHeat")->text(), QStringLiteral("Heat off"));
    Alarm alarm;
    alarm.message = {MessageCode::SafetySourceHeatsUnasked, {"11", "20", "10"}};
    snapshot.alarms = {alarm};
    large.tell(snapshot, objects(1));
    EXPECT_EQ(large.text("largeHeat")->text(), QStringLiteral("Heats though off"));
    EXPECT_EQ(large.text("largeHeat")->look().priority, 1);
    EXPECT_TRUE(large.text("largeHeat")->look().isAlarmInk);
    ASSERT_NO_FATAL_FAILURE(large.expectWhole("heats though off"));
}

// Catches: a value that is stale, not believed or lost, and looks as one that is known.
TEST(LargeNumbers, AStaleValueIsNotShownAsKnown) {
    Large large;
    const int black = qGray(large.window.palette().color(QPalette::WindowText).rgb());
    const int grey = qGray(secondaryText(false).rgb());
    ASSERT_GT(grey, black + 30);
    const auto see = [&](const ShownObject& object) {
        large.tell(running(), {object});
        return large.text("largeTemperature");
    };
    const LargeText* temperature = see(shownOf(303.15));
    EXPECT_EQ(temperature->text(), QStringLiteral("30.0"));
    EXPECT_LT(large.darkest(temperature), black + 10);
    EXPECT_EQ(large.words("largeError"), QStringLiteral("\u221210.0\u00a0K"));
    EXPECT_EQ(large.words("largeTarget"), QStringLiteral("40.0\u00a0°C"));
    EXPECT_EQ(large.count(unknownColor(false)), 0);
    ShownObject near = shownOf(273.15 + 40.14);
    near.target_K = 273.15 + 39.96;
    see(near);
    EXPECT_EQ(large.words("largeError"), QStringLiteral("+0.1\u00a0K")) << "40.1 beside 40.0";

    struct Doubt {
        ShownObject object;
        const char *word, *reading;
        bool isStruck;
    };
    for (const Doubt& doubt :
         {Doubt{shownOf(303.15, {SensorTrust::Stale, 12.0, 303.15}), "Stale · 12 s old", "30.0", false},
          Doubt{shownOf(303.15, {SensorTrust::Distrusted, 12.0, 341.15}), "Not believed", "68.0", true},
          Doubt{shownOf(0.0, {SensorTrust::Stale, 125.0, 303.15}, false), "UNKNOWN · 2:05 old", "30.0",
                false},
          Doubt{shownOf(0.0, {}, false), "UNKNOWN", "\u2014", false}}) {
        SCOPED_TRACE(doubt.word);
        EXPECT_EQ(see(doubt.object), temperature);
        EXPECT_EQ(temperature->text(), QString::fromUtf8(doubt.reading));
        EXPECT_EQ(large.words("largeWord"), QString::fromUtf8(doubt.word));
        EXPECT_EQ(large.words("largeError"), QStringLiteral("\u2014")) << "nobody knows it";
        EXPECT_EQ(temperature->look().isStruck, doubt.isStruck);
        EXPECT_GT(large.darkest(temperature), black + 30) << "as dark as a known one";
        EXPECT_GT(large.count(unknownColor(false)), 100) << "mark, frame and word";
        EXPECT_TRUE(large.tile(0)->accessibleDescription().startsWith(QString::fromUtf8(doubt.word)));
    }
    EXPECT_EQ(large.tile(0)->accessibleName(), QStringLiteral("Object bunny"));
    EXPECT_LT(large.darkest(see(shownOf(304.15))), black + 10) << "known again";
}

// Catches: figures that look alive after the engine has fallen silent, and claims before it has spoken.
TEST(LargeNumbers, ASilentEngineIsSeen) {
    Large large;
    EXPECT_EQ(large.words("largeState"), QString());
    EXPECT_EQ(large.words("largeHeat"), QString());
    large.tell(running(), objects(2));
    EXPECT_EQ(large.words("largeState"), QStringLiteral("Running"));
    EXPECT_EQ(large.words("largeClock"), QStringLiteral("Run 12:03"));
    EXPECT_EQ(large.words("largeSource"), QStringLiteral("Source 182.3\u00a0°C"));
    EXPECT_EQ(large.words("largeHeat"), QStringLiteral("Heat on"));
    EXPECT_EQ(large.words("largeAlarm"), QString());
    large.window.setAnswering(false);
    EXPECT_EQ(large.words("largeState"), QStringLiteral("UNKNOWN"));
    EXPECT_TRUE(large.text("largeState")->look().isUnknown);
    EXPECT_EQ(large.words("largeHeat"), QStringLiteral("Heat UNKNOWN"));
    EXPECT_TRUE(large.words("largeAlarm").startsWith(QStringLiteral("The engine is not answering")));
    for (const char* name : {"largeClock", "largeSource"})
        EXPECT_TRUE(large.text(name)->look().isGrey) << name;
    Snapshot alarmed = running();
    alarmed.alarms = {hotObject()};
    large.tell(alarmed, objects(2));
    EXPECT_TRUE(large.words("largeAlarm").contains(QStringLiteral("warning limit")) ||
                large.words("largeAlarm").contains(QStringLiteral("trip limit")))
        << "it is not lost over the silence: " << large.words("largeAlarm").toStdString();
    large.window.setAnswering(true);
    EXPECT_EQ(large.words("largeState"), QStringLiteral("Running"));
    EXPECT_FALSE(large.words("largeAlarm").contains(QStringLiteral("answering")));
}

// Catches: an alarm that is over, or another than the gravest, and SIMULATED said of a real rig.
TEST(LargeNumbers, SaysTheGravestAlarmThatStillIsSo) {
    Large large;
    Snapshot snapshot = running();
    snapshot.alarms = {hotObject(), hotObject()};
    snapshot.alarms[0].isActive = false;
    snapshot.alarms[1].message.args[0] = MessageArg(std::string("plate 7"));
    large.tell(snapshot, objects(2));
    EXPECT_TRUE(large.words("largeAlarm").contains(QStringLiteral("plate 7")));
    EXPECT_EQ(large.text("largeAlarm")->look().priority, 2);
    EXPECT_EQ(large.words("largeRig"), QStringLiteral("SIMULATED"));
    EXPECT_GT(large.count(alarmColor(2, false)), 20) << "its mark";
    snapshot.alarms[1].isActive = false;
    snapshot.simulated = false;
    large.tell(snapshot, objects(2));
    EXPECT_EQ(large.words("largeAlarm"), QString());
    EXPECT_EQ(large.words("largeRig"), QStringLiteral("LIVE"));
}

// Catches: a state and a STOP that nobody reads from 4 m: about 15 mm of a screen with 96 dots an inch.
TEST(LargeNumbers, StateAndStopAreReadFromAfar) {
    Large large(QSize(960, 600));
    for (const RunState state : {RunState::Running, RunState::Holding, RunState::Settled}) {
        Snapshot snapshot = running();
        snapshot.state = state;
        large.tell(snapshot, objects(3));
        ASSERT_EQ(large.window.size(), QSize(960, 600));
        EXPECT_GE(inkIn(large.picture().copy(large.placeOf(large.text("largeState")))).height(), 52)
            << runStateName(state);
    }
    QFont word = large.stop()->font();
    word.setBold(true);
    word.setPointSizeF(word.pointSizeF() * 1.35);
    EXPECT_GE(QFontMetricsF(word).capHeight(), 42.0);
    ASSERT_NO_FATAL_FAILURE(large.expectWhole("with a large state"));
}

// Catches: a run that ends by itself without a word across the room, and an alarm without what to do.
TEST(LargeNumbers, TheCountdownAndTheRemedyAreSaid) {
    for (const QSize size : {kSmallest, QSize(960, 600), kUsual}) {
        Large large(size);
        Snapshot snapshot = running();
        snapshot.state = RunState::Holding;
        Alarm lost = hotObject();
        lost.message = {MessageCode::ReasonSensorInvalid, {"bunny"}};
        snapshot.alarms = {lost};
        large.tell(snapshot, objects(3));
        EXPECT_TRUE(large.words("largeAlarm").endsWith(QStringLiteral("Check it.")));
        EXPECT_EQ(large.words("largeCountdown"), QString());
        const int whole = large.text("largeAlarm")->width();
        snapshot.pending = PendingAction{{MessageCode::ActionEndRun, {}}, lost.message, 11.2};
        large.tell(snapshot, objects(3));
        EXPECT_TRUE(large.words("largeCountdown").startsWith(QStringLiteral("In 12 s: The run ends")))
            << large.words("largeCountdown").toStdString();
        EXPECT_LT(large.text("largeAlarm")->width(), whole);
        ASSERT_NO_FATAL_FAILURE(large.expectWhole("with a countdown"));
        large.window.setAnswering(false);
        EXPECT_EQ(large.words("largeCountdown"), QString()) << "nobody knows what it does";
        EXPECT_EQ(large.text("largeAlarm")->width(), whole);
    }
}

// Catches: an alarm's colour where there is no alarm, in either theme.
TEST(LargeNumbers, ANormalStateHasNoAlarmColour) {
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        const bool dark = theme == Theme::Dark;
        Large large(QSize(960, 600));
        for (const RunState state : {RunState::Idle, RunState::Ready, RunState::Armed, RunState::Running,
                                     RunState::Settled, RunState::Stopping, RunState::Stopped}) {
            Snapshot snapshot = running();
            snapshot.state = state;
            large.tell(snapshot, objects(4));
            EXPECT_EQ(isDark(&large.window), dark);
            for (int priority = 1; priority <= 3; ++priority)
                EXPECT_EQ(large.count(alarmColor(priority, dark)), 0) << runStateName(state) << priority;
            EXPECT_EQ(large.count(unknownColor(dark)), 0) << runStateName(state);
        }
        Snapshot fault = running();
        fault.state = RunState::Fault;
        large.tell(fault, objects(4));
        EXPECT_GT(large.count(alarmColor(1, dark)), 20) << "the look itself works";
        EXPECT_TRUE(
            large.window.grab().save(QStringLiteral("large_numbers_%1.png").arg(dark ? "dark" : "light")));
    }
    applyTheme(*qApp, Theme::Light);
}

// Catches: a STOP that waits for the release, or that a key is deaf to.
TEST(LargeNumbers, StopActsOnPress) {
    Large large;
    large.tell(running(), objects(2));
    EXPECT_NE(large.window.focusWidget(), large.stop()) << "Space would be for STOP";
    QSignalSpy stop(&large.window, &LargeNumbers::stopRequested);
    QTest::mousePress(large.stop(), Qt::LeftButton);
    EXPECT_EQ(stop.count(), 1);
    QTest::mouseRelease(large.stop(), Qt::LeftButton, Qt::NoModifier, {-50, -50});
    QTest::keyClick(&large.window, Qt::Key_F12);
    EXPECT_EQ(stop.count(), 2);
}

// Catches: a full screen that no key begins, or ends, and a held key that closes the window.
TEST(LargeNumbers, FillsTheScreenByKey) {
    Large large(kSmallest);
    large.window.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&large.window));
    EXPECT_FALSE(large.window.isFullScreen());
    for (const Qt::Key end : {Qt::Key_F11, Qt::Key_Escape}) {
        QTest::keyClick(&large.window, Qt::Key_F11);
        EXPECT_TRUE(large.window.isFullScreen());
        QTest::keyPress(&large.window, end);
        EXPECT_FALSE(large.window.isFullScreen());
        QTest::simulateEvent(&large.window, true, end, Qt::NoModifier, QString(), true); // it is held
        EXPECT_FALSE(large.window.isFullScreen());
        EXPECT_TRUE(large.window.isVisible()) << "with its STOP";
        QTest::keyRelease(&large.window, end);
    }
    QTest::keyClick(&large.window, Qt::Key_Escape);
    EXPECT_FALSE(large.window.isVisible()) << "it fills no screen: Esc closes it";
}

} // namespace bask
