#include "engine/thermal/identification.h"

#include "engine/base/message_code.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <string>

namespace bask {
namespace {

constexpr double kRecordWindows = 16.0; ///< number of windows of a record, unless they become too short
constexpr double kMinWindow_s = 10.0;
constexpr double kWindowPeriods = 10.0;
constexpr std::size_t kMinReadings = 4; ///< in a window
constexpr double kLargestGap = 0.25;    ///< largest gap between readings, as a share of the window
constexpr double kOutlierDeviations = 6.0;
constexpr double kMinOutlier_K = 0.1; ///< rounding of usual sensors is not an outlier
constexpr int kPasses = 20;           ///< maximum number of passes that leave out readings
constexpr double kWorstCondition = 1e6;
constexpr double kWorstError = 0.25;    ///< standard error over value
constexpr double kMinVariation = 0.02;  ///< of the view factor, between its 5 % and 95 % quantiles
constexpr double kSurelyNegative = 3.0; ///< standard errors below zero

enum Column { kHeating, kCooling, kRest, kConvection };

/// Readings of one window with the integrals since its first.
struct Window {
    std::vector<std::size_t> readings; ///< indices into the record
    Eigen::MatrixXd X;                 ///< one row a reading, one column a parameter
    Eigen::VectorXd y;                 ///< temperatures above the window's first, K
};

struct Fit {
    Eigen::VectorXd parameters;
    Eigen::VectorXd standardErrors;
    double residual_K = 0.0;
    double condition = std::numeric_limits<double>::infinity();
};

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double windowLength_s(const std::vector<HeatSample>& record) {
    std::vector<double> steps_s;
    for (std::size_t k = 1; k < record.size(); ++k)
        steps_s.push_back(record[k].time_s - record[k - 1].time_s);
    if (steps_s.empty())
        return kMinWindow_s;
    const double duration_s = record.back().time_s - record.front().time_s;
    return std::max(
        {duration_s / kRecordWindows, kWindowPeriods * medianOf(std::move(steps_s)), kMinWindow_s});
}

class Problem {
public:
    Problem(const std::vector<HeatSample>& record, const IdentificationOptions& options)
        : m_record(record), m_options(options), m_window_s(windowLength_s(record)) {
        m_columns = {kHeating, kCooling};
        if (options.freeAmbient)
            m_columns.push_back(kRest);
        if (options.convection)
            m_columns.push_back(kConvection);
        for (const HeatSample& sample : record)
            m_used.push_back(sample.valid && std::isfinite(sample.temperature_K) &&
                             sample.temperature_K > 0.0);
    }

    const std::vector<Column>& columns() const { return m_columns; }
    const std::vector<Window>& windows() const { return m_windows; }
    double window_s() const { return m_window_s; }
    int outliers() const { return m_outliers; }
    int readings() const {
        int count = 0;
        for (const Window& window : m_windows)
            count += static_cast<int>(window.y.size());
        return count;
    }
    bool longEnough() const { return m_windows.size() >= minWindows(); }
    std::size_t minWindows() const { return 2 * m_columns.size(); }

    void cut();
    Fit solve() const;
    bool leaveOut(const Fit& fit);

private:
    double heating(std::size_t k) const { return m_record[k].viewFactor * m_record[k].sourceStrength; }
    double loss(Column column, double T_K) const; ///< integrand of the other columns
    /// One integral for each column, from reading a to reading b; not finite if the heating between them is
    /// not known.
    Eigen::VectorXd integrals(std::size_t a, std::size_t b) const;
    void close(Window& window, std::vector<Eigen::VectorXd>& rows);

