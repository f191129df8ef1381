#pragma once
// Searches the workspace for the pose whose steady temperatures are nearest to the wanted ones.

#include "engine/control/pose_lookup.h"
#include "engine/thermal/heat_balance.h"

#include <memory>
#include <stop_token>
#include <vector>

namespace bask {

/// Wanted values of linear combinations of the steady temperatures: minimise |rows T - wanted|^2 + |pull (q -
/// towards)|^2, with products by coordinate.
struct SteadyAim {
    Eigen::MatrixXd rows;             ///< k x N
    Eigen::VectorXd wanted;           ///< k, K
    Vector6d pull = Vector6d::Zero(); ///< K/m and K/rad; used only by refine()
    Vector6d towards = Vector6d::Zero();
};

/// A pose and the steady temperatures of the objects there.
struct SteadyPose {
    Vector6d q = Vector6d::Zero(); ///< in R
    Eigen::VectorXd T_K;           ///< N; without meaning for objects in no row of the aim
    double cost_K2 = 0.0;          ///< squared residual of the aim
};

/// Immutable: the look-up's view factors as temperatures under given heat rates. The look-up makes the search
/// global, and bounded Gauss-Newton steps from its best poses make it exact. The same question has the same
/// answer, independent of the machine's load or number of cores.
class SteadySearch {
public:
    /// Throws std::invalid_argument unless there is one rate for each object.
    SteadySearch(std::shared_ptr<const RigGeometry> geometry, std::shared_ptr<const PoseLookup> lookup,
                 std::vector<HeatRates> rates, std::stop_token stop = {});

    const RigGeometry& geometry() const { return *m_geometry; }
    const std::vector<HeatRates>& rates() const { return m_rates; }
    /// Returns whether no pose of the sample is within workspace and clearance: do not call the functions
    /// below then.
    bool empty() const { return m_T_K.rows() == 0; }
    /// Returns the steady temperatures at the look-up's poses, size() x N, K.
    const Eigen::ArrayXXd& table_K() const { return m_T_K; }
    const Vector6d& sample(Eigen::Index k) const { return m_lookup->pose(static_cast<std::size_t>(k)); }
    bool stopped() const { return m_stop.stop_requested(); }

    /// Steady temperatures at q and their derivatives by the six coordinates (K/m, K/rad).
    struct Gradient {
        Eigen::VectorXd T_K;
        Eigen::Matrix<double, Eigen::Dynamic, 6> dT;
    };
    Gradient at(const Vector6d& q) const;

    /// Searches locally from `start` inside workspace and clearance. Without shade the result is never worse
    /// than `start`.
    SteadyPose refine(const SteadyAim& aim, const Vector6d& start, Shade shade = Shade::Exact) const;

    /// Returns the best of up to `starts` refinements, tried in ascending order of cost. Ends with the batch
    /// of kBatch in which the cost fell below `enough_K2`; if several in that batch did, the one farthest
    /// from all limits is returned. If stopped, returns any pose.
    SteadyPose best(const SteadyAim& aim, int starts, double enough_K2) const;

    static constexpr int kBatch = 8;

private:
    Gradient withTemperatures(ViewFactors now) const;
    Eigen::VectorXd steadyAt_K(const Eigen::VectorXd& F) const;
    /// Searches with rough temperatures plus `missed_K` (N). Ends when three steps in a row gain less than
    /// this part of the cost.
    SteadyPose descend(const SteadyAim& aim, const Vector6d& start, const Eigen::VectorXd& missed_K,
                       double gain) const;
    SteadyPose madeExact(const SteadyAim& aim, SteadyPose found) const;
    std::vector<Vector6d> startsFor(const SteadyAim& aim, int count) const;

    std::shared_ptr<const RigGeometry> m_geometry;
    std::shared_ptr<const PoseLookup> m_lookup;
    std::vector<HeatRates> m_rates;
    std::stop_token m_stop;
    Eigen::ArrayXXd m_T_K;
};

/// The limit nearest to a pose.
struct LimitDistance {
    double distance_m = 0.0; ///< a radian counts as kRadianLength_m
    Limit limit = Limit::Workspace;
    int coordinate = 0; ///< coordinate of Limit::Workspace
};
LimitDistance nearestLimit(const RigGeometry& geometry, const Vector6d& q);

} // namespace bask
