// Tests that fail, for judged_tests_test.cpp. One that is "held up" is stopped as a whole, as a virtual
// machine stops.

#include "tests/support/judged_tests.h"

#include <gtest/gtest.h>

#include <csignal>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace {

void holdUp() {
    const pid_t self = ::getpid();
    const pid_t child = ::fork();
    if (child == 0) {
        ::kill(self, SIGSTOP);
        ::usleep(1'400'000);
        ::kill(self, SIGCONT);
        ::_exit(0);
    }
    ::waitpid(child, nullptr, 0);
}

bool isFirst = true;

} // namespace

TEST(Probe, passes) {}

TEST(Probe, fails) {
    ADD_FAILURE();
}

TEST(Probe, failsHeldUp) {
    holdUp();
    ADD_FAILURE();
}

TEST(Probe, failsHeldUpOnce) {
    if (!std::exchange(isFirst, false))
        return;
    holdUp();
    ADD_FAILURE();
}

TEST(Probe, failsHeldUpAndThenFairly) {
    if (std::exchange(isFirst, false))
        holdUp();
    ADD_FAILURE();
}

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    // Beyond what a machine does by itself within a few milliseconds: steal is never over 100 %.
    return bask::test::runJudgedTests({1.0, 2.0});
}
