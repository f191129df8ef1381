// Work on a thread of its own: order, answers, the owner's end. For the thread sanitizer above all.

#include "engine/runtime/background_thread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace bask {

// Catches work that is lost, done twice or out of order, and its results unseen by who waited.
TEST(BackgroundThread, doesAllInTheOrderAskedFor) {
    std::vector<int> done;
    BackgroundThread thread;
    for (int i = 0; i < 1000; ++i)
        thread.post([&done, i] { done.push_back(i); });
    ASSERT_TRUE(thread.wait(std::chrono::seconds(60)));
    ASSERT_EQ(done.size(), 1000U);
    EXPECT_TRUE(std::ranges::is_sorted(done));
}

// Catches an answer that is said to be there too early.
TEST(BackgroundThread, answersWhenTheWorkIsDone) {
    BackgroundThread thread;
    std::promise<void> mayGo;
    auto answer = thread.ask([go = mayGo.get_future()] {
        go.wait();
        return std::vector<int>{1, 2, 3};
    });
    EXPECT_FALSE(isReady(answer));
    EXPECT_FALSE(thread.wait(std::chrono::milliseconds(0)));
    mayGo.set_value();
    EXPECT_EQ(answer.get().size(), 3U);
    EXPECT_TRUE(thread.wait(std::chrono::seconds(60)));
}

// Catches an owner that waits for its work at its end, and work that is dropped then.
TEST(BackgroundThread, outlivesItsOwnerUntilAllIsDone) {
    std::promise<void> mayGo;
    std::future<int> last;
    {
        BackgroundThread thread;
        thread.post([go = mayGo.get_future().share()] { go.wait(); });
        last = thread.ask([] { return 7; });
    }
    EXPECT_FALSE(isReady(last));
    mayGo.set_value();
    EXPECT_EQ(last.get(), 7);
}

} // namespace bask
