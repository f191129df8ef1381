#include "app/state_bar.h"

#include "engine/base/message_code.h"

#include <QAbstractButton>
#include <QMainWindow>
#include <QPixmap>
#include <QSignalSpy>
#include <QTest>

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

// Catches: Reset under the hand that was about to press Stop, and verbs pushed aside by an alarm.
TEST(StateBar, EveryVerbKeepsItsPlaceInEveryStateAndWithAlarms) {
    for (const int width : {640, 853, 1024, 1280, 1600}) {
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
