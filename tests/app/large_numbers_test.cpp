// View > Large numbers beside the main window: the same values and words, the same STOP, its coming and
// going.

#include "widgets/run/large_numbers.h"

#include "app/state_bar.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/display.h"
#include "widgets/common/object_tile.h"
#include "widgets/common/stop_button.h"
#include "widgets/run/large_text.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QSignalSpy>

namespace bask::test {
namespace {

class LargeNumbersWindowTest : public WindowTest {
protected:
    LargeNumbers* view() {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* found = qobject_cast<LargeNumbers*>(top))
                return found;
        return nullptr;
    }
    void openLarge() {
        find<QAction>("largeNumbers")->trigger();
        ASSERT_NE(view(), nullptr);
        ASSERT_TRUE(QTest::qWaitForWindowExposed(view()));
        ASSERT_TRUE(waitFor([this] { return text("largeTarget", "largeTile.2") != QString(); }));
    }
    QString text(const char* name, const char* tile = nullptr) {
        const QWidget* in = tile ? view()->findChild<QWidget*>(QLatin1String(tile)) : view();
        const auto* found = in ? in->findChild<LargeText*>(QLatin1String(name)) : nullptr;
        return found ? found->text() : QString();
    }
    /// Every object has the value, target, error and word of its tile on the Run page.
    void expectAsTheTiles() {
        for (int i = 0; i < 3; ++i) {
            const auto* tile = find<ObjectTile>(qPrintable(QStringLiteral("objectTile.%1").arg(i)));
            const auto shown = [&](const char* name) {
                return tile->findChild<QLabel*>(QLatin1String(name))->text();
            };
            const QByteArray large = QStringLiteral("largeTile.%1").arg(i).toLatin1();
            EXPECT_EQ(text("largeName", large), shown("tileName"));
            EXPECT_EQ(text("largeTemperature", large), shown("tileTemperature").section(u'\u00a0', 0, 0));
            EXPECT_EQ(text("largeTarget", large), shown("tileTarget"));
            EXPECT_EQ(text("largeError", large), shown("tileError"));
            EXPECT_TRUE(text("largeWord", large).startsWith(shown("tileState"))) << i;
        }
    }
    void keepLarge(const QString& name) {
        const QString folder = qEnvironmentVariable("BASK_SCREENSHOTS");
        if (folder.isEmpty())
            return;
        QDir().mkpath(folder);
        EXPECT_TRUE(view()->grab().save(QStringLiteral("%1/%2.png").arg(folder, name)));
    }
};

} // namespace

// Catches: another value or word than the tiles have, and a STOP that stops nothing.
TEST_F(LargeNumbersWindowTest, ShowsWhatTheTilesShowAndItsStopStopsTheRun) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(startRun(6));
    ASSERT_NO_FATAL_FAILURE(openLarge());
    for (const char* unit : {"celsius", "fahrenheit", "kelvin"}) {
        find<QAction>(unit)->trigger();
        const auto shownBefore = window->lastSnapshot().sequence;
        ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().sequence > shownBefore; }));
        expectAsTheTiles();
        keepLarge(QStringLiteral("large-numbers-%1").arg(QLatin1String(unit)));
    }
    EXPECT_EQ(text("largeState"), runStateWord(state()));
    EXPECT_EQ(text("largeRig"), QStringLiteral("SIMULATED"));
    EXPECT_TRUE(waitFor([this] { return text("largeHeat") == QStringLiteral("Heat on"); }));
    EXPECT_FALSE(view()->isModal());

    QTest::mousePress(view()->findChild<StopButton*>(QStringLiteral("largeStop")), Qt::LeftButton);
    ASSERT_TRUE(waitForState(RunState::Fault));
    EXPECT_TRUE(waitFor([this] { return !window->lastSnapshot().heatOn; }));
    EXPECT_TRUE(waitFor([this] { return text("largeState").startsWith(QStringLiteral("Fault")); }));
    keepLarge(QStringLiteral("large-numbers-stopped"));
}

// Catches: F12 that is sent twice, and a main window's STOP that a dialog covers because the other window's
// has its twin.
TEST_F(LargeNumbersWindowTest, BothWindowsKeepTheirStop) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_TRUE(waitForState(RunState::Ready));
    ASSERT_NO_FATAL_FAILURE(openLarge());
    QSignalSpy stop(find<StateBar>("stateBar"), &StateBar::stopRequested);
    QTest::keyClick(view(), Qt::Key_F12);
    EXPECT_EQ(stop.count(), 1);
    QTest::keyClick(window.get(), Qt::Key_F12);
    EXPECT_EQ(stop.count(), 2);

    QDialog dialog(window.get());
    dialog.setModal(true);
    dialog.show();
    const auto twins = [&] { return dialog.findChildren<StopButton*>(); };
    ASSERT_TRUE(waitFor([&] { return twins().size() == 2; }));
    for (int i = 0; i < 2; ++i)
        QTest::mousePress(twins()[i], Qt::LeftButton);
    EXPECT_EQ(stop.count(), 4);
    EXPECT_NE(twins()[0]->geometry(), twins()[1]->geometry());
    dialog.hide();
    EXPECT_TRUE(QTest::qWaitFor([&] { return twins().isEmpty(); }));
}

