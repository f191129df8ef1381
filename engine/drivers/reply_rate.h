#pragma once
// The rate of a device's answers, from its newest answers.

#include <deque>

namespace bask {

class ReplyRate {
public:
    void answered(double now_s) {
        m_replies_s.push_back(now_s);
        if (m_replies_s.size() > kCounted)
            m_replies_s.pop_front();
    }
    void clear() { m_replies_s.clear(); }
    /// Returns the rate; 0 if it is unknown.
    double rate_Hz() const {
        const double over_s = m_replies_s.empty() ? 0.0 : m_replies_s.back() - m_replies_s.front();
        return over_s > 0.0 ? static_cast<double>(m_replies_s.size() - 1) / over_s : 0.0;
    }

private:
    static constexpr std::size_t kCounted = 20;

    std::deque<double> m_replies_s;
};

} // namespace bask
