#pragma once
// Gauss-Legendre rules and an adaptive Gauss-Kronrod integrator for the seven integrals of a view factor.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace bask {

/// What one point of the object's outline (or a sum over points) adds: the circulation W.dp (m2), the force
/// dp x B (m) and the torque lever x (dp x B) (m2); `distance_m` is the least distance to the source's edge
/// seen so far.
struct LoopSums {
    double circulation = 0.0;
    std::array<double, 6> moments{};
    double distance_m = 1e300;

    /// Adds `weight` times `other`; the distance is the lesser one, whatever the weight.
    void add(const LoopSums& other, double weight = 1.0) {
        circulation += weight * other.circulation;
        for (std::size_t i = 0; i < 6; ++i)
            moments[i] += weight * other.moments[i];
        distance_m = other.distance_m < distance_m ? other.distance_m : distance_m;
    }
};

/// Difference of two sums as (value, gradient) with the force brought to m2 by `length_m`.
struct LoopDifference {
    double circulation = 0.0;
    double moments = 0.0;
};
LoopDifference difference(const LoopSums& a, const LoopSums& b, double length_m);

/// Gauss-Legendre nodes and weights on [0, 1], 1 <= n <= 16.
struct GaussRule {
    std::span<const double> nodes;
    std::span<const double> weights;
};
GaussRule gaussRule(int n);

/// Kronrod's 15 points on [0, 1] with their own weights and those of the embedded 7-point Gauss rule (0 where
/// unused).
struct KronrodPoint {
    double node, weight, gaussWeight;
};
const std::array<KronrodPoint, 15>& kronrodPoints();

/// When an adaptive integral is good enough.
struct AdaptiveGoal {
    double circulation = 0.0; ///< m2, allowed error
    double moments = 0.0;     ///< m2, allowed error (force times `length_m`)
    double length_m = 1.0;    ///< size of the object
    int maxPoints = 4096;     ///< then it stops, the error tells
    double leastPanel =
        1e-6; ///< parameter length below which nearness to the source's edge splits no further
};

/// An adaptive integral and its estimated error (m2, of the circulation).
struct AdaptiveResult {
    LoopSums sums;
    double error = 0.0;
};

/// One interval of the parameter with its integral and what the embedded rule thinks of it.
struct AdaptivePanel {
    double from = 0.0, to = 0.0;
    LoopSums sums;
    LoopDifference error;
    bool resolved = true; ///< short beside its distance to the source's edge
};

/// The list of panels that an adaptive integral works on.
class PanelList {
public:
    explicit PanelList(const AdaptiveGoal& goal) : m_goal(goal) { m_panels.reserve(32); }

    bool canGrow() const { return 15 * static_cast<int>(m_panels.size() + 1) <= m_goal.maxPoints; }
    void add(const AdaptivePanel& panel) { m_panels.push_back(panel); }

    /// Index of the panel to split next, or -1 when the goal is met.
    int worst() const;
    AdaptivePanel take(int index) {
        const AdaptivePanel panel = m_panels[static_cast<std::size_t>(index)];
        m_panels[static_cast<std::size_t>(index)] = m_panels.back();
        m_panels.pop_back();
        return panel;
    }
    AdaptiveResult total() const;

private:
    AdaptiveGoal m_goal;
    std::vector<AdaptivePanel> m_panels;
};

/// Integral of `f` over [from, to], cut into `start` equal panels and then where it is needed. `f(t)` gives a
/// LoopSums per unit t, no faster than `speed_m` metres per unit t.
template <class F>
AdaptiveResult integrateAdaptively(const F& f, double from, double to, int start, double speed_m,
                                   const AdaptiveGoal& goal) {
    const auto panel = [&](double a, double b) {
        AdaptivePanel made;
        made.from = a;
        made.to = b;
        LoopSums gauss;
        double farthest_m = 0.0;
        for (const KronrodPoint& point : kronrodPoints()) {
            const LoopSums sample = f(a + (b - a) * point.node);
            made.sums.add(sample, (b - a) * point.weight);
            gauss.add(sample, (b - a) * point.gaussWeight);
            farthest_m = std::max(farthest_m, sample.distance_m);
        }
        made.error = difference(made.sums, gauss, goal.length_m);
        // A peak between the points cannot hide where the way keeps its distance, or is short beside it.
        const double nearest_m = made.sums.distance_m;
        made.resolved = nearest_m >= 0.25 * (b - a) * speed_m || farthest_m <= 3.0 * nearest_m ||
                        b - a <= goal.leastPanel;
        return made;
    };
    PanelList panels(goal);
    const int first = std::clamp(goal.maxPoints / 15, 1, start);
    for (int i = 0; i < first; ++i)
        panels.add(panel(from + (to - from) * i / first, from + (to - from) * (i + 1) / first));
    for (int worst = panels.worst(); worst >= 0 && panels.canGrow(); worst = panels.worst()) {
        const AdaptivePanel old = panels.take(worst);
        const double middle = 0.5 * (old.from + old.to);
        panels.add(panel(old.from, middle));
        panels.add(panel(middle, old.to));
    }
    return panels.total();
}

} // namespace bask
