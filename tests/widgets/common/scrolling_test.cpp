#include "widgets/common/scrolling.h"

#include <QApplication>
#include <QListWidget>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace bask {
namespace {

using namespace std::chrono_literals;

/// What counts how often the wheel zooms it.
class ZoomedView : public QWidget {
public:
    ZoomedView() {
        setFocusPolicy(Qt::StrongFocus);
        setProperty(kZoomsByWheel, true);
        setMinimumHeight(200);
    }
    int zooms = 0;

protected:
    void wheelEvent(QWheelEvent* event) override {
        ++zooms;
        event->accept();
    }
};

/// A page with a list over a view.
struct ScrolledPage {
    QWidget window;
    QListWidget* list = new QListWidget;
    ZoomedView* view = new ZoomedView;
    QScrollArea* scroll = nullptr;

    ScrolledPage(std::chrono::milliseconds gesture, int height) {
        auto* content = new QWidget;
        auto* inside = new QVBoxLayout(content);
        list->setFixedHeight(100);
        for (int i = 0; i < 20; ++i)
            list->addItem(QString::number(i));
        inside->addWidget(list);
        inside->addWidget(view);
        scroll = scrolled(content);
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(scroll);
        new ScrollHabits(&window, gesture);
        window.resize(400, height);
        window.show();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
        list->setFocus();
    }
    int place() const { return scroll->verticalScrollBar()->value(); }
    /// As from a person: what does not take it lets what it lies in have it.
    static void turn(QWidget* over, int by, Qt::KeyboardModifiers with = {}) {
        const QPoint at = over->rect().center();
        QWheelEvent event(at, over->mapToGlobal(at), {}, {0, by}, Qt::NoButton, with, Qt::NoScrollPhase,
                          false);
        QSpontaneKeyEvent::setSpontaneous(&event);
        qApp->notify(over, &event);
    }
};

} // namespace

// Catches: a page that cannot be scrolled over a plot, and a plot that cannot be zoomed at all there.
TEST(ScrollHabits, OverAViewTheWheelScrollsThePage) {
    ScrolledPage page(0ms, 220);
    ASSERT_GT(page.scroll->verticalScrollBar()->maximum(), 0);
    page.turn(page.view, -120);
    EXPECT_GT(page.place(), 0);
    EXPECT_EQ(page.view->zooms, 0);
    page.scroll->verticalScrollBar()->setValue(page.scroll->verticalScrollBar()->maximum());
    page.turn(page.view, -120);
    EXPECT_EQ(page.view->zooms, 0) << "the page's end is no reason to zoom";

    const int here = page.place();
    page.turn(page.view, 120, Qt::ControlModifier);
    EXPECT_EQ(page.view->zooms, 1);
    EXPECT_EQ(page.place(), here);
    page.view->setFocus(Qt::MouseFocusReason);
    const int there = page.place(); // it came into view
    page.turn(page.view, 120);
    EXPECT_EQ(page.view->zooms, 2);
    EXPECT_EQ(page.place(), there);
}

// Catches: a picture that cannot be zoomed where there is room for all.
TEST(ScrollHabits, WhereNothingScrollsTheWheelZooms) {
    ScrolledPage page(1h, 600);
    ASSERT_EQ(page.scroll->verticalScrollBar()->maximum(), 0);
    page.turn(page.list->viewport(), -120); // scrolls the list, which is not around the view
    page.turn(page.view, -120);
    EXPECT_EQ(page.view->zooms, 1);
}

// Catches: a picture that shrinks to a dot when it comes under the pointer at the end of a list.
TEST(ScrollHabits, ATurnThatBeganInAListDoesNotZoom) {
    ScrolledPage page(1h, 220);
    page.view->setFocus(Qt::MouseFocusReason);
    page.turn(page.view, -120);
    EXPECT_EQ(page.view->zooms, 1);
    page.list->verticalScrollBar()->setValue(page.list->verticalScrollBar()->maximum());
    page.turn(page.list->viewport(), -120);
    const int here = page.place();
    EXPECT_GT(here, 0);
    page.turn(page.view, -120);
    EXPECT_EQ(page.view->zooms, 1);
    EXPECT_GE(page.place(), here);
    page.turn(page.view, -120, Qt::ControlModifier);
    EXPECT_EQ(page.view->zooms, 2) << "Ctrl is for nothing else";
}

} // namespace bask
