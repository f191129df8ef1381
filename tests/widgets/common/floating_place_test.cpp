#include "widgets/common/floating_place.h"
#include "widgets/common/message_bar.h"

#include <QCoreApplication>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <gtest/gtest.h>

namespace bask {
namespace {

/// A page with a button in its middle.
class FloatingPlaceTest : public testing::Test {
protected:
    FloatingPlaceTest() {
        auto* layout = new QVBoxLayout(&page);
        layout->addWidget(button);
        new FloatingPlace(*bar, page);
        page.resize(600, 400);
        page.show();
        settle();
    }
    static void settle() { QCoreApplication::processEvents(); }
    static QString longSentence() { return QStringLiteral("The robot cannot be moved now. ").repeated(12); }

    QWidget page;
    QPushButton* button = new QPushButton(&page);
    MessageBar* bar = new MessageBar(&page);
};

} // namespace

// Catches: a message that moves the button under the pointer; one that is cut off or half out of the page.
TEST_F(FloatingPlaceTest, MovesNothingAndShowsAllItsWords) {
    const QRect before = button->geometry();
    bar->say(MessageBar::Kind::Problem, QStringLiteral("No."));
    settle();
    ASSERT_TRUE(bar->isVisible());
    EXPECT_EQ(button->geometry(), before);
    EXPECT_TRUE(page.rect().contains(bar->geometry()));
    EXPECT_GT(bar->geometry().top(), page.height() / 2);
    const int height = bar->height();
    bar->say(MessageBar::Kind::Problem, longSentence());
    settle();
    EXPECT_GT(bar->height(), height);
    EXPECT_GE(bar->height(), bar->heightForWidth(bar->width()));
    EXPECT_TRUE(page.rect().contains(bar->geometry()));
    bar->clear();
    settle();
    EXPECT_EQ(button->geometry(), before);
}

// Catches: a message that stays where the page's edge was.
TEST_F(FloatingPlaceTest, FollowsThePagesEdge) {
    bar->say(MessageBar::Kind::Note, longSentence());
    for (const QSize size : {QSize(900, 700), QSize(320, 300)}) {
        page.resize(size);
        settle();
        EXPECT_TRUE(page.rect().contains(bar->geometry())) << size.width();
        EXPECT_LT(page.rect().bottom() - bar->geometry().bottom(), 30) << size.width();
        EXPECT_GE(bar->height(), bar->heightForWidth(bar->width()));
    }
}

// Catches: a message that is higher than the page, and loses its beginning.
TEST_F(FloatingPlaceTest, BeginsInSight) {
    page.setMinimumSize(1, 1);
    button->setMinimumSize(1, 1);
    page.resize(320, 60);
    bar->say(MessageBar::Kind::Problem, longSentence());
    settle();
    ASSERT_GT(bar->height(), page.height());
    EXPECT_EQ(bar->geometry().top(), 0);
}

// Catches: a message over the upper edge, since a plot hides the rest of the page.
TEST_F(FloatingPlaceTest, LiesOverWhatHidesThePage) {
    QWidget plot(&page);
    plot.setAttribute(Qt::WA_OpaquePaintEvent);
    plot.setGeometry(0, 60, 600, 340);
    plot.show();
    bar->say(MessageBar::Kind::Note, QStringLiteral("Written."));
    settle();
    EXPECT_LT(page.rect().bottom() - bar->geometry().bottom(), 30);
}

// Catches: a message over the time axis of a plot or over a field at the page's foot, and one that leaves the
// page for their sake.
TEST_F(FloatingPlaceTest, LeavesFreeWhatHasToBeSeen) {
    QWidget plot(&page), field(&page);
    plot.setProperty(kKeptFree_px, 50);
    field.setProperty(kKeptFree_px, kWholeWidget_px);
    plot.setGeometry(0, 60, 600, 310);
    field.setGeometry(0, 370, 600, 30);
    plot.show();
    field.show();
    bar->say(MessageBar::Kind::Note, QStringLiteral("Open as a new one."));
    settle();
    EXPECT_EQ(bar->geometry().bottom(), 319) << "above the axis";
    field.hide();
    plot.setGeometry(0, 0, 600, 40); // elsewhere
    page.resize(600, 401);
    settle();
    EXPECT_LT(page.rect().bottom() - bar->geometry().bottom(), 30);
    plot.setProperty(kKeptFree_px, kWholeWidget_px);
    plot.setGeometry(0, 0, 600, 401);
    page.resize(600, 400);
    settle();
    EXPECT_TRUE(page.rect().contains(bar->geometry())) << "there is no room above it";
}

// Catches: a message over a button that was to be pressed, where there is another place for it.
TEST_F(FloatingPlaceTest, KeepsOffControls) {
    button->setFixedSize(200, 30);
    page.layout()->setAlignment(button, Qt::AlignHCenter | Qt::AlignBottom);
    settle();
    ASSERT_GT(button->geometry().bottom(), 360);
    bar->say(MessageBar::Kind::Note, QStringLiteral("Undone."));
    settle();
    EXPECT_LT(bar->geometry().bottom(), button->geometry().top());
    EXPECT_GT(bar->geometry().bottom(), button->geometry().top() - 10) << "no higher than it has to be";
}

// Catches: bars that lie over each other, and a button that falls under the pointer when a bar below it goes.
TEST(FloatingPlaces, BarsStandOverOneAnotherAndStay) {
    QWidget page;
    auto *first = new MessageBar(&page), *second = new MessageBar(&page), *third = new MessageBar(&page);
    new FloatingPlace({first, second, third}, page);
    page.resize(600, 400);
    page.show();
    QCoreApplication::processEvents();
    for (MessageBar* each : {second, first, third}) {
        each->say(MessageBar::Kind::Note, QStringLiteral("Something is so."), QStringLiteral("Open"));
        QCoreApplication::processEvents();
    }
    EXPECT_GT(second->geometry().top(), first->geometry().bottom());
    EXPECT_GT(first->geometry().top(), third->geometry().bottom());
    const QRect before = third->geometry();
    second->clear();
    QCoreApplication::processEvents();
    EXPECT_EQ(third->geometry(), before);
    second->say(MessageBar::Kind::Note, QStringLiteral("It is so again."));
    QCoreApplication::processEvents();
    EXPECT_FALSE(second->geometry().intersects(first->geometry()));
    EXPECT_EQ(third->geometry(), before);
    page.resize(600, 60); // no room for all: the first is in front
    QCoreApplication::processEvents();
    EXPECT_TRUE(first->isAncestorOf(page.childAt(first->geometry().center())) ||
                page.childAt(first->geometry().center()) == first);
}

// Catches: a message at the foot of a long page, below what is seen of it.
TEST(FloatingPlaceInAScrollArea, StaysInSight) {
    QScrollArea area;
    auto* page = new QWidget;
    auto* bar = new MessageBar(page);
    new FloatingPlace(*bar, *page);
    page->setFixedSize(500, 3000);
    area.setWidget(page);
    area.resize(520, 400);
    area.show();
    QCoreApplication::processEvents();
    bar->say(MessageBar::Kind::Note, QStringLiteral("Undone."));
    for (const int value : {0, 700, 2000}) {
        area.verticalScrollBar()->setValue(value);
        QCoreApplication::processEvents();
        EXPECT_GE(bar->geometry().top(), value);
        EXPECT_LE(bar->geometry().bottom(), value + area.viewport()->height());
    }
}

} // namespace bask
