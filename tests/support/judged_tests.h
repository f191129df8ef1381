#pragma once
// Tests against real time are judged only where the machine gave them time.

namespace bask::test {

/// A failed test that was held up by more is not judged.
struct HoldUpLimits {
    double late_s = 0.25;     ///< of a sleeping thread, or of a byte in a terminal
    double stolenShare = 0.2; ///< together with late_s of stolen time
};

constexpr int kNotJudged = 77; ///< ctest's SKIP_RETURN_CODE of these tests

/// RUN_ALL_TESTS(). Where each test that failed was held up, they are run once more; those that fail again
/// and were held up again are told in a line "not judged: ..." each, and if there are no others it is
/// kNotJudged.
int runJudgedTests(const HoldUpLimits& limits = {});

} // namespace bask::test
