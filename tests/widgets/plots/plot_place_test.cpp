// A plot that is taken out of its page into a window of its own.

#include "widgets/plots/plot_place.h"

#include "tests/support/wait_for.h"
#include "widgets/plots/plot_window.h"
#include "widgets/plots/trace_plot.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>

#include <gtest/gtest.h>

#include <cmath>

using namespace bask;

namespace {

constexpr int kWindow_ms = 120'000; // on a loaded machine

std::vector<TraceSample> rising(int first, int last) {
    std::vector<TraceSample> out;
    for (int k = first; k <= last; ++k) {
        TraceSample sample;
        sample.time_s = k;
        for (int i = 0; i < 2; ++i) {
            ObjectSample object;
            object.target_K = 313.15;
            object.measured_K = 293.15 + k + i;
            object.valid = true;
            sample.objects.push_back(object);
        }
        out.push_back(sample);
    }
    return out;
}

struct ShownPage {
    QWidget page;
    PlotPlace* temperature = add(Quantity::Temperature, "plot.measured_K");
    PlotPlace* error = add(Quantity::Error, "plot.error_K");

    ShownPage() {
        page.resize(700, 500);
        page.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&page, kWindow_ms));
    }
    PlotPlace* add(Quantity quantity, const char* name) {
        if (page.layout() == nullptr)
            new QVBoxLayout(&page);
        auto* plot = new TracePlot(quantity);
        plot->setObjectName(QLatin1String(name));
        plot->setObjects({QStringLiteral("circle"), QStringLiteral("bunny")});
        plot->append(rising(1, 20));
        auto* place = new PlotPlace(plot, &page);
        page.layout()->addWidget(place);
        return place;
    }
};

QWidget* canvasIn(PlotPlace* place) {
    return place->plot()->findChild<QWidget*>(QStringLiteral("tracePlotCanvas"));
}

QMenu* openMenuOf(PlotPlace* place) {
    QWidget* canvas = canvasIn(place);
    QContextMenuEvent event(QContextMenuEvent::Mouse, canvas->rect().center(),
                            canvas->mapToGlobal(canvas->rect().center()));
    QCoreApplication::sendEvent(canvas, &event);
    return place->plot()->findChild<QMenu*>(QStringLiteral("plotMenu"));
}

void choose(PlotPlace* place, const char* action) {
    QMenu* menu = openMenuOf(place);
    ASSERT_NE(menu, nullptr);
    for (QAction* each : menu->actions() +
                             menu->findChild<QMenu*>(QStringLiteral("plotRightMenu"))->actions() +
                             menu->findChild<QMenu*>(QStringLiteral("plotExportMenu"))->actions())
        if (each->objectName() == QLatin1String(action))
            each->trigger();
    menu->close();
    QCoreApplication::sendPostedEvents(menu, QEvent::DeferredDelete);
}

} // namespace

// Catches a plot that is lost with its window, that stands still in it, or is another one there.
TEST(PlotPlace, ThePlotGoesOutGoesOnAndComesBack) {
    ShownPage shown;
    TracePlot* plot = shown.temperature->plot();
    plot->setTimeRange(5.0, 15.0);
    choose(shown.temperature, "plotOwnWindow");
    ASSERT_TRUE(shown.temperature->isOut());
    QWidget* window = plot->window();
    ASSERT_NE(qobject_cast<PlotWindow*>(window), nullptr);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window, kWindow_ms));
    EXPECT_EQ(window->parentWidget(), nullptr) << "it would stay above the main window";
    EXPECT_TRUE(plot->isVisible());
    EXPECT_TRUE(shown.temperature->findChild<QPushButton*>(QStringLiteral("plotPutBack"))->isVisible());
    EXPECT_DOUBLE_EQ(plot->visibleFrom_s(), 5.0);
    plot->append(rising(21, 30));
    shown.page.hide(); // another page is looked at
    shown.page.show();

    EXPECT_TRUE(window->close());
    EXPECT_FALSE(shown.temperature->isOut());
    EXPECT_EQ(plot->window(), &shown.page);
    EXPECT_TRUE(plot->isVisible());
    EXPECT_FALSE(shown.temperature->findChild<QPushButton*>(QStringLiteral("plotPutBack"))->isVisible());
    EXPECT_EQ(plot->seriesPoints(0).size(), 30);
    EXPECT_DOUBLE_EQ(plot->visibleTo_s(), 15.0);
}

