#include "tests/support/judged_tests.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <sys/wait.h>

namespace bask::test {
namespace {

struct Answer {
    int code = -1;
    std::string said;
    bool has(const char* words) const { return said.find(words) != std::string::npos; }
};

Answer probe(const std::string& filter) {
    Answer out;
    FILE* pipe = ::popen((BASK_PROBE " --gtest_filter=" + filter + " 2>&1").c_str(), "r");
    if (pipe == nullptr)
        return out;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        out.said += static_cast<char>(c);
    const int status = ::pclose(pipe);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

} // namespace

// Catches failures that are excused although the machine gave time.
TEST(JudgedTests, aFailureWithoutAHoldUpIsOne) {
    const Answer alone = probe("*.passes:*.fails");
    EXPECT_EQ(alone.code, 1) << alone.said;
    EXPECT_FALSE(alone.has("once more")) << alone.said;
    EXPECT_EQ(probe("*.passes").code, 0);
}

// Catches one excuse that serves for all.
TEST(JudgedTests, oneHeldUpDoesNotExcuseAnother) {
    const Answer both = probe("*.fails:*.failsHeldUp");
    EXPECT_EQ(both.code, 1) << both.said;
    EXPECT_FALSE(both.has("not judged")) << both.said;
    const Answer later = probe("*.failsHeldUpAndThenFairly");
    EXPECT_EQ(later.code, 1) << later.said;
    EXPECT_TRUE(later.has("once more: Probe.failsHeldUpAndThenFairly")) << later.said;
}

// Catches a held-up machine that fails the program, and one that is not told.
TEST(JudgedTests, whatIsHeldUpTwiceIsNamedAndNotJudged) {
    const Answer held = probe("*.passes:*.failsHeldUp");
    EXPECT_EQ(held.code, kNotJudged) << held.said;
    EXPECT_TRUE(held.has("\nnot judged: Probe.failsHeldUp failed while")) << held.said;
    EXPECT_FALSE(held.has("not judged: Probe.passes")) << held.said;
    const Answer once = probe("*.passes:*.failsHeldUpOnce");
    EXPECT_EQ(once.code, 0) << once.said;
    EXPECT_TRUE(once.has("once more: Probe.failsHeldUpOnce\n")) << once.said;
}

} // namespace bask::test
