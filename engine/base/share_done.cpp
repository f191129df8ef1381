#include "engine/base/share_done.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

constexpr double kShares = 100.0; // that are told
constexpr double kNever = std::numeric_limits<double>::infinity();

} // namespace

ShareDone partOf(const ShareDone& whole, double begin, double end) {
    if (!whole)
        return {};
    return [whole, begin, end](double share) { whole(begin + share * (end - begin)); };
}

void tellShare(const ShareDone& done, double share) {
    if (done)
        done(share);
}

ShareCount::ShareCount(ShareDone told, double steps)
    : m_told(std::move(told)), m_steps(steps), m_next(m_told && steps > 0.0 ? steps / kShares : kNever) {}

void ShareCount::tell() {
    const double share = std::min(m_done / m_steps, 1.0);
    m_next = share < 1.0 ? (std::floor(share * kShares) + 1.0) * m_steps / kShares : kNever;
    m_told(share);
}

} // namespace bask
