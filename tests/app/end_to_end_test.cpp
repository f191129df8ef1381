// The main job as a person does it: arm, start, watch three traces settle, note, stop, save, close, open
// again.

#include "tests/app/window_fixture.h"
#include "widgets/common/event_list.h"
#include "widgets/plots/trace_plot.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLineEdit>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

namespace bask::test {
namespace {

class EndToEndTest : public WindowTest {
protected:
    void armAndStart() {
        click("armButton");
        ASSERT_TRUE(waitForState(RunState::Armed));
        click("startButton");
        ASSERT_TRUE(waitFor([this] { return !samples.empty(); }));
    }

    /// Every object within the band on the plant's own temperature, not on what a display says.
    bool allTrulySettled() const {
        if (samples.empty())
            return false;
        for (const ObjectSample& object : samples.back().objects)
            if (!(std::abs(object.true_K - object.target_K) <= kSettledBand_K))
                return false;
        return true;
    }

    void addNote(const char* text) {
        window->pages().show(Page::Run);
        auto* plot = find<QWidget>("plot.measured_K");
        plot->setFocus();
        QTest::keyClick(plot, Qt::Key_N);
        auto* edit = find<QLineEdit>("noteEdit");
        ASSERT_TRUE(edit->hasFocus());
        QTest::keyClicks(edit, QLatin1String(text));
        QTest::keyClick(edit, Qt::Key_Return);
        auto* list = window->findChild<EventList*>(QStringLiteral("eventList"));
        ASSERT_NE(list, nullptr);
        ASSERT_TRUE(waitFor(
            [&] { return list->count() > 0 && list->textAt(list->count() - 1) == QLatin1String(text); }));
    }
};

void expectSame(const std::vector<TraceSample>& shown, const std::vector<TraceSample>& read) {
    ASSERT_EQ(shown.size(), read.size());
    for (std::size_t k = 0; k < shown.size(); ++k) {
        EXPECT_EQ(shown[k].time_s, read[k].time_s);
        ASSERT_EQ(shown[k].objects.size(), read[k].objects.size());
        for (std::size_t i = 0; i < shown[k].objects.size(); ++i) {
            EXPECT_EQ(shown[k].objects[i].measured_K, read[k].objects[i].measured_K);
            EXPECT_EQ(shown[k].objects[i].target_K, read[k].objects[i].target_K);
        }
    }
}

// Catches: a verb that does not reach the engine, a trace that is not drawn or not recorded, a session that
// reads back as another run.
TEST_F(EndToEndTest, ARunSettlesIsSavedAndIsTheSameWhenOpenedAgain) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_NO_FATAL_FAILURE(armAndStart());
    keepPicture(QStringLiteral("running-run"));
    ASSERT_TRUE(waitForState(RunState::Settled));
    EXPECT_TRUE(waitFor([this] { return allTrulySettled(); }));
    EXPECT_LT(samples.back().time_s, 240.0);
    addNote("hand touched the plate's rim");
    keepPictures(QStringLiteral("settled-light"));

    click("stopRunButton");
    ASSERT_TRUE(waitForState(RunState::Stopped));
    EXPECT_FALSE(window->lastSnapshot().heatOn);
    auto* live = find<TracePlot>("plot.measured_K");
    ASSERT_EQ(live->seriesCount(), 3);
    const QList<QPointF> liveCurve = live->seriesPoints(2);
    EXPECT_EQ(static_cast<std::size_t>(liveCurve.size()), samples.size());

    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("evening"));
    window->files().setFileChooser([&](const FileQuestion&) { return path; });
    bool saved = false;
    QObject::connect(&window->files(), &SessionActions::exported, window.get(), [&] { saved = true; });
    QTest::keyClick(window.get(), Qt::Key_E, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return saved; }));
    const std::vector<TraceSample> first = samples;
    closeWindow();

    openWindow();
    window->files().setFileChooser([&](const FileQuestion&) { return path + QStringLiteral(".bask"); });
    std::shared_ptr<RecordedSession> session;
    QObject::connect(&window->files(), &SessionActions::sessionOpened, window.get(),
                     [&](const std::shared_ptr<RecordedSession>& opened) { session = opened; });
    QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return session != nullptr; }));
    EXPECT_EQ(window->pages().page(), Page::Review);
    expectSame(first, session->samples(0.0, session->lastTime_s()).value());
    const SessionRecord* const record = &session->facts();
    ASSERT_EQ(record->notes.size(), 1U);
    EXPECT_EQ(record->notes[0].text, "hand touched the plate's rim");
    EXPECT_EQ(record->outcome, "settled");

    // And what a person sees of it.
    auto* again = find<TracePlot>("review.measured_K");
    const QList<QPointF> curve = again->seriesPoints(2);
    ASSERT_EQ(curve.size(), liveCurve.size());
    for (qsizetype k = 0; k < curve.size(); ++k)
        EXPECT_TRUE(curve[k] == liveCurve[k] || (std::isnan(curve[k].y()) && std::isnan(liveCurve[k].y())))
            << k;
    // The rates come from a job; they become start values of the experiment, which is the one of the run.
    auto* use = find<QAbstractButton>("useIdentified");
    ASSERT_TRUE(waitFor([&] { return use->isEnabled(); }));
    find<QComboBox>("reviewDetails")->setCurrentIndex(3);
    QTest::mouseClick(use, Qt::LeftButton);
    EXPECT_TRUE(std::ranges::any_of(window->document().experiment().objects, [](const ObjectSpec& object) {
        return object.estimatedRates.has_value();
    }));
    keepPicture(QStringLiteral("opened-review"));
    window->setTheme(Theme::Dark);
    keepPictures(QStringLiteral("opened-dark"));
    window->setLanguage(QStringLiteral("fr"));
    window->setTheme(Theme::Light);
    keepPictures(QStringLiteral("opened-french"));
    window->resize(1600, 1000);
    keepPictures(QStringLiteral("wide-french"));
    window->setLanguage(QStringLiteral("en"));
    keepPictures(QStringLiteral("wide-light"));
}

// Catches: a lost sensor that does not hold the run, a Resume that is offered too early or does nothing, a
// STOP that waits for something.
TEST_F(EndToEndTest, ALostSensorHoldsTheRunAndStopLatches) {
    openWindow();
    ASSERT_NO_FATAL_FAILURE(goFast());
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_NO_FATAL_FAILURE(armAndStart());
    window->engine().send(SimulateFault{SimulatedFault::SensorLost, 1});
    ASSERT_TRUE(waitForState(RunState::Holding));
    EXPECT_FALSE(window->lastSnapshot().reasons.empty());
    keepPicture(QStringLiteral("sensor-lost-run"));
    window->setTheme(Theme::Dark);
    keepPicture(QStringLiteral("sensor-lost-dark-run"));

    QTest::keyClick(window.get(), Qt::Key_F12);
    ASSERT_TRUE(waitForState(RunState::Fault));
    EXPECT_FALSE(window->lastSnapshot().heatOn);
    EXPECT_FALSE(find<QAbstractButton>("startButton")->isEnabled());
    window->engine().send(SimulateFault{SimulatedFault::None, 0});
    click("resetButton");
    EXPECT_TRUE(waitFor([this] { return state() == RunState::NotReady || state() == RunState::Ready; }));
    EXPECT_FALSE(window->lastSnapshot().heatOn);
}

} // namespace
} // namespace bask::test
