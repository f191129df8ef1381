#pragma once
// Lambert's integrals (lambert_field.h) along many lines at once, for several points.

#include <Eigen/Core>

#include <array>

namespace bask {

/// Sums of integrals, one for each point, by the kernels for the processor. A line is taken up with its
/// point's number and a factor; it is ready after finish(). No line may be added for a number from
/// kPoints on.
class LambertBatch {
public:
    static constexpr int kPoints = 16;

    LambertBatch() { m_fields.fill(Eigen::Vector3d::Zero()); }

    /// Along the straight line from r = a to r = b.
    void addStraight(int point, double factor, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        if (m_straights.count == kLines)
            finishStraights();
        m_straights.add(point, factor, {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
    }
    /// Along an arc of a circle about the origin of its frame, counter-clockwise between two unit vectors, as
    /// seen from p in that frame; `axes` has the frame's axes as columns and must outlive finish(). From a
    /// vector to itself and `isLong`: the whole circle.
    void addArc(int point, double factor, double radius, const Eigen::Vector3d& p,
                const Eigen::Vector2d& from, const Eigen::Vector2d& to, bool isLong,
                const Eigen::Matrix3d& axes) {
        if (m_arcs.count == kLines)
            finishArcs();
        m_axes[static_cast<std::size_t>(m_arcs.count)] = &axes;
        m_arcs.add(point, factor,
                   {radius, p.x(), p.y(), p.z(), from.x(), from.y(), to.x(), to.y(), isLong ? 1.0 : 0.0});
    }
    void add(int point, double factor, const Eigen::Vector3d& field) {
        m_fields[static_cast<std::size_t>(point)] += factor * field;
    }
    void finish() {
        finishStraights();
        finishArcs();
    }
    const Eigen::Vector3d& field(int point) const { return m_fields[static_cast<std::size_t>(point)]; }

private:
    static constexpr int kLines = 64; // a multiple of the kernels' padding

    /// Lines as separate arrays of what describes them.
    template <std::size_t kRows> struct Lines {
        int count = 0;
        std::array<std::array<double, kLines>, kRows> rows;
        std::array<double, kLines> factors;
        std::array<int, kLines> points;

        void add(int point, double factor, const std::array<double, kRows>& line) {
            const auto i = static_cast<std::size_t>(count++);
            for (std::size_t row = 0; row < kRows; ++row)
                rows[row][i] = line[row];
            factors[i] = factor;
            points[i] = point;
        }
        std::array<double*, kRows> pad();
    };

    void finishStraights();
    void finishArcs();

    Lines<6> m_straights;
    Lines<9> m_arcs;
    std::array<const Eigen::Matrix3d*, kLines> m_axes;
    std::array<Eigen::Vector3d, kPoints> m_fields;
};

} // namespace bask