// Catches a window that can be opened once, and one that takes the other's plot.
TEST(PlotPlace, SeveralAtOnceAndAgain) {
    ShownPage shown;
    qRegisterMetaType<PlotWindow*>();
    QSignalSpy made(shown.error, &PlotPlace::takenOut);
    for (int round = 1; round <= 2; ++round) {
        shown.temperature->takeOut();
        shown.error->takeOut();
        shown.error->takeOut();
        EXPECT_EQ(made.count(), round) << "out already";
        EXPECT_NE(shown.temperature->plot()->window(), shown.error->plot()->window());
        QTest::mouseClick(shown.error->findChild<QPushButton*>(QStringLiteral("plotPutBack")),
                          Qt::LeftButton);
        EXPECT_FALSE(shown.error->isOut());
        EXPECT_TRUE(shown.temperature->isOut());
        EXPECT_TRUE(shown.error->plot()->isVisible());
        shown.temperature->putBack();
        EXPECT_FALSE(shown.temperature->isOut());
    }
}

// Catches a key that works in one of the windows only, and a plot that Tab finds elsewhere afterwards.
TEST(PlotPlace, KeysTakeOutPutBackAndFillTheScreen) {
    ShownPage shown;
    TracePlot* plot = shown.temperature->plot();
    shown.page.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&shown.page, kWindow_ms));
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_W);
    ASSERT_TRUE(shown.temperature->isOut());
    QWidget* window = plot->window();
    ASSERT_TRUE(QTest::qWaitForWindowActive(window, kWindow_ms));
    EXPECT_TRUE(plot->hasFocus());
    auto* title = window->findChild<QLabel*>(QStringLiteral("plotWindowTitle"));
    EXPECT_FALSE(title->isVisible()) << "the frame has it";
    QTest::keyClick(plot, Qt::Key_F11);
    EXPECT_TRUE(window->isFullScreen());
    EXPECT_TRUE(title->isVisible());
    EXPECT_EQ(title->text(), window->windowTitle());
    QTest::keyClick(plot, Qt::Key_Escape);
    EXPECT_FALSE(window->isFullScreen());
    QTest::keyClick(plot, Qt::Key_W);
    EXPECT_FALSE(shown.temperature->isOut());
    EXPECT_EQ(shown.page.focusWidget(), plot) << "the keys are nobody's";
    EXPECT_EQ(plot->nextInFocusChain()->window(), &shown.page);
    EXPECT_EQ(shown.temperature->findChild<QPushButton*>(QStringLiteral("plotPutBack"))->nextInFocusChain(),
              plot);
}

// Catches a window that Escape does not close, and one that is closed where Escape was to end a cursor.
TEST(PlotPlace, EscapeClosesTheWindow) {
    ShownPage shown;
    TracePlot* plot = shown.temperature->plot();
    shown.temperature->takeOut();
    plot->measureFrom();
    ASSERT_TRUE(plot->cursor_s());
    QTest::keyClick(plot, Qt::Key_Escape);
    EXPECT_FALSE(plot->cursor_s());
    EXPECT_TRUE(shown.temperature->isOut());
    QTest::keyClick(plot, Qt::Key_Escape);
    EXPECT_FALSE(shown.temperature->isOut());
    EXPECT_EQ(plot->window(), &shown.page);
}

// Catches a key that is held and takes the plot out and back and out.
TEST(PlotPlace, AHeldKeyTakesOutOnce) {
    ShownPage shown;
    EXPECT_FALSE(shown.temperature->findChild<QAction*>(QStringLiteral("plotOwnWindow"))->autoRepeat());
}

// Catches a plot that takes the keys from a field when its window is closed from elsewhere.
TEST(PlotPlace, AWindowInTheBackgroundTakesNoKeys) {
    ShownPage shown;
    auto* field = new QLineEdit(&shown.page);
    shown.page.layout()->addWidget(field);
    shown.temperature->takeOut();
    ASSERT_TRUE(QTest::qWaitForWindowActive(shown.temperature->plot()->window(), kWindow_ms));
    shown.page.activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(&shown.page, kWindow_ms));
    field->setFocus();
    shown.temperature->putBack();
    EXPECT_EQ(shown.page.focusWidget(), field);
}

// Catches a title that keeps the run or the state of before.
TEST(PlotPlace, TheTitleNamesStateQuantityAndRun) {
    ShownPage shown;
    shown.error->setRun(QStringLiteral("run of three objects"));
    shown.error->setState(QStringLiteral("Rig SIMULATED: Ready"));
    shown.error->takeOut();
    const QWidget* window = shown.error->plot()->window();
    EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("Rig SIMULATED: Ready \u2014 Error")))
        << window->windowTitle().toStdString();
    EXPECT_TRUE(window->windowTitle().endsWith(QStringLiteral("run of three objects")));
    shown.error->setState(QStringLiteral("Rig LIVE: Running"));
    EXPECT_TRUE(window->windowTitle().startsWith(QStringLiteral("Rig LIVE: Running")));
    shown.error->setRun(QStringLiteral("recorded run evening"));
    EXPECT_TRUE(window->windowTitle().endsWith(QStringLiteral("recorded run evening")));
}