    const std::vector<HeatSample>& m_record;
    IdentificationOptions m_options;
    std::vector<Column> m_columns;
    std::vector<bool> m_used;
    double m_window_s;
    std::vector<Window> m_windows;
    int m_outliers = 0;
};

double Problem::loss(Column column, double T_K) const {
    const double rest_K4 = std::pow(m_options.environment_K, 4) * m_options.environmentShare;
    switch (column) {
    case kCooling:
        return -(std::pow(T_K, 4) - (m_options.freeAmbient ? 0.0 : rest_K4));
    case kRest:
        return 1.0;
    case kConvection:
        return -(T_K - m_options.environment_K);
    default:
        return 0.0;
    }
}

Eigen::VectorXd Problem::integrals(std::size_t a, std::size_t b) const {
    Eigen::VectorXd out(static_cast<Eigen::Index>(m_columns.size()));
    const double dt_s = m_record[b].time_s - m_record[a].time_s;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        double sum = 0.0;
        if (m_columns[c] == kHeating)
            for (std::size_t k = a; k < b; ++k) // also over rows without a reading
                sum += 0.5 * (m_record[k + 1].time_s - m_record[k].time_s) * (heating(k) + heating(k + 1));
        else
            sum = 0.5 * dt_s *
                  (loss(m_columns[c], m_record[a].temperature_K) +
                   loss(m_columns[c], m_record[b].temperature_K));
        out[static_cast<Eigen::Index>(c)] = sum;
    }
    return out;
}

void Problem::close(Window& window, std::vector<Eigen::VectorXd>& rows) {
    if (window.readings.size() >= kMinReadings) {
        const auto n = static_cast<Eigen::Index>(rows.size());
        window.X.resize(n, static_cast<Eigen::Index>(m_columns.size()));
        window.y.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = static_cast<std::size_t>(i);
            window.X.row(i) = rows[k];
            window.y[i] =
                m_record[window.readings[k]].temperature_K - m_record[window.readings.front()].temperature_K;
        }
        m_windows.push_back(std::move(window));
    }
    window = {};
    rows.clear();
}

/// Divides the record into windows; a window ends early if readings are missing or the heating is not known.
void Problem::cut() {
    m_windows.clear();
    Window window;
    std::vector<Eigen::VectorXd> rows;
    for (std::size_t k = 0; k < m_record.size(); ++k) {
        if (!m_used[k])
            continue;
        if (!window.readings.empty()) {
            const std::size_t last = window.readings.back();
            const double gap_s = m_record[k].time_s - m_record[last].time_s;
            const double length_s = m_record[k].time_s - m_record[window.readings.front()].time_s;
            const Eigen::VectorXd row = rows.back() + integrals(last, k);
            if (gap_s > kLargestGap * m_window_s || length_s > m_window_s * (1.0 + 1e-9) || !row.allFinite())
                close(window, rows);
            else
                rows.push_back(row);
        }
        if (window.readings.empty())
            rows.push_back(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(m_columns.size())));
        window.readings.push_back(k);
    }
    close(window, rows);
}

/// Least squares with the windows' means subtracted, which is the same as a fitted T0 for each.
Fit Problem::solve() const {
    const auto p = static_cast<Eigen::Index>(m_columns.size());
    const auto centred = [](const auto& M) { return (M.rowwise() - M.colwise().mean()).eval(); };
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(p, p);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(p);
    Eigen::Index n = 0;
    for (const Window& window : m_windows) {
        const Eigen::MatrixXd X = centred(window.X);
        G += X.transpose() * X;
        g += X.transpose() * window.y;
        n += X.rows();
    }
    Fit fit;
    const Eigen::VectorXd scale = G.diagonal().cwiseSqrt();
    if (!(scale.minCoeff() > 0.0))
        return fit;
    const Eigen::MatrixXd D = scale.cwiseInverse().asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(D * G * D);
    const Eigen::VectorXd& values = eigen.eigenvalues(); // ascending
    if (!(values[0] > values[p - 1] / (kWorstCondition * kWorstCondition)))
        return fit;
    fit.condition = std::sqrt(values[p - 1] / values[0]);
    const Eigen::MatrixXd inverse =
        D * eigen.eigenvectors() * values.cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose() * D;
    fit.parameters = inverse * g;

    double squares = 0.0;
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(p, p);
    for (const Window& window : m_windows) {
        const Eigen::VectorXd r = centred(Eigen::MatrixXd(window.y - window.X * fit.parameters));
        const Eigen::VectorXd score = centred(window.X).transpose() * r;
        squares += r.squaredNorm();
        scatter += score * score.transpose();
    }
    const auto S = static_cast<Eigen::Index>(m_windows.size());
    const double variance =
        squares / static_cast<double>(n - S - p); // windows have more readings than needed
    fit.residual_K = std::sqrt(variance);
    const Eigen::MatrixXd sandwich =
        inverse * scatter * inverse * (static_cast<double>(S) / static_cast<double>(S - p));
    fit.standardErrors = (variance * inverse.diagonal()).cwiseMax(sandwich.diagonal()).cwiseSqrt();
    return fit;
}

