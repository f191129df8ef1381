#include "tests/support/wait_for.h"
#include "widgets/common/latest_job.h"

#include <QThreadPool>

#include <gtest/gtest.h>

#include <semaphore>
#include <thread>

namespace bask::test {
namespace {

// Catches: an old answer that arrives after, or instead of, the newest.
TEST(LatestJob, OnlyTheNewestAnswerCounts) {
    auto gate = std::make_shared<std::binary_semaphore>(0);
    LatestJob<int> job;
    std::vector<int> answers;
    const auto take = [&](int value) { answers.push_back(value); };
    job.run([gate] { return gate->acquire(), 1; }, take);
    job.run([] { return 2; }, take);
    job.run([] { return 3; }, take);
    EXPECT_TRUE(job.busy());
    gate->release();
    ASSERT_TRUE(waitFor([&] { return !job.busy(); }));
    EXPECT_EQ(answers, std::vector<int>{3});
}

// Catches: an answer that comes although it was cancelled, and a job that is stuck afterwards.
TEST(LatestJob, ForgottenOnesDoNotAnswer) {
    auto gate = std::make_shared<std::binary_semaphore>(0);
    LatestJob<int> job;
    std::vector<int> answers;
    const auto take = [&](int value) { answers.push_back(value); };
    job.run([gate] { return gate->acquire(), 1; }, take);
    job.run([] { return 2; }, take);
    job.forget();
    gate->release();
    ASSERT_TRUE(waitFor([&] { return !job.busy(); }));
    EXPECT_TRUE(answers.empty());
    job.run([] { return 3; }, take);
    ASSERT_TRUE(waitFor([&] { return !job.busy(); }));
    EXPECT_EQ(answers, std::vector<int>{3});
}

// Catches: work that goes on although nobody will hear its answer.
TEST(LatestJob, StopsWhatIsNotHeard) {
    const auto untilStopped = [](const std::stop_token& stop) {
        while (!stop.stop_requested())
            std::this_thread::yield();
        return 1;
    };
    std::vector<int> answers;
    const auto take = [&](int value) { answers.push_back(value); };
    LatestJob<int> job;
    job.run(untilStopped, take);
    job.run([] { return 2; }, take);
    ASSERT_TRUE(waitFor([&] { return !job.busy(); }));
    EXPECT_EQ(answers, std::vector<int>{2});
    job.run(untilStopped, take);
    job.forget();
    ASSERT_TRUE(waitFor([&] { return !job.busy(); }));
    {
        LatestJob<int> gone;
        gone.run(untilStopped, take);
    }
    EXPECT_TRUE(QThreadPool::globalInstance()->waitForDone(20000));
    EXPECT_EQ(answers, std::vector<int>{2});
}

// Catches: an answer delivered to an owner that is gone.
TEST(LatestJob, TheOwnerMayGoFirst) {
    auto gate = std::make_shared<std::binary_semaphore>(0);
    bool answered = false;
    {
        LatestJob<int> job;
        job.run([gate] { return gate->acquire(), 1; }, [&](int) { answered = true; });
    }
    gate->release();
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
    EXPECT_FALSE(answered);
}

// Catches: work on the GUI thread.
TEST(LatestJob, WorksOnAnotherThread) {
    LatestJob<bool> job;
    bool other = false;
    bool done = false;
    job.run([gui = std::this_thread::get_id()] { return std::this_thread::get_id() != gui; },
            [&](bool value) { other = value, done = true; });
    ASSERT_TRUE(waitFor([&] { return done; }));
    EXPECT_TRUE(other);
}

// Catches: long work that keeps the common pool from all else although it has a pool of its own.
TEST(LatestJob, RunsOnThePoolThatItIsGiven) {
    QThreadPool own;
    const int most = QThreadPool::globalInstance()->maxThreadCount();
    QThreadPool::globalInstance()->setMaxThreadCount(1);
    auto gate = std::make_shared<std::binary_semaphore>(0);
    LatestJob<int> aside(own), common;
    int done = 0;
    aside.run([gate] { return gate->acquire(), 1; }, [&](int) { ++done; });
    common.run([] { return 2; }, [&](int value) { done += value; });
    EXPECT_TRUE(waitFor([&] { return done == 2; }));
    gate->release();
    EXPECT_TRUE(waitFor([&] { return done == 3; }));
    QThreadPool::globalInstance()->setMaxThreadCount(most);
}

} // namespace
} // namespace bask::test
