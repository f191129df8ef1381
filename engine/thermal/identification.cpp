#include "engine/thermal/identification.h"

#include "engine/base/message_code.h"
#include "engine/thermal/integral_fit.h"
#include "engine/thermal/synthetic_records.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <string>

namespace bask {
namespace {

constexpr int kPasses = 20;             ///< maximum number of passes that leave out readings
constexpr double kWorstError = 0.25;    ///< standard error over value
constexpr double kMinVariation = 0.02;  ///< of the view factor, between its 5 % and 95 % quantiles
constexpr double kSurelyNegative = 3.0; ///< standard errors below zero
constexpr double kNoise = 4.0;          ///< spread of noise or rounding alone, over its deviation or step

// Synthetic records, so many as a standard error to 7 % takes; fewer of a record that is long itself.
constexpr std::size_t kMaxSynthetic = 100, kMinSynthetic = 20;
constexpr std::size_t kSyntheticRows = 1'000'000; ///< of all of them together

/// Spread of a value without its extremes.
double variation(const std::vector<HeatSample>& record, const std::vector<IntegralWindow>& windows,
                 double HeatSample::*value) {
    std::vector<double> values;
    for (const IntegralWindow& window : windows)
        for (const std::size_t k : window.readings)
            values.push_back(record[k].*value);
    std::ranges::sort(values);
    return values[values.size() * 95 / 100] - values[values.size() * 5 / 100];
}

std::string percent(double fraction) {
    return formatNumber(100.0 * fraction, 2);
}

struct Named {
    const char* name;
    const Estimate& estimate;
};

/// Why the fitted rates cannot be used, if there is a reason.
Message verdict(const IdentifiedRates& rates, double variation_F) {
    const Named rows[] = {{"lambda1", rates.lambda1}, {"lambda2", rates.lambda2}, {"lambda3", rates.lambda3}};
    for (const auto& [name, estimate] : rows) {
        const double relative = estimate.standardError / std::abs(estimate.value);
        if (relative <= kWorstError)
            continue;
        if (variation_F < kMinVariation)
            return {MessageCode::IdentificationStill, {formatNumber(variation_F, 2)}};
        return {MessageCode::IdentificationUncertain, {name, percent(relative)}};
    }
    for (const auto& [name, estimate] : rows) {
        if (estimate.value > 0.0)
            continue;
        if (variation_F < kMinVariation) // what noise makes of nothing
            return {MessageCode::IdentificationStill, {formatNumber(variation_F, 2)}};
        return {MessageCode::IdentificationNegative, {name}};
    }
    if (rates.convection.value < -kSurelyNegative * rates.convection.standardError)
        return {MessageCode::IdentificationNegative, {"h'"}};
    return {};
}

/// Rates, and then the loss and its slope at the working temperature.
Eigen::VectorXd quantities(const IntegralProblem& problem, const IntegralFit& fit, double working_K,
                           double environment_K) {
    constexpr double kStep_K = 0.5;
    const auto loss_K_s = [&](double T_K) {
        double loss = 0.0;
        for (std::size_t c = 0; c < problem.columns().size(); ++c)
            loss -= fit.parameters[static_cast<Eigen::Index>(c)] *
                    problem.term(problem.columns()[c], T_K, environment_K, 0.0);
        return loss;
    };
    const Eigen::Index p = fit.parameters.size();
    Eigen::VectorXd out(p + 2);
    out.head(p) = fit.parameters;
    out[p] = loss_K_s(working_K);
    out[p + 1] = (loss_K_s(working_K + kStep_K) - loss_K_s(working_K - kStep_K)) / (2.0 * kStep_K);
    return out;
}

struct Corrected {
    Eigen::VectorXd values, standardErrors;
};

/// Fits synthetic records of the fitted rates: their scatter is the standard error, their mean's distance
/// from the fit the bias, which is taken off. Residuals that move more slowly than those of every synthetic
/// record tell of something that the balance leaves out: the errors grow by as much.
Corrected corrected(const IntegralProblem& problem, const IntegralFit& fit,
                    const std::vector<HeatSample>& record, const IdentificationOptions& options,
                    double working_K) {
    const std::size_t count =
        std::clamp(kSyntheticRows / std::max<std::size_t>(record.size(), 1), kMinSynthetic, kMaxSynthetic);
    const Eigen::VectorXd found = quantities(problem, fit, working_K, options.environment_K);
    SyntheticRecords synthetic(record, problem, fit, options);
    std::vector<Eigen::VectorXd> all;
    double slow_K = 0.0, slowest_K = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::vector<HeatSample> made = synthetic.next();
        IntegralProblem again(made, options);
        again.use(problem.used());
        again.cut();
        const IntegralFit other = again.solve();
        if (other.parameters.size() != fit.parameters.size())
            continue;
        all.push_back(quantities(again, other, working_K, options.environment_K) - found);
        slow_K += other.slowResidual_K;
        slowest_K = std::max(slowest_K, other.slowResidual_K);
    }
    const Eigen::VectorXd unknown =
        Eigen::VectorXd::Constant(found.size(), std::numeric_limits<double>::infinity());
    if (all.size() < kMinSynthetic / 2)
        return {found, unknown};
    const auto n = static_cast<double>(all.size());
    Eigen::VectorXd bias = Eigen::VectorXd::Zero(found.size()), variance = bias;
    for (const Eigen::VectorXd& off : all)
        bias += off / n;
    for (const Eigen::VectorXd& off : all)
        variance += (off - bias).cwiseAbs2() / (n - 1.0);
    const double misfit =
        fit.slowResidual_K > slowest_K && slow_K > 0.0 ? fit.slowResidual_K * n / slow_K : 1.0;
    return {found - bias, misfit * variance.cwiseSqrt()};
}

void putEstimates(IdentifiedRates& out, const std::vector<FitColumn>& columns, const Corrected& found,
                  const IdentificationOptions& options) {
    const auto at = [&](std::size_t i) {
        const auto k = static_cast<Eigen::Index>(i);
        return Estimate{found.values[k], found.standardErrors[k]};
    };
    for (std::size_t c = 0; c < columns.size(); ++c) {
        switch (columns[c]) {
        case FitColumn::Heating:
            out.lambda1 = at(c);
            break;
        case FitColumn::Cooling:
            out.lambda2 = at(c);
            break;
        case FitColumn::Rest:
            out.lambda3 = at(c);
            break;
        case FitColumn::Convection:
            out.convection = at(c);
            break;
        case FitColumn::Delay:
            break;
        }
    }
    out.loss = at(columns.size());
    out.lossSlope = at(columns.size() + 1);
    if (!options.freeAmbient) {
        const double rest_K4 = std::pow(options.environment_K, 4) * options.environmentShare;
        out.lambda3 = {out.lambda2.value * rest_K4, out.lambda2.standardError * rest_K4};
    }
    if (!options.convection)
        out.airPerLambda2 = options.airPerLambda2;
}

/// Median of the second half's readings: where the run has worked.
double workingTemperature_K(const std::vector<HeatSample>& record, const std::vector<bool>& used) {
    std::vector<double> readings_K;
    for (std::size_t k = 0; k < record.size(); ++k)
        if (used[k] && record[k].time_s >= 0.5 * (record.front().time_s + record.back().time_s))
            readings_K.push_back(record[k].temperature_K);
    if (readings_K.empty())
        return std::numeric_limits<double>::quiet_NaN();
    return medianOf(std::move(readings_K));
}

/// The fit with the given T3; its reason is set if there are no rates.
IdentifiedRates fitted(const std::vector<HeatSample>& record, const IdentificationOptions& options,
                       double& variation_F) {
    IntegralProblem problem(record, options);
    IntegralFit fit;
    for (int pass = 0; pass < kPasses; ++pass) {
        problem.cut();
        fit = problem.longEnough() ? problem.solve() : IntegralFit();
        if (fit.parameters.size() == 0 || !problem.leaveOut(fit))
            break;
    }
    IdentifiedRates out;
    out.readings = problem.readings();
    out.outliers = problem.outliers();
    out.windows = static_cast<int>(problem.windows().size());
    out.window_s = problem.window_s();
    out.residual_K = fit.residual_K;
    out.condition = fit.condition;
    if (!problem.longEnough()) {
        out.reason = {MessageCode::IdentificationTooShort,
                      {std::to_string(out.readings), std::to_string(problem.minWindows()),
                       formatNumber(problem.shortest_s(), 3)}};
        return out;
    }
    variation_F = variation(record, problem.windows(), &HeatSample::viewFactor);
    const double variation_K = variation(record, problem.windows(), &HeatSample::temperature_K);
    const bool isAtRest =
        variation_F < kMinVariation &&
        variation_K < kNoise * std::max(fit.residual_K, readingStep_K(record, problem.used()));
    const bool heated = std::ranges::any_of(problem.windows(), [](const IntegralWindow& window) {
        return window.X.col(0).cwiseAbs().maxCoeff() > 0.0;
    });
    if (!heated) {
        out.reason = {MessageCode::IdentificationUnheated, {}};
    } else if (fit.parameters.size() == 0 || isAtRest) {
        out.reason = {MessageCode::IdentificationStill, {formatNumber(variation_F, 2)}};
    } else {
        out.workingTemperature_K = workingTemperature_K(record, problem.used());
        putEstimates(out, problem.columns(),
                     corrected(problem, fit, record, options, out.workingTemperature_K), options);
    }
    return out;
}

/// With air of which nothing is known, the loss and its slope are those of a fit with both kinds of loss,
/// which knows them even where it cannot tell the two kinds apart.
void tellLoss(IdentifiedRates& out, const std::vector<HeatSample>& record, IdentificationOptions options) {
    if (options.isAirKnown && !options.convection)
        return;
    IdentifiedRates joint = out;
    if (!options.convection) {
        options.convection = true;
        double unused = 0.0;
        joint = fitted(record, options, unused);
        out.loss = joint.loss;
        out.lossSlope = joint.lossSlope;
    }
    const bool areApart =
        joint.usable() && joint.lambda2.standardError <= kWorstError * std::abs(joint.lambda2.value);
    if (!areApart)
        out.caveat = {MessageCode::IdentificationAirTogether,
                      {roundedTemperatureArg(out.workingTemperature_K, 1)}};
}

} // namespace

IdentifiedRates identifyRates(const std::vector<HeatSample>& record, const IdentificationOptions& options) {
    double variation_F = 0.0;
    IdentifiedRates out = fitted(record, options, variation_F);
    if (!out.usable())
        return out;
    tellLoss(out, record, options);
    out.reason = verdict(out, variation_F);
    return out;
}

} // namespace bask
