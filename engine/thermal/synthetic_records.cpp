#include "engine/thermal/synthetic_records.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {

double readingStep_K(const std::vector<HeatSample>& record, const std::vector<bool>& used) {
    constexpr double kSame_K = 1e-6;
    constexpr double kWhole = 0.01; ///< of a step
    std::vector<double> readings_K;
    for (std::size_t k = 0; k < record.size(); ++k)
        if (used[k])
            readings_K.push_back(record[k].temperature_K);
    std::ranges::sort(readings_K);
    double step_K = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < readings_K.size(); ++k)
        if (const double apart_K = readings_K[k] - readings_K[k - 1]; apart_K > kSame_K)
            step_K = std::min(step_K, apart_K);
    if (!std::isfinite(step_K))
        return 0.0;
    for (const double reading_K : readings_K) {
        const double steps = (reading_K - readings_K.front()) / step_K;
        if (std::abs(steps - std::round(steps)) > kWhole)
            return 0.0;
    }
    return step_K;
}

SyntheticRecords::SyntheticRecords(const std::vector<HeatSample>& record, const IntegralProblem& problem,
                                   const IntegralFit& fit, const IdentificationOptions& options)
    : m_record(record), m_problem(problem), m_fit(fit), m_options(options),
      m_step_K(readingStep_K(record, problem.used())),
      m_noise_K(std::sqrt(std::max(fit.residual_K * fit.residual_K - m_step_K * m_step_K / 12.0, 0.0))),
      m_random(1) {
    for (std::size_t c = 0; c < problem.columns().size(); ++c) {
        if (problem.columns()[c] == FitColumn::Heating)
            m_lambda1 = fit.parameters[static_cast<Eigen::Index>(c)];
        if (problem.columns()[c] == FitColumn::Delay)
            m_delay = fit.parameters[static_cast<Eigen::Index>(c)];
    }
}

/// The object's temperature one row later. Between two rows the heating is the parabola that has its ends and
/// its mean.
double SyntheticRecords::step(std::size_t k, double T_K, double environment_K) const {
    constexpr int kMaxSteps = 1000;
    const double dt_s = m_record[k + 1].time_s - m_record[k].time_s;
    const double first = m_problem.heating(k), last = m_problem.heating(k + 1);
    const double bulge = 6.0 * m_problem.meanHeating(k) - 3.0 * (first + last);
    const double neighboursFirst_K4 = m_record[k].neighbours_K4,
                 neighboursLast_K4 = m_record[k + 1].neighbours_K4;
    const auto rate = [&](double at, double T) {
        const double neighbours_K4 = neighboursFirst_K4 + (neighboursLast_K4 - neighboursFirst_K4) * at;
        double sum = m_lambda1 * (first + (last - first) * at + bulge * at * (1.0 - at));
        for (std::size_t c = 0; c < m_problem.columns().size(); ++c)
            sum += m_fit.parameters[static_cast<Eigen::Index>(c)] *
                   m_problem.term(m_problem.columns()[c], T, environment_K, neighbours_K4);
        return sum;
    };
    const double slope_1_s = std::abs(rate(0.0, T_K + 0.5) - rate(0.0, T_K - 0.5));
    const int steps = static_cast<int>(std::clamp(4.0 * dt_s * slope_1_s, 2.0, double{kMaxSteps}));
    const double h_s = dt_s / steps;
    for (int i = 0; i < steps; ++i) {
        const double middle_K = T_K + 0.5 * h_s * rate(static_cast<double>(i) / steps, T_K);
        T_K += h_s * rate((i + 0.5) / steps, middle_K);
    }
    return T_K + m_delay * (last - first);
}

std::vector<HeatSample> SyntheticRecords::next() {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const double environment_K =
        m_options.environment_K + m_options.environmentDeviation_K * normal(m_random);
    const double place = uniform(m_random); // of the readings between two steps
    std::vector<HeatSample> out = m_record;
    double T_K = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t k = 0; k < out.size(); ++k) {
        if (!std::isfinite(T_K) && m_problem.used()[k])
            T_K = m_record[k].temperature_K; // at first, and after a time in which the heating is not known
        double reading_K = T_K + m_noise_K * normal(m_random);
        if (m_step_K > 0.0)
            reading_K = (std::round(reading_K / m_step_K + place) - place) * m_step_K;
        out[k].temperature_K = reading_K;
        if (k + 1 < out.size() && std::isfinite(T_K))
            T_K = step(k, T_K, environment_K);
    }
    return out;
}

} // namespace bask
