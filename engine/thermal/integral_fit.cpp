#include "engine/thermal/integral_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

// The fewer windows, the fewer temperatures T0 that are fitted beside the rates, and the more the record
// tells; but what is missing in the balance adds up within a window.
constexpr double kRecordWindows =
    2.0; ///< number of windows of a record, unless they become too long or short
constexpr double kLongestWindow_s = 600.0;
constexpr double kMinWindow_s = 10.0;
constexpr double kWindowPeriods = 10.0;
constexpr std::size_t kMinReadings = 4;     ///< in a window
constexpr double kGapOfRecord = 1.0 / 64.0; ///< largest gap between readings, as a share of the record
constexpr double kLargestGap = 0.25;        ///< or of the shortest window, if that is more
constexpr double kMinStep = 0.02;           ///< of the heating between two rows, from which on a delay shows
constexpr Eigen::Index kBlocks = 8;         ///< of a window's residuals
constexpr double kOutlierDeviations = 6.0;
constexpr double kMinOutlier_K = 0.1; ///< rounding of usual sensors is not an outlier
constexpr double kWorstCondition = 1e6;

double shortestWindow_s(const std::vector<HeatSample>& record) {
    std::vector<double> steps_s;
    for (std::size_t k = 1; k < record.size(); ++k)
        steps_s.push_back(record[k].time_s - record[k - 1].time_s);
    if (steps_s.empty())
        return kMinWindow_s;
    return std::max(kWindowPeriods * medianOf(std::move(steps_s)), kMinWindow_s);
}

double fourth(double T_K) {
    return T_K * T_K * T_K * T_K;
}

double duration_s(const std::vector<HeatSample>& record) {
    return record.empty() ? 0.0 : record.back().time_s - record.front().time_s;
}

} // namespace

