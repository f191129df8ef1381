// What is told over the pages moves none of their parts, and hides nothing that is needed then.

#include "engine/base/message_code.h"
#include "tests/app/window_fixture.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/message_bar.h"

#include <QAbstractScrollArea>
#include <QPushButton>
#include <QScrollBar>
#include <QTest>

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace bask::test {
namespace {

class FloatingBarsTest : public WindowTest {
protected:
    struct Bar {
        const char* name;
        std::function<void()> show, hide;
    };

    std::vector<Bar> bars(const Snapshot& calm) {
        Snapshot pending = calm;
        pending.pending =
            PendingAction{{MessageCode::ActionEndRun, {}}, {MessageCode::ReasonSourcePoseLost, {}}, 9.0};
        PageHost& pages = window->pages();
        const auto said = [](const char* name, MessageBar& bar) {
            return Bar{name,
                       [&bar] {
                           bar.ask(QStringLiteral("Bask went down with unsaved edits to an experiment."),
                                   QStringLiteral("Restore the edits"), QStringLiteral("Discard"));
                       },
                       [&bar] { bar.clear(); }};
        };
        return {
            {"countdownBar", [&pages, pending] { pages.apply(pending); },
             [&pages, calm] { pages.apply(calm); }},
            said("cutOffBar", pages.cutOffBar()),
            said("recipeBar", pages.recipeBar()),
            said("questionBar", pages.questionBar()),
            said("coachBar", pages.coachBar()),
            {"messageBar",
             [&pages] { pages.showProblem(QStringLiteral("The folder cannot be written to. ").repeated(4)); },
             [&pages] { pages.messages().clear(); }}};
    }

    /// Places in the window of all that can be seen on the page.
    std::map<const QWidget*, QRect> places() {
        std::map<const QWidget*, QRect> found;
        for (const QWidget* each : window->pages().findChildren<QWidget*>())
            if (each->isVisible() && !isInBar(each))
                found[each] = inWindow(*each);
        return found;
    }
    QRect inWindow(const QWidget& part) const {
        return {part.mapTo(window.get(), QPoint(0, 0)), part.size()};
    }
    bool isInBar(const QWidget* part) const {
        for (; part != nullptr && part != window.get(); part = part->parentWidget())
            if (part->parentWidget() == &window->pages() && part->objectName().endsWith(QLatin1String("Bar")))
                return true;
        return false;
    }
};

// Catches: a page that moves down when a bar comes, so that the click is on something else.
TEST_F(FloatingBarsTest, NoBarMovesThePageOrHidesWhatIsNeeded) {
    openWindow();
    const Snapshot calm = freeze();
    for (int page = 0; page < kPages; ++page) {
        window->pages().show(static_cast<Page>(page));
        window->pages().apply(calm);
        waitForLayouts();
        for (const Bar& bar : bars(calm)) {
            const auto before = places();
            bar.show();
            waitForLayouts();
            const auto where = testing::Message() << bar.name << ", page " << page;
            const auto* shown = find<QWidget>(bar.name);
            ASSERT_TRUE(shown->isVisible()) << where;
            for (const auto& [part, place] : places())
                if (const auto old = before.find(part); old != before.end()) {
                    EXPECT_EQ(old->second, place) << where << ": " << part->objectName().toStdString();
                }
            const QRect over = inWindow(*shown);
            EXPECT_TRUE(inWindow(window->pages()).contains(over)) << where;
            EXPECT_FALSE(over.intersects(inWindow(*find<QWidget>("stopButton")))) << where;
            for (const auto& [part, place] : before) {
                const bool isKept = part->property(kKeptFree_px).toInt() >= kWholeWidget_px;
                const bool isPressed = qobject_cast<const QPushButton*>(part) != nullptr && part->isEnabled();
                if ((isKept || isPressed) && !part->visibleRegion().isEmpty()) {
                    EXPECT_FALSE(
                        over.intersects(part->visibleRegion().boundingRect().translated(place.topLeft())))
                        << where << " over " << part->metaObject()->className() << ' '
                        << part->objectName().toStdString();
                }
            }
            keepPicture(QStringLiteral("bar-%1-%2").arg(QLatin1String(bar.name)).arg(page));
            bar.hide();
            waitForLayouts();
            EXPECT_EQ(before, places()) << where;
        }
    }
}

// Catches: a page that jumps when its message goes, since the focus went from a button of it that was clicked
// to a part that was out of sight.
TEST_F(FloatingBarsTest, AClickedMessageThatGoesMovesNothing) {
    openWindow();
    window->resize(1024, 700);
    const Snapshot calm = freeze();
    for (int page = 0; page < kPages; ++page) {
        window->pages().show(static_cast<Page>(page));
        window->pages().apply(calm);
        waitForLayouts();
        for (auto* area : window->pages().findChildren<QAbstractScrollArea*>())
            if (area->isVisible())
                area->verticalScrollBar()->setValue(area->verticalScrollBar()->maximum());
        MessageBar bar(&window->pages());
        bar.say(MessageBar::Kind::Note, QStringLiteral("Saved."), QStringLiteral("Show in folder"));
        waitForLayouts();
        auto* action = bar.findChild<QPushButton*>();
        ASSERT_TRUE(action->isVisible());
        const auto before = places();
        QTest::mouseClick(action, Qt::LeftButton);
        bar.clear();
        waitForLayouts();
        for (const auto& [part, place] : places())
            if (const auto old = before.find(part); old != before.end()) {
                EXPECT_EQ(old->second, place) << "page " << page << ": " << part->objectName().toStdString();
            }
    }
}

} // namespace
} // namespace bask::test
