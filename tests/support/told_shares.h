#pragma once
// What a longer work tells of how much of it is done.

#include "engine/base/share_done.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace bask::test {

class ToldShares {
public:
    ShareDone told() {
        return [this](double share) {
            EXPECT_EQ(std::this_thread::get_id(), m_thread);
            m_shares.push_back(share);
        };
    }
    /// From near 0 to 1, never back, seldom enough to cost nothing.
    void expectAWhole(std::size_t atLeast) const {
        ASSERT_GE(m_shares.size(), atLeast);
        EXPECT_LE(m_shares.size(), 500U);
        EXPECT_GE(m_shares.front(), 0.0);
        EXPECT_LT(m_shares.front(), 0.5);
        EXPECT_EQ(m_shares.back(), 1.0);
        EXPECT_TRUE(std::ranges::is_sorted(m_shares));
    }
    const std::vector<double>& shares() const { return m_shares; }

private:
    std::thread::id m_thread = std::this_thread::get_id();
    std::vector<double> m_shares;
};

} // namespace bask::test
