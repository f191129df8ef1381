#pragma once
// Search of the workspace for the pose whose steady temperatures come nearest to what is wanted of them.

#include "engine/control/pose_lookup.h"
#include "engine/thermal/heat_balance.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace bask {

/// What is wanted of linear combinations of the steady temperatures: the least |rows T - wanted|^2 +
/// |pull (q - towards)|^2, products by coordinate.
struct SteadyAim {
    Eigen::MatrixXd rows;             ///< k x N
    Eigen::VectorXd wanted;           ///< k, K
    Vector6d pull = Vector6d::Zero(); ///< K/m and K/rad; only refine() heeds it
    Vector6d towards = Vector6d::Zero();
};

/// A pose and what the objects settle at there.
struct SteadyPose {
    Vector6d q = Vector6d::Zero(); ///< in R
    Eigen::VectorXd T_K;           ///< N
    double cost_K2 = 0.0;          ///< squared residual of the aim
};

/// Immutable: the look-up's view factors as temperatures under given heat rates. Global by the look-up, exact
/// by bounded Gauss-Newton steps from its best poses. The same question has the same answer, whatever the
/// machine's load or number of cores.
class SteadySearch {
public:
    /// Throws std::invalid_argument unless there is a rate for each object.
    SteadySearch(std::shared_ptr<const RigGeometry> geometry, std::shared_ptr<const PoseLookup> lookup,
                 std::vector<HeatRates> rates, std::stop_token stop = {});

    const RigGeometry& geometry() const { return *m_geometry; }
    const std::vector<HeatRates>& rates() const { return m_rates; }
    /// No pose of the sample keeps workspace and clearance: nothing below may be asked then.
    bool empty() const { return m_T_K.rows() == 0; }
    /// Steady temperatures at the look-up's poses, size() x N, K.
    const Eigen::ArrayXXd& table_K() const { return m_T_K; }
    const Vector6d& sample(Eigen::Index k) const { return m_lookup->pose(static_cast<std::size_t>(k)); }
    bool stopped() const { return m_stop.stop_requested(); }

    /// Steady temperatures at q and their derivatives by the six coordinates (K/m, K/rad).
    struct Gradient {
        Eigen::VectorXd T_K;
        Eigen::Matrix<double, Eigen::Dynamic, 6> dT;
    };
    Gradient at(const Vector6d& q) const;

    /// Local: from `start` inside workspace and clearance; never worse than it.
    SteadyPose refine(const SteadyAim& aim, const Vector6d& start) const;

    /// The best of up to `starts` refinements, tried cheapest first. Ends with the batch of kBatch in which
    /// the cost came under `enough_K2`; of several such in the batch the one farthest from all limits wins.
    /// Stopped, it is any pose.
    SteadyPose best(const SteadyAim& aim, int starts, double enough_K2) const;

    static constexpr int kBatch = 8;

private:
    std::vector<Vector6d> startsFor(const SteadyAim& aim, int count) const;

    std::shared_ptr<const RigGeometry> m_geometry;
    std::shared_ptr<const PoseLookup> m_lookup;
    std::vector<HeatRates> m_rates;
    std::stop_token m_stop;
    Eigen::ArrayXXd m_T_K;
};

/// The limit that a pose is nearest to.
struct LimitDistance {
    double distance_m = 0.0; ///< a radian counts as kRadianLength_m
    Limit limit = Limit::Workspace;
    int coordinate = 0; ///< of Limit::Workspace
};
LimitDistance nearestLimit(const RigGeometry& geometry, const Vector6d& q);

} // namespace bask
