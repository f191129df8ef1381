#include "widgets/scene/trail.h"

#include <cmath>

namespace bask {

namespace {

constexpr double kHopeless_m = 100.0; ///< no rig is as large

} // namespace

void Trail::clear() {
    *this = Trail();
}

bool Trail::differs(const Point& a, const Point& b) const {
    if (std::isnan(a.temperature_K) != std::isnan(b.temperature_K))
        return true;
    // A comparison with NaN is false, as wanted when both are unknown.
    return (a.p_RO - b.p_RO).squaredNorm() > m_tolerance_m * m_tolerance_m ||
           std::abs(a.temperature_K - b.temperature_K) > m_tolerance_K;
}

void Trail::append(const Point& point) {
    if (!point.p_RO.allFinite())
        return;
    m_newest = point;
    if (!m_kept.empty() && !differs(m_kept.back(), point))
        return;
    m_kept.push_back(point);
    if (m_kept.size() > kMaxPoints)
        thin();
}

void Trail::thin() {
    // At least a quarter goes each time, so that the work is spread over many appends.
    while (m_kept.size() > kMaxPoints - kMaxPoints / 4) {
        m_tolerance_m *= 2.0;
        m_tolerance_K *= 2.0;
        std::size_t count = 1;
        for (std::size_t i = 1; i < m_kept.size(); ++i)
            if (differs(m_kept[count - 1], m_kept[i]))
                m_kept[count++] = m_kept[i];
        if (count == m_kept.size() && !(m_tolerance_m < kHopeless_m)) {
            // Known and unknown in turn differ whatever the tolerance: then every other one goes.
            count = 0;
            for (std::size_t i = 0; i < m_kept.size(); i += 2)
                m_kept[count++] = m_kept[i];
        }
        m_kept.resize(count);
    }
}

} // namespace bask
