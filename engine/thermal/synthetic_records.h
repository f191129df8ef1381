#pragma once
// Records as a sensor would have made them of an object with known rates, for the errors of a fit.

#include "engine/thermal/integral_fit.h"

#include <random>
#include <vector>

namespace bask {

/// Returns the step in which readings are rounded, K: all of them are whole steps apart. 0 if there is none.
double readingStep_K(const std::vector<HeatSample>& record, const std::vector<bool>& used);

/// Integrates the heat balance of a fit along a record's view factors, and reads it with noise and rounding
/// as in the record: white noise that explains the residuals, a rounding step as found, at a random place
/// between two steps each time, and a room that is off by its standard error. Rounding is what the errors of
/// a fit come from: an object at rest shows the same wrong reading for minutes, which no formula for
/// independent errors knows. (Parametric bootstrap: Efron and Tibshirani, An Introduction to the Bootstrap,
/// 1993, section 6.5.) The same record has the same synthetic ones. Keeps references to all arguments but the
/// options.
class SyntheticRecords {
public:
    SyntheticRecords(const std::vector<HeatSample>& record, const IntegralProblem& problem,
                     const IntegralFit& fit, const IdentificationOptions& options);
    std::vector<HeatSample> next();

private:
    double step(std::size_t k, double T_K, double environment_K) const;

    const std::vector<HeatSample>& m_record;
    const IntegralProblem& m_problem;
    const IntegralFit& m_fit;
    IdentificationOptions m_options;
    double m_step_K, m_noise_K;
    double m_lambda1 = 0.0, m_delay = 0.0;
    std::mt19937_64 m_random;
};

} // namespace bask