/// Excludes readings far from the fit: those at least half as far as the worst, which distorts the fit.
/// Returns false if there is none.
bool Problem::leaveOut(const Fit& fit) {
    std::vector<double> off_K;
    for (const Window& window : m_windows) {
        const Eigen::VectorXd r = window.y - window.X * fit.parameters;
        const double middle = medianOf({r.begin(), r.end()});
        for (const double value : r)
            off_K.push_back(std::abs(value - middle));
    }
    const double limit_K = std::max({kOutlierDeviations * 1.4826 * medianOf(off_K), kMinOutlier_K,
                                     0.5 * *std::ranges::max_element(off_K)});
    const int before = m_outliers;
    std::size_t i = 0;
    for (const Window& window : m_windows)
        for (const std::size_t k : window.readings)
            if (off_K[i++] > limit_K) {
                m_used[k] = false;
                ++m_outliers;
            }
    return m_outliers > before;
}

/// Spread of the view factor without its extremes.
double variation(const std::vector<HeatSample>& record, const std::vector<Window>& windows) {
    std::vector<double> F;
    for (const Window& window : windows)
        for (const std::size_t k : window.readings)
            F.push_back(record[k].viewFactor);
    std::ranges::sort(F);
    return F[F.size() * 95 / 100] - F[F.size() * 5 / 100];
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
    for (const auto& [name, estimate] : rows)
        if (estimate.value <= 0.0)
            return {MessageCode::IdentificationNegative, {name}};
    if (rates.convection.value < -kSurelyNegative * rates.convection.standardError)
        return {MessageCode::IdentificationNegative, {"h'"}};
    return {};
}

void putEstimates(IdentifiedRates& out, const Problem& problem, const Fit& fit,
                  const IdentificationOptions& options) {
    for (std::size_t c = 0; c < problem.columns().size(); ++c) {
        const auto i = static_cast<Eigen::Index>(c);
        const Estimate estimate{fit.parameters[i], fit.standardErrors[i]};
        switch (problem.columns()[c]) {
        case kHeating:
            out.lambda1 = estimate;
            break;
        case kCooling:
            out.lambda2 = estimate;
            break;
        case kRest:
            out.lambda3 = estimate;
            break;
        case kConvection:
            out.convection = estimate;
            break;
        }
    }
    if (!options.freeAmbient) {
        const double rest_K4 = std::pow(options.environment_K, 4) * options.environmentShare;
        out.lambda3 = {out.lambda2.value * rest_K4, out.lambda2.standardError * rest_K4};
    }
}

/// The fit with the given T3; its reason is set if there are no rates.
IdentifiedRates fitted(const std::vector<HeatSample>& record, const IdentificationOptions& options,
                       double& variation_F) {
    Problem problem(record, options);
    Fit fit;
    for (int pass = 0; pass < kPasses; ++pass) {
        problem.cut();
        fit = problem.longEnough() ? problem.solve() : Fit();
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
                       formatNumber(problem.window_s(), 3)}};
        return out;
    }
    variation_F = variation(record, problem.windows());
    const bool heated = std::ranges::any_of(
        problem.windows(), [](const Window& window) { return window.X.col(0).cwiseAbs().maxCoeff() > 0.0; });
    if (!heated)
        out.reason = {MessageCode::IdentificationUnheated, {}};
    else if (fit.parameters.size() == 0)
        out.reason = {MessageCode::IdentificationStill, {formatNumber(variation_F, 2)}};
    else
        putEstimates(out, problem, fit, options);
    return out;
}

/// Adds the effect of the error of T3, from a second fit with T3 changed by it.
void addEnvironmentError(IdentifiedRates& out, const std::vector<HeatSample>& record,
                         IdentificationOptions options) {
    if (!(options.environmentDeviation_K > 0.0))
        return;
    options.environment_K += options.environmentDeviation_K;
    double unused = 0.0;
    const IdentifiedRates off = fitted(record, options, unused);
    const auto add = [](Estimate& estimate, const Estimate& other) {
        estimate.standardError = std::hypot(estimate.standardError, other.value - estimate.value);
    };
    add(out.lambda1, off.lambda1);
    add(out.lambda2, off.lambda2);
    add(out.lambda3, off.lambda3);
    add(out.convection, off.convection);
}

} // namespace

IdentifiedRates identifyRates(const std::vector<HeatSample>& record, const IdentificationOptions& options) {
    double variation_F = 0.0;
    IdentifiedRates out = fitted(record, options, variation_F);
    if (!out.usable())
        return out;
    addEnvironmentError(out, record, options);
    out.reason = verdict(out, variation_F);
    return out;
}

} // namespace bask
