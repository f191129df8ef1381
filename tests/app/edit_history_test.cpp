#include "app/edit_history.h"

#include <gtest/gtest.h>

namespace bask::test {
namespace {

using namespace std::chrono_literals;

struct EditHistoryTest : testing::Test {
    EditHistory history;
    EditHistory::Time now;
    std::shared_ptr<const Experiment> state = std::make_shared<Experiment>();

    /// An edit of that kind a while after the one before, which gives the experiment this title.
    void edit(EditKind kind, const std::string& title, std::chrono::milliseconds after = 100ms) {
        now += after;
        auto next = std::make_shared<Experiment>(*state);
        next->title = title;
        EditStep step;
        step.edit.kind = kind;
        step.before = state;
        step.after = next;
        state = next;
        history.add(step, now);
    }
    void undo() {
        state = history.toUndo()->before;
        history.undo();
    }
    int steps() const {
        EditHistory copy = history;
        int count = 0;
        for (; copy.toUndo() != nullptr; ++count)
            copy.undo();
        return count;
    }
};

// Catches a drag that is many steps, one that is a step with what came before it, and edits lost in between.
TEST_F(EditHistoryTest, EditsOfOneThingShortlyAfterOneAnotherAreOneStep) {
    edit(EditKind::Workspace, "a");
    for (const char* title : {"b", "c", "d"})
        edit(EditKind::Mounting, title);
    ASSERT_EQ(steps(), 2);
    EXPECT_EQ(history.toUndo()->before->title, "a");
    EXPECT_EQ(history.toUndo()->after->title, "d");
    edit(EditKind::Mounting, "e", EditHistory::kSameStep);
    EXPECT_EQ(steps(), 3) << "a second later it is another one";
    undo();
    edit(EditKind::Mounting, "f");
    EXPECT_EQ(steps(), 3) << "nothing is added to what was undone";
    EXPECT_EQ(history.toRedo(), nullptr);
    edit(EditKind::ObjectAdded, "g");
    edit(EditKind::ObjectAdded, "h");
    EXPECT_EQ(steps(), 5) << "objects are added one by one";
}

// Catches a drag back to where it began that leaves a step which does nothing.
TEST_F(EditHistoryTest, ADragToWhereItBeganIsNoStep) {
    edit(EditKind::Mounting, "away");
    edit(EditKind::Mounting, "");
    EXPECT_EQ(history.toUndo(), nullptr);
    EXPECT_TRUE(history.isSaved());
    edit(EditKind::Mounting, "again");
    EXPECT_EQ(steps(), 1);
}

// Catches changes that count as saved, or what is saved as changed.
TEST_F(EditHistoryTest, KnowsWhichStateIsSaved) {
    EXPECT_TRUE(history.isSaved());
    edit(EditKind::Mounting, "a");
    EXPECT_FALSE(history.isSaved());
    history.setSaved();
    edit(EditKind::Mounting, "b");
    EXPECT_FALSE(history.isSaved()) << "merged with what is saved";
    undo();
    EXPECT_TRUE(history.isSaved());
    undo();
    EXPECT_FALSE(history.isSaved());
    history.redo();
    EXPECT_TRUE(history.isSaved());
    history.undo();
    edit(EditKind::Start, "c");
    EXPECT_FALSE(history.isSaved());
    undo();
    EXPECT_FALSE(history.isSaved()) << "the saved state is gone";
    history.clear(false);
    EXPECT_FALSE(history.isSaved());
    EXPECT_EQ(history.toUndo(), nullptr);
    history.clear(true);
    EXPECT_TRUE(history.isSaved());
}

// Catches memory that grows for as long as the program runs, and a saved state that is another after steps
// were dropped.
TEST_F(EditHistoryTest, TheOldestStepsAreDropped) {
    const int max = static_cast<int>(EditHistory::kMaxSteps);
    for (int i = 0; i < max + 10; ++i) {
        edit(EditKind::Start, std::to_string(i));
        if (i == 4 || i == 100)
            history.setSaved();
    }
    EXPECT_EQ(steps(), max);
    int saved = 0;
    for (; history.toUndo() != nullptr; undo())
        if (history.isSaved()) {
            ++saved;
            EXPECT_EQ(state->title, "100");
        }
    EXPECT_EQ(saved, 1);
    EXPECT_EQ(state->title, "9");
    for (int i = 0; i <= max; ++i)
        edit(EditKind::Start, "more" + std::to_string(i));
    EXPECT_FALSE(history.isSaved());
    while (history.toUndo() != nullptr) {
        undo();
        EXPECT_FALSE(history.isSaved());
    }
}

} // namespace
} // namespace bask::test