// Catches: figures of a lost sensor, or of an engine that is silent, which look alive on the second screen.
TEST_F(LargeNumbersWindowTest, WhatIsNotKnownIsNotShownAsKnown) {
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(startRun(6));
    ASSERT_NO_FATAL_FAILURE(openLarge());
    window->engine().send(SimulateFault{SimulatedFault::SensorOpen, 1});
    ASSERT_TRUE(waitFor([this] { return isUnknown(find<ObjectTile>("objectTile.1")->activity()); }));
    expectAsTheTiles();
    EXPECT_EQ(text("largeError", "largeTile.1"), QStringLiteral("\u2014"));
    const auto look = [this](const char* tile) {
        return view()
            ->findChild<QWidget*>(QLatin1String(tile))
            ->findChild<LargeText*>(QStringLiteral("largeTemperature"))
            ->look();
    };
    EXPECT_TRUE(look("largeTile.1").isGrey && look("largeTile.1").isUnknown);
    EXPECT_TRUE(waitFor([this] { return !text("largeAlarm").isEmpty(); }));
    keepLarge(QStringLiteral("large-numbers-sensor-open"));

    ASSERT_TRUE(window->engine().shutDown(std::chrono::seconds(3)));
    QCoreApplication::processEvents(); // what it had sent
    emit window->engine().answeringChanged(false);
    for (const char* tile : {"largeTile.0", "largeTile.1", "largeTile.2"}) {
        EXPECT_TRUE(look(tile).isGrey && look(tile).isUnknown) << tile;
        EXPECT_EQ(text("largeError", tile), QStringLiteral("\u2014")) << tile;
    }
    EXPECT_EQ(text("largeState"), QStringLiteral("UNKNOWN"));
    EXPECT_EQ(text("largeHeat"), QStringLiteral("Heat UNKNOWN"));
    EXPECT_TRUE(text("largeAlarm").startsWith(QStringLiteral("The engine is not answering")));
    keepLarge(QStringLiteral("large-numbers-silent"));
}

// Catches: a run that ends with this window, a place that is forgotten, and a window that is left over when
// Bask is closed.
TEST_F(LargeNumbersWindowTest, ComesAndGoesWithoutTouchingTheRun) {
    const QSize size(700, 500);
    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(startRun(6));
    ASSERT_NO_FATAL_FAILURE(openLarge());
    EXPECT_EQ(view()->parentWidget(), nullptr) << "it would stay above the main window";
    auto* const shown = find<QAction>("largeNumbers");
    EXPECT_TRUE(shown->isChecked());
    view()->showMinimized();
    ASSERT_TRUE(QTest::qWaitFor([this] { return view()->isMinimized(); }));
    shown->trigger();
    EXPECT_TRUE(view()->isVisible() && !view()->isMinimized()) << "it was open, and nobody saw it";
    EXPECT_TRUE(shown->isChecked());
    shown->trigger();
    EXPECT_FALSE(view()->isVisible()) << "the menu closes it, too";
    ASSERT_NO_FATAL_FAILURE(openLarge());
    view()->resize(size);
    EXPECT_TRUE(view()->close());
    EXPECT_FALSE(shown->isChecked());
    EXPECT_TRUE(window->isVisible());
    const double before_s = window->lastSnapshot().runTime_s;
    ASSERT_TRUE(waitFor([&] { return window->lastSnapshot().runTime_s > before_s + 2.0; }));
    EXPECT_TRUE(state() == RunState::Running || state() == RunState::Settled);

    ASSERT_NO_FATAL_FAILURE(openLarge());
    EXPECT_EQ(view()->size(), size);
    window->setLanguage(QStringLiteral("fr"));
    EXPECT_TRUE(waitFor([this] {
        return text("largeState") == QStringLiteral("En marche") ||
               text("largeState") == QString::fromUtf8("Stabilisé");
    })) << text("largeState").toStdString();
    keepLarge(QStringLiteral("large-numbers-fr"));
    window->setLanguage(QStringLiteral("en"));
    window->setCloseQuestion([] { return Closing::Now; });
    window->document().markSaved(window->document().path());
    ASSERT_TRUE(window->close());
    EXPECT_FALSE(view()->isVisible());
    window.reset();
    EXPECT_EQ(view(), nullptr);

    ASSERT_NO_FATAL_FAILURE(openWindow());
    ASSERT_NO_FATAL_FAILURE(openLarge());
    EXPECT_EQ(view()->size(), size) << "at the next start";
}

} // namespace bask::test
