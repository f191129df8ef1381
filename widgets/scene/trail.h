#pragma once
// A trajectory coloured by temperature that stays small however long it grows.

#include <Eigen/Core>

#include <vector>

namespace bask {

/// Keeps a point if position or temperature differ by more than a tolerance from the last kept one; if there
/// are too many points, the tolerances double and the kept points are thinned. Appending takes amortised
/// constant time.
class Trail {
public:
    struct Point {
        Eigen::Vector3d p_RO = Eigen::Vector3d::Zero(); ///< m
        double temperature_K = 0.0;                     ///< NaN if not known
    };

    static constexpr std::size_t kMaxPoints = 4096;
    static constexpr double kTolerance_m = 2.5e-4;
    static constexpr double kTolerance_K = 0.25;

    void clear();
    void append(const Point& point);

    /// The kept points; the newest is only among them if it was kept.
    const std::vector<Point>& kept() const { return m_kept; }
    /// The newest point; only when !empty().
    const Point& newest() const { return m_newest; }
    bool empty() const { return m_kept.empty(); }

private:
    bool differs(const Point& a, const Point& b) const;
    void thin();

    std::vector<Point> m_kept;
    Point m_newest;
    double m_tolerance_m = kTolerance_m;
    double m_tolerance_K = kTolerance_K;
};

} // namespace bask