double medianOf(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

IntegralProblem::IntegralProblem(const std::vector<HeatSample>& record, const IdentificationOptions& options)
    : m_record(record), m_options(options), m_shortest_s(shortestWindow_s(record)),
      m_window_s(std::max(m_shortest_s, std::min(duration_s(record) / kRecordWindows, kLongestWindow_s))),
      m_largestGap_s(std::max(kGapOfRecord * duration_s(record), kLargestGap * m_shortest_s)) {
    m_columns = {FitColumn::Heating, FitColumn::Cooling};
    if (options.freeAmbient)
        m_columns.push_back(FitColumn::Rest);
    if (options.convection)
        m_columns.push_back(FitColumn::Convection);
    double step = 0.0;
    for (std::size_t k = 1; k < record.size(); ++k)
        step = std::fmax(step, std::abs(heating(k) - heating(k - 1))); // not of an unknown one
    if (step > kMinStep)
        m_columns.push_back(FitColumn::Delay);
    for (const HeatSample& sample : record)
        m_used.push_back(sample.valid && std::isfinite(sample.temperature_K) && sample.temperature_K > 0.0);
}

int IntegralProblem::readings() const {
    int count = 0;
    for (const IntegralWindow& window : m_windows)
        count += static_cast<int>(window.y.size());
    return count;
}

std::size_t IntegralProblem::minWindows() const {
    return 2 * static_cast<std::size_t>(
                   std::ranges::count_if(m_columns, [](FitColumn c) { return c != FitColumn::Delay; }));
}

bool IntegralProblem::longEnough() const {
    double covered_s = 0.0;
    for (const IntegralWindow& window : m_windows)
        covered_s += m_record[window.readings.back()].time_s - m_record[window.readings.front()].time_s;
    return covered_s >= (static_cast<double>(minWindows()) - 1.0) * m_shortest_s;
}

double IntegralProblem::meanHeating(std::size_t k) const {
    const HeatSample& next = m_record[k + 1];
    if (!std::isfinite(next.meanViewFactor))
        return 0.5 * (heating(k) + heating(k + 1));
    return next.meanViewFactor * 0.5 * (m_record[k].sourceStrength + next.sourceStrength);
}

double IntegralProblem::term(FitColumn column, double T_K, double environment_K, double neighbours_K4) const {
    switch (column) {
    case FitColumn::Cooling: {
        const double rest_K4 =
            m_options.freeAmbient ? 0.0 : fourth(environment_K) * m_options.environmentShare;
        AirLoss air = m_options.airPerLambda2;
        air.air_K = environment_K;
        return -(fourth(T_K) - rest_K4 - neighbours_K4 + (m_options.convection ? 0.0 : air.rate_K_s(T_K)));
    }
    case FitColumn::Rest:
        return 1.0;
    case FitColumn::Convection:
        return -(T_K - environment_K);
    default:
        return 0.0;
    }
}

IntegralProblem::Row IntegralProblem::integrals(std::size_t a, std::size_t b) const {
    Row out(static_cast<Eigen::Index>(m_columns.size()));
    const double dt_s = m_record[b].time_s - m_record[a].time_s;
    for (std::size_t c = 0; c < m_columns.size(); ++c) {
        double sum = 0.0;
        if (m_columns[c] == FitColumn::Heating)
            for (std::size_t k = a; k < b; ++k) // also over rows without a reading
                sum += (m_record[k + 1].time_s - m_record[k].time_s) * meanHeating(k);
        else if (m_columns[c] == FitColumn::Delay)
            sum = heating(b) - heating(a);
        else
            sum = 0.5 * dt_s *
                  (term(m_columns[c], m_record[a].temperature_K, m_options.environment_K,
                        m_record[a].neighbours_K4) +
                   term(m_columns[c], m_record[b].temperature_K, m_options.environment_K,
                        m_record[b].neighbours_K4));
        out[static_cast<Eigen::Index>(c)] = sum;
    }
    return out;
}

void IntegralProblem::close(IntegralWindow& window, std::vector<Row>& rows) {
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

void IntegralProblem::cut() {
    m_windows.clear();
    IntegralWindow window;
    std::vector<Row> rows;
    for (std::size_t k = 0; k < m_record.size(); ++k) {
        if (!m_used[k])
            continue;
        if (!window.readings.empty()) {
            const std::size_t last = window.readings.back();
            const double gap_s = m_record[k].time_s - m_record[last].time_s;
            const double length_s = m_record[k].time_s - m_record[window.readings.front()].time_s;
            const Row row = rows.back() + integrals(last, k);
            if (gap_s > m_largestGap_s || length_s > m_window_s * (1.0 + 1e-9) || !row.allFinite())
                close(window, rows);
            else
                rows.push_back(row);
        }
        if (window.readings.empty())
            rows.push_back(Row::Zero(static_cast<Eigen::Index>(m_columns.size())));
        window.readings.push_back(k);
    }
    close(window, rows);
}

IntegralFit IntegralProblem::solve() const {
    const auto p = static_cast<Eigen::Index>(m_columns.size());
    const auto centred = [](const auto& M) { return (M.rowwise() - M.colwise().mean()).eval(); };
    Eigen::MatrixXd G = Eigen::MatrixXd::Zero(p, p);
    Eigen::VectorXd g = Eigen::VectorXd::Zero(p);
    Eigen::Index n = 0;
    for (const IntegralWindow& window : m_windows) {
        const Eigen::MatrixXd X = centred(window.X);
        G += X.transpose() * X;
        g += X.transpose() * window.y;
        n += X.rows();
    }
    IntegralFit fit;
    const auto S = static_cast<Eigen::Index>(m_windows.size());
    const Eigen::VectorXd scale = G.diagonal().cwiseSqrt();
    if (n <= S + p || !(scale.minCoeff() > 0.0))
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

    double squares = 0.0, slow = 0.0;
    int blocks = 0;
    for (const IntegralWindow& window : m_windows) {
        const Eigen::VectorXd r = centred(Eigen::MatrixXd(window.y - window.X * fit.parameters));
        squares += r.squaredNorm();
        const Eigen::Index count = std::min(kBlocks, r.size());
        for (Eigen::Index k = 0; k < count; ++k, ++blocks) {
            const Eigen::Index from = k * r.size() / count, to = (k + 1) * r.size() / count;
            slow += std::pow(r.segment(from, to - from).mean(), 2);
        }
    }
    fit.residual_K = std::sqrt(squares / static_cast<double>(n - S - p));
    fit.slowResidual_K = std::sqrt(slow / blocks);
    return fit;
}

bool IntegralProblem::leaveOut(const IntegralFit& fit) {
    std::vector<double> off_K;
    for (const IntegralWindow& window : m_windows) {
        const Eigen::VectorXd r = window.y - window.X * fit.parameters;
        const double middle = medianOf({r.begin(), r.end()});
        for (const double value : r)
            off_K.push_back(std::abs(value - middle));
    }
    const double limit_K = std::max({kOutlierDeviations * 1.4826 * medianOf(off_K), kMinOutlier_K,
                                     0.5 * *std::ranges::max_element(off_K)});
    const int before = m_outliers;
    std::size_t i = 0;
    for (const IntegralWindow& window : m_windows)
        for (const std::size_t k : window.readings)
            if (off_K[i++] > limit_K) {
                m_used[k] = false;
                ++m_outliers;
            }
    return m_outliers > before;
}

} // namespace bask
