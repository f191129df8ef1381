#include "app/resources.h"
#include "app/state_bar.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "widgets/common/language.h"

#include <QAbstractButton>
#include <QLabel>
#include <QMainWindow>
#include <QPixmap>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <gtest/gtest.h>

namespace bask::test {
namespace {

constexpr std::array kVerbButtons{"armButton",     "startButton",   "holdButton",
                                  "stopRunButton", "retreatButton", "resetButton"};

struct Bar {
    QMainWindow window;
    Actions actions{&window};
    StateBar bar{actions, &window};

    explicit Bar(int width) {
        QPixmap picture(20, 20); // a button without one shows its text however short it is
        picture.fill(Qt::black);
        for (int i = 0; i < kVerbs; ++i)
            actions.verb(static_cast<Verb>(i))->setIcon(picture);
        bar.resize(width, bar.sizeHint().height());
        window.resize(width, 200);
        window.show();
        settle();
    }
    void settle() const {
        for (int i = 0; i < 4; ++i)
            QCoreApplication::processEvents();
    }
    QAbstractButton* button(const char* name) const {
        return bar.findChild<QAbstractButton*>(QLatin1String(name));
    }
    void tell(const Snapshot& snapshot) {
        actions.apply(snapshot);
        bar.apply(snapshot);
        bar.resize(bar.width(), bar.sizeHint().height()); // as the tool bar around it does
        settle();
    }
};

Alarm longAlarm() {
    Alarm alarm;
    alarm.id = 1;
    alarm.message = {MessageCode::SafetyObjectHot, {"aluminium hand with a painted palm", "152.3", "150"}};
    return alarm;
}

} // namespace

// Catches: Reset under the hand that was about to press Stop, and verbs pushed aside by an alarm or a fault.
TEST(StateBar, EveryVerbKeepsItsPlaceInEveryStateAndWithAlarms) {
    for (const int width : {512, 640, 853, 933, 1024, 1280, 1600}) {
        Bar bar(width);
        std::map<std::string, QRect> places;
        for (int state = 0; state <= static_cast<int>(RunState::Fault); ++state)
            for (const std::size_t alarms : {0U, 12U}) {
                Snapshot snapshot;
                snapshot.state = static_cast<RunState>(state);
                snapshot.canRetreat = state % 2 == 0;
                snapshot.runTime_s = 3600.0 * state;
                snapshot.reasons.assign(static_cast<std::size_t>(state % 3),
                                        {MessageCode::ReasonNoExperiment, {}});
                snapshot.alarms.assign(alarms, longAlarm());
                snapshot.faults.assign(alarms > 0 ? 3 : 0, {SimulatedFault::SensorsSwapped, 0});
                bar.tell(snapshot);
                for (const char* name : kVerbButtons) {
                    const QAbstractButton* button = bar.button(name);
                    ASSERT_TRUE(button->isVisible()) << name;
                    const auto [place, isNew] = places.emplace(name, button->geometry());
                    EXPECT_EQ(place->second, button->geometry())
                        << name << " in " << runStateName(snapshot.state) << ", " << width << " px, "
                        << alarms << " alarms";
                }
            }
    }
}

// Catches: verbs that are icons alone where there is room for their words, or that are cut off; icons that do
// not say which verb they are.
TEST(StateBar, VerbsAreWordsInEveryLanguageWhereTheyHaveRoom) {
    initResources();
    Language language;
    for (const QString& code : Language::codes())
        for (const int width : {640, 853, 933, 1280, 1440, 1920}) { // 933 is 1400 at 150 %
            language.set(code);
            Bar bar(width);
            Snapshot snapshot;
            snapshot.labels = {"Aleksandra Huang-Baumgartner", "ring 17, painted black", "batch 2026-11"};
            snapshot.alarms.assign(12, longAlarm());
            bar.tell(snapshot);
            for (const char* name : kVerbButtons) {
                const auto* button = qobject_cast<QToolButton*>(bar.button(name));
                const auto where = testing::Message()
                                   << name << ", " << code.toStdString() << ", " << width << " px";
                EXPECT_GE(button->width(), button->sizeHint().width()) << where;
                EXPECT_TRUE(bar.bar.rect().contains(button->geometry())) << where;
                EXPECT_TRUE(button->toolTip().startsWith(button->defaultAction()->iconText())) << where;
                if (width != 853 || code != QStringLiteral("fr")) { // at 640 they have a row of their own
                    EXPECT_NE(button->toolButtonStyle(), Qt::ToolButtonIconOnly) << where;
                }
            }
            const QAbstractButton* alarm = bar.button("alarmButton");
            EXPECT_TRUE(alarm->toolTip().contains(QStringLiteral("aluminium hand"))) << "its text may be cut";
        }
    language.set(QStringLiteral("en"));
}

// Catches: a fault that is simulated unseen, one that is told when it is over, and a word that is cut off.
TEST(StateBar, ASimulatedFaultIsToldInWords) {
    initResources();
    Bar bar(1280);
    Language language;
    auto* tag = bar.bar.findChild<QWidget*>(QStringLiteral("rigTag"));
    auto* word = bar.bar.findChild<QLabel*>(QStringLiteral("faultWord"));
    Snapshot snapshot;
    snapshot.objects = {"circle", "bunny"};
    for (const QString& code : Language::codes()) {
        language.set(code);
        bar.settle();
        snapshot.faults.clear();
        bar.tell(snapshot);
        EXPECT_FALSE(word->isVisible()) << code.toStdString();
        const QString before = tag->accessibleName();
        const int width = tag->width();
        snapshot.faults = {{SimulatedFault::SensorLost, 1}};
        bar.tell(snapshot);
        EXPECT_TRUE(word->isVisible()) << code.toStdString();
        EXPECT_GE(word->width(), word->sizeHint().width()) << code.toStdString();
        EXPECT_GE(word->text().size(), 4) << word->text().toStdString() << ' ' << code.toStdString();
        EXPECT_EQ(tag->width(), width) << code.toStdString();
        EXPECT_TRUE(tag->toolTip().contains(QStringLiteral("bunny"))) << code.toStdString();
        EXPECT_TRUE(tag->accessibleName().startsWith(before + QStringLiteral(", ")));
    }
    language.set(QStringLiteral("en"));
    bar.settle();
    bar.tell(snapshot);
    EXPECT_TRUE(word->text().startsWith(QStringLiteral("Sensor lost"))) << word->text().toStdString();
    EXPECT_TRUE(tag->toolTip().contains(QStringLiteral("Sensor lost: bunny")))
        << tag->toolTip().toStdString();
    bar.bar.resize(640, bar.bar.height()); // the words are with the tag's own
    bar.settle();
    EXPECT_TRUE(tag->accessibleName().contains(QStringLiteral("Sensor lost: bunny")));
}

// Catches: a bar whose room does not hold it, which pushes STOP out of the window, and SIMULATED, LIVE or a
// state that is no word in a small window. 512 is 1024 at 200 %.
TEST(StateBar, TagStateAndStopAreWordsAtEverySize) {
    initResources();
    Language language;
    for (const QString& code : Language::codes())
        for (const int width : {480, 512, 540, 600, 640, 683, 853, 933, 960, 1024, 1280, 1400, 1920}) {
            language.set(code);
            Bar bar(width);
            for (int state = 0; state <= static_cast<int>(RunState::Fault); ++state)
                for (const bool isSimulated : {true, false}) {
                    Snapshot snapshot;
                    snapshot.simulated = isSimulated;
                    snapshot.state = static_cast<RunState>(state);
                    snapshot.runTime_s = 36000.0;
                    snapshot.labels = {"Aleksandra Huang-Baumgartner", "ring 17, painted black", "batch"};
                    snapshot.alarms.assign(12, longAlarm());
                    bar.tell(snapshot);
                    const auto where = testing::Message() << code.toStdString() << ", " << width << " px, "
                                                          << runStateName(snapshot.state) << isSimulated;
                    ASSERT_EQ(bar.bar.width(), width) << where;
                    const auto* tag = bar.bar.findChild<QWidget*>(QStringLiteral("rigTag"));
                    const auto* word = tag->findChild<QLabel*>(QStringLiteral("tagWord"));
                    EXPECT_TRUE(word->isVisible()) << where;
                    EXPECT_GE(word->width(), word->sizeHint().width()) << where;
                    EXPECT_FALSE(word->text().isEmpty()) << where;
                    EXPECT_TRUE(bar.bar.rect().contains(tag->geometry())) << where;
                    const QAbstractButton* chip = bar.button("runStateChip");
                    EXPECT_GE(chip->width(), chip->sizeHint().width()) << where;
                    const QAbstractButton* stop = bar.button("stopButton");
                    EXPECT_TRUE(bar.bar.rect().contains(stop->geometry())) << where;
                    EXPECT_GE(stop->width(), stop->sizeHint().width()) << where;
                    EXPECT_LT(chip->geometry().right(), stop->geometry().left()) << where;
                    for (const char* name : {"armButton", "resetButton", "alarmButton"}) {
                        EXPECT_TRUE(bar.bar.rect().contains(bar.button(name)->geometry())) << where << name;
                        EXPECT_FALSE(stop->geometry().intersects(bar.button(name)->geometry())) << where;
                    }
                }
        }
    language.set(QStringLiteral("en"));
}

// Catches: a clock that runs on under "Ready" without a word, in any language.
TEST(StateBar, TheClockSaysThatItGoesOnUntilAllIsCold) {
    initResources();
    Bar bar(1280);
    Language language;
    const auto* word = bar.bar.findChild<QLabel*>(QStringLiteral("untilCold"));
    const auto* clock = bar.bar.findChild<QLabel*>(QStringLiteral("runClock"));
    const auto* who = bar.bar.findChild<QWidget*>(QStringLiteral("operatorButton"));
    Snapshot snapshot;
    snapshot.state = RunState::Ready;
    snapshot.labels.operatorName = "A. Hu";
    snapshot.source_K = snapshot.latest.source_K = kelvinFromCelsius(146.0);
    for (const QString& code : Language::codes()) {
        language.set(code);
        bar.settle();
        snapshot.isRecordedUntilCold = false;
        bar.tell(snapshot);
        EXPECT_FALSE(word->isVisible());
        EXPECT_TRUE(who->isVisible());
        snapshot.isRecordedUntilCold = true;
        bar.tell(snapshot);
        EXPECT_TRUE(word->isVisible());
        EXPECT_FALSE(who->isVisible());
        EXPECT_GE(word->width(), word->fontMetrics().horizontalAdvance(word->text())) << code.toStdString();
        EXPECT_TRUE(clock->toolTip().contains(QStringLiteral("146"))) << code.toStdString();
    }
    language.set(QStringLiteral("en"));
}

// Catches: a greyed button that does nothing and says nothing.
TEST(StateBar, AClickOnAVerbThatCannotActIsHeard) {
    Bar bar(1280);
    Snapshot snapshot;
    snapshot.state = RunState::Ready;
    bar.tell(snapshot);
    QList<Verb> refused;
    QObject::connect(&bar.bar, &StateBar::verbRefused, &bar.bar, [&](Verb verb) { refused << verb; });
    QSignalSpy triggered(&bar.actions, &Actions::verbTriggered);
    QTest::mouseClick(bar.button("startButton"), Qt::LeftButton);
    QTest::mouseClick(bar.button("resetButton"), Qt::LeftButton);
    EXPECT_EQ(refused, (QList<Verb>{Verb::Start, Verb::Reset}));
    EXPECT_EQ(triggered.count(), 0);
    QTest::mouseClick(bar.button("armButton"), Qt::LeftButton);
    EXPECT_EQ(triggered.count(), 1);
    EXPECT_EQ(refused.size(), 2);
}

} // namespace bask::test
