// Plots in windows of their own beside the main window: STOP, titles, their coming and going.

#include "app/state_bar.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/plots/plot_place.h"
#include "widgets/plots/plot_window.h"
#include "widgets/plots/trace_plot.h"

#include <QApplication>
#include <QFileInfo>
#include <QSignalSpy>

namespace bask::test {
namespace {

constexpr int kOutWindow_ms = 120'000; // on a loaded machine

class PlotWindowsTest : public WindowTest {
protected:
    PlotPlace* place(const char* plot) {
        for (PlotPlace* each : window->findChildren<PlotPlace*>())
            if (each->plot()->objectName() == QLatin1String(plot))
                return each;
        return nullptr;
    }
    QWidget* takeOut(const char* plot) {
        place(plot)->takeOut();
        QWidget* out = place(plot)->plot()->window();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(out, kOutWindow_ms));
        return out;
    }
};

} // namespace

// Catches: a STOP that does not reach the engine from there, a title that says Ready while the rig has
// stopped, and a plot that does not go on.
TEST_F(PlotWindowsTest, ShowTheRunWithItsStateAndStopIt) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(startRun(6));
    QWidget* error = takeOut("plot.error_K");
    QWidget* temperature = takeOut("plot.measured_K");
    const auto points = [this] { return place("plot.measured_K")->plot()->seriesPoints(0).size(); };
    const auto before = points();
    EXPECT_TRUE(waitFor([&] { return points() > before; }));
    const QString words = QStringLiteral("Rig SIMULATED: %1");
    const QString now = words.arg(runStateWord(state()));
    EXPECT_TRUE(waitFor([&] { return error->windowTitle().startsWith(now); }))
        << error->windowTitle().toStdString();
    EXPECT_TRUE(
        temperature->windowTitle().endsWith(QString::fromStdString(window->document().experiment().title)));
    QSignalSpy stop(find<StateBar>("stateBar"), &StateBar::stopRequested);
    QTest::keyClick(temperature, Qt::Key_F12);
    EXPECT_EQ(stop.count(), 1);
    ASSERT_TRUE(waitForState(RunState::Fault));
    for (const QWidget* each : {error, temperature})
        EXPECT_TRUE(waitFor([&] {
            return each->windowTitle().startsWith(words.arg(runStateWord(RunState::Fault)));
        })) << each->windowTitle().toStdString();
    emit window->engine().answeringChanged(false);
    EXPECT_TRUE(temperature->windowTitle().contains(QStringLiteral("UNKNOWN")));
}

// Catches: a window that is left over when Bask is closed, a place that is forgotten, and one plot's place
// for all.
TEST_F(PlotWindowsTest, CloseWithTheMainWindowAndComeWhereTheyWere) {
    const QSize size(610, 430);
    ASSERT_NO_FATAL_FAILURE(openWindow());
    QWidget* out = takeOut("plot.measured_K");
    out->resize(size);
    takeOut("plot.error_K");
    EXPECT_TRUE(waitFor([out] { return out->windowTitle().contains(rigWord(true)); }));
    window->setLanguage(QStringLiteral("fr"));
    EXPECT_TRUE(waitFor([out] { return out->windowTitle().contains(rigWord(true)); }));
    EXPECT_FALSE(out->windowTitle().contains(QStringLiteral("SIMULATED")))
        << out->windowTitle().toStdString();
    window->setLanguage(QStringLiteral("en"));
    window->setCloseQuestion([] { return Closing::Now; });
    window->document().markSaved(window->document().path());
    ASSERT_TRUE(window->close());
    for (const PlotPlace* each : window->findChildren<PlotPlace*>()) {
        EXPECT_FALSE(each->isOut());
        EXPECT_EQ(each->plot()->window(), window.get());
    }
    window.reset();
    for (QWidget* top : QApplication::topLevelWidgets())
        EXPECT_FALSE(qobject_cast<PlotWindow*>(top) != nullptr && top->isVisible());

    ASSERT_NO_FATAL_FAILURE(openWindow());
    EXPECT_EQ(takeOut("plot.measured_K")->size(), size) << "at the next start";
    EXPECT_NE(takeOut("plot.error_K")->size(), size);
}

// Catches: a window that comes without a frame, since it filled the screen when it was closed.
TEST_F(PlotWindowsTest, FullScreenIsNotRemembered) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    QWidget* out = takeOut("plot.measured_K");
    out->resize(610, 430);
    QTest::keyClick(out, Qt::Key_F11);
    ASSERT_TRUE(out->isFullScreen());
    out->close();
    EXPECT_FALSE(takeOut("plot.measured_K")->isFullScreen());
}

// Catches: a plot of Review that stays empty in its window, or with the run that was opened before.
TEST_F(PlotWindowsTest, APlotOfReviewShowsTheOpenedRun) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(startRun(21));
    click("holdButton");
    ASSERT_TRUE(waitForState(RunState::Holding));
    QWidget* out = takeOut("review.error_K");
    EXPECT_TRUE(out->windowTitle().endsWith(QStringLiteral("no recorded run")));
    const QString path = QString::fromStdString(window->lastSnapshot().recordingPath);
    ASSERT_NO_FATAL_FAILURE(openRecording(path));
    const TracePlot* plot = place("review.error_K")->plot();
    EXPECT_GT(plot->seriesPoints(0).size(), 0);
    EXPECT_EQ(plot->seriesPoints(0).size(), place("review.measured_K")->plot()->seriesPoints(0).size());
    EXPECT_TRUE(
        out->windowTitle().endsWith(QStringLiteral("recorded run ") + QFileInfo(path).completeBaseName()))
        << out->windowTitle().toStdString();
    window->pages().show(Page::Run);
    EXPECT_TRUE(plot->isVisible());
}

} // namespace bask::test