// Catches a menu that does not say what is shown, and a title that keeps the second quantity to itself.
TEST(PlotPlace, TheMenuChoosesASecondQuantity) {
    ShownPage shown;
    shown.error->takeOut();
    choose(shown.error, "plotRight.view_factor");
    EXPECT_EQ(shown.error->plot()->rightQuantity(), Quantity::ViewFactor);
    EXPECT_TRUE(shown.error->plot()->window()->windowTitle().contains(QStringLiteral(", View factors")));
    QMenu* menu = openMenuOf(shown.error);
    ASSERT_NE(menu, nullptr);
    int checked = 0;
    for (const QAction* each : menu->findChild<QMenu*>(QStringLiteral("plotRightMenu"))->actions()) {
        checked += each->isChecked() ? 1 : 0;
        EXPECT_EQ(each->isChecked(), each->objectName() == QStringLiteral("plotRight.view_factor"));
        EXPECT_NE(each->objectName(), QStringLiteral("plotRight.error_K")) << "it is on the left";
    }
    EXPECT_EQ(checked, 1);
    menu->close();
    QCoreApplication::sendPostedEvents(menu, QEvent::DeferredDelete);
    choose(shown.error, "plotRight.none");
    EXPECT_FALSE(shown.error->plot()->rightQuantity());
}

// Catches a form that cannot be asked for, and an export of nothing.
TEST(PlotPlace, TheMenuExportsWhatIsShown) {
    ShownPage shown;
    std::vector<PlotForm> asked;
    QObject::connect(shown.error, &PlotPlace::exportRequested, [&](PlotForm form) { asked.push_back(form); });
    for (const char* form : {"plotExport.pdf", "plotExport.svg", "plotExport.png", "plotExport.csv"})
        choose(shown.error, form);
    EXPECT_EQ(asked, (std::vector{PlotForm::Pdf, PlotForm::Svg, PlotForm::Png, PlotForm::Csv}));
    shown.error->setState(QStringLiteral("Rig LIVE: Stopped"));
    shown.error->setRun(QStringLiteral("present run"));
    EXPECT_EQ(shown.error->words(), QStringLiteral("Rig LIVE: Stopped, present run"));
    shown.error->plot()->clear();
    QMenu* menu = openMenuOf(shown.error);
    ASSERT_NE(menu, nullptr);
    EXPECT_FALSE(menu->findChild<QMenu*>(QStringLiteral("plotExportMenu"))->isEnabled());
    menu->close();
}

// Catches cursors that a plot in its own window does not take, and a menu that cannot take them away.
TEST(PlotPlace, CursorsWorkInTheWindow) {
    ShownPage shown;
    TracePlot* plot = shown.temperature->plot();
    shown.temperature->takeOut();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(plot->window(), kWindow_ms));
    plot->setTimeRange(0.0, 20.0);
    plot->redraw();
    QWidget* canvas = canvasIn(shown.temperature);
    const QPoint there = canvas->rect().center();
    QTest::mouseClick(canvas, Qt::LeftButton, Qt::NoModifier, there);
    ASSERT_TRUE(plot->cursor_s());
    EXPECT_EQ(*plot->cursor_s(), std::round(*plot->cursor_s())) << "at a sample";
    const QPointF aside = there + QPoint(canvas->width() / 4, 0);
    QMouseEvent move(QEvent::MouseMove, aside, canvas->mapToGlobal(aside), Qt::NoButton, Qt::NoButton,
                     Qt::NoModifier); // the cursor itself would be over the page's window
    QCoreApplication::sendEvent(canvas, &move);
    auto* told = canvas->findChild<QLabel*>(QStringLiteral("tracePlotReadout"));
    EXPECT_TRUE(told->text().contains(QStringLiteral("\u0394"))) << told->text().toStdString();

    const std::optional<double> middle_s = plot->cursor_s();
    choose(shown.temperature, "plotCursorAway");
    EXPECT_FALSE(plot->cursor_s());
    choose(shown.temperature, "plotMeasure"); // where the menu was opened
    EXPECT_EQ(plot->cursor_s(), middle_s);
    plot->takeCursorAway();
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(canvas, &leave);
    plot->setPosition(7.4);
    plot->window()->activateWindow();
    ASSERT_TRUE(QTest::qWaitForWindowActive(plot->window(), kWindow_ms));
    plot->setFocus();
    QTest::keyClick(plot, Qt::Key_M);
    EXPECT_EQ(plot->cursor_s(), std::optional(7.0)) << "at the moment of the replay";
    plot->takeCursorAway();
    QMenu* menu = openMenuOf(shown.temperature);
    ASSERT_NE(menu, nullptr);
    for (const QAction* action : menu->actions())
        EXPECT_EQ(action->isEnabled(), action->objectName() != QStringLiteral("plotCursorAway"));
    menu->close();
}
