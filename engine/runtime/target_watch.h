#pragma once
// Finds an object that goes away from its target while its run goes on.

#include <array>
#include <cstddef>
#include <optional>

namespace bask {

/// Compares the means of an object's error over kBin_s: each of the last kBins is farther from the target
/// than the one before, on the same side, and the newest by kFar_K or more. A controller that makes one
/// object wait for another seldom lets it go so far; with two sensors exchanged it goes on.
class TargetWatch {
public:
    static constexpr double kBin_s = 10.0;
    static constexpr std::size_t kBins = 7;
    static constexpr double kFar_K = 5.0;
    static constexpr double kMinStep_K = 0.2; ///< from one mean to the next

    struct Leaving {
        double error_K = 0.0; ///< newest mean, with its sign
        double for_s = 0.0;   ///< since the first of the means
    };

    /// Takes a reading's error. Times must increase.
    void add(double time_s, double error_K);
    /// Call with another target, and where no controller moves the object towards it.
    void reset() { *this = {}; }
    const std::optional<Leaving>& leaving() const { return m_leaving; }

private:
    void take(double mean_K);

    double m_from_s = 0.0, m_sum_K = 0.0;
    int m_count = 0;
    std::array<double, kBins> m_means_K{}; ///< oldest first
    std::size_t m_known = 0;
    std::optional<Leaving> m_leaving;
};

} // namespace bask
