#pragma once
// What an object loses, as its last readings admit it.

#include "engine/runtime/heat_bounds.h"

#include <Eigen/Core>

#include <vector>

namespace bask {

/// A least squares fit of T = c + k E - b t - a Q to readings before a moment: t, E and Q are time, absorbed
/// energy and the integral of T, all since that moment. Each k, how wrong the estimated heating is, within
/// kBorneFactor is tried. a is within the range of losses. b, the losses at that moment, is
/// tied to a and to the room: a times the temperature over the room, more by what was absorbed when the
/// sensor was zeroed. The readings' standard deviation is at least that with which the best fit explains
/// them.
class LossFit {
public:
    /// A k that explains the readings, and the range of losses at the moment with it.
    struct Explanation {
        double k = 0.0;
        double loss_K_s = 0.0;
        double unsure_K_s = 0.0; ///< how far the losses may be from that
    };
    static constexpr double kSigmas = 5.0; ///< of what a fit may miss

    /// The tie of the losses to the room.
    struct Room {
        double temperature_K = 0.0;
        double deviation_K = 0.0; ///< standard deviation
        double rest_K_s = 0.0;    ///< absorbed at its temperature, as much as was lost
    };

    /// Readings are rows (1, -t, -Q) with their changes since the moment.
    LossFit(LossRange losses, const Room& room, double temperature_K, Eigen::MatrixX3d design,
            Eigen::VectorXd change_K);

    /// Fits with the energies of the readings since the moment as a sensor sees them that lags; one vector
    /// for each lag. Returns the explanations for each lag.
    std::vector<std::vector<Explanation>> explain(const std::vector<Eigen::VectorXd>& energies_K,
                                                  double sigma_K) const;

private:
    struct Fit {
        Explanation explanation;
        double data_K2 = 0.0; ///< sum of squares that it leaves
        double miss = 0.0;    ///< chi squared
    };
    struct Sums;
    Fit fit(const Sums& sums, double k, double sigma_K) const;

    LossRange m_losses;
    Room m_room;
    double m_over_K;
    Eigen::MatrixX3d m_design;
    Eigen::VectorXd m_change_K;
    Eigen::Matrix3d m_normal;
};

} // namespace bask
