#pragma once
// How late control steps began, over a run of any length.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace bask {

/// A histogram with bins of 0.1 ms and constant size.
class Lateness {
public:
    void add(double lateness_s) {
        const double bin = std::clamp(lateness_s / kBin_s, 0.0, static_cast<double>(kBins - 1));
        ++m_bins[static_cast<std::size_t>(bin)];
        ++m_count;
        m_worst_s = std::max(m_worst_s, lateness_s);
    }
    std::uint64_t count() const { return m_count; }
    double worst_s() const { return m_worst_s; }
    /// Returns the lateness that this share of the steps did not exceed, rounded up to a bin; 0 without
    /// steps.
    double quantile_s(double share) const {
        const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(m_count)));
        std::uint64_t seen = 0;
        for (std::size_t i = 0; i + 1 < kBins && m_count > 0; ++i) { // the last bin has no upper limit
            seen += m_bins[i];
            if (seen >= wanted)
                return std::min(m_worst_s, kBin_s * static_cast<double>(i + 1));
        }
        return m_worst_s;
    }

private:
    static constexpr std::size_t kBins = 5000;
    static constexpr double kBin_s = 1e-4;
    std::array<std::uint64_t, kBins> m_bins{};
    std::uint64_t m_count = 0;
    double m_worst_s = 0.0;
};

} // namespace bask
