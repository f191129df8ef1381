#include "engine/control/model_based.h"

#include "engine/control/paper_law.h"

#include <cmath>
#include <stdexcept>

namespace bask {

ModelBasedController::ModelBasedController(const ControllerSettings& settings, ControlModel model)
    : m_settings(settings), m_model(std::move(model)) {}

ControlOutput ModelBasedController::step(const Observation& observation, double dt_s) {
    const auto N = m_model.estimated.size();
    if (observation.objects.size() != N)
        throw std::invalid_argument("ModelBasedController: wrong number of objects");
    const ModelBasedGains& gains = m_settings.modelBased;
    const ViewFactors seen = m_model.geometry->viewFactors(observation.coordinates);
    auto rows = seen.dF;
    Eigen::VectorXd wanted(static_cast<Eigen::Index>(N));
    const Eigen::VectorXd gainRates_K4_s = neighbourGainRates_K4_s(*m_model.geometry, observation);
    for (std::size_t i = 0; i < N; ++i) {
        const HeatRates& rates = m_model.estimated[i];
        const auto [T, v] = observation.objects[i];
        const auto row = static_cast<Eigen::Index>(i);
        rows.row(row) *= rates.lambda1 * observation.sourceStrength;
        wanted[row] = -gains.D * v - gains.K * (T - m_model.targets_K[i]) + rates.lossSlope_1_s(T) * v -
                      rates.lambda2 * gainRates_K4_s[row];
    }
    ControlOutput out = followWanted(*m_model.geometry, m_settings, observation, dt_s, rows, wanted);
    leaveDark(*m_model.geometry, observation, seen, m_model.targets_K, dt_s, out);
    out.estimate = m_model.estimated;
    return out;
}

} // namespace bask
