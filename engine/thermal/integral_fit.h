#pragma once
// Linear least squares for the integral of the heat balance over windows of a record.

#include "engine/thermal/identification.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace bask {

/// What is fitted. Delay is lambda1 times the time (s) by which the readings come before what the recorded
/// view factors say, negative for those that come after: the lag of a sensor, the latency of a robot.
enum class FitColumn { Heating, Cooling, Rest, Convection, Delay };

struct IntegralFit {
    Eigen::VectorXd parameters;  ///< one for each column; empty if they cannot be told apart
    double residual_K = 0.0;     ///< standard deviation of the readings about the fit
    double slowResidual_K = 0.0; ///< root mean square of the residuals' means over short blocks
    double condition = std::numeric_limits<double>::infinity();
};

/// Returns the upper of two middle values if there are two; `values` must not be empty.
double medianOf(std::vector<double> values);

/// Readings of one window with the integrals since its first.
struct IntegralWindow {
    std::vector<std::size_t> readings; ///< indices into the record
    Eigen::MatrixXd X;                 ///< one row a reading, one column a parameter
    Eigen::VectorXd y;                 ///< temperatures above the window's first, K
};

/// A record as a linear problem. Keeps a reference to the record.
class IntegralProblem {
public:
    IntegralProblem(const std::vector<HeatSample>& record, const IdentificationOptions& options);

    const std::vector<FitColumn>& columns() const { return m_columns; }
    const std::vector<IntegralWindow>& windows() const { return m_windows; }
    double shortest_s() const { return m_shortest_s; } ///< a record needs minWindows() times this
    double window_s() const { return m_window_s; }
    int outliers() const { return m_outliers; }
    int readings() const;
    bool longEnough() const;
    /// Twice the number of rates.
    std::size_t minWindows() const;
    /// Which rows hold a reading that is used.
    const std::vector<bool>& used() const { return m_used; }
    void use(const std::vector<bool>& used) { m_used = used; }

    /// Divides the record into windows; a window ends early if readings are missing or the heating is not
    /// known.
    void cut();
    /// Least squares with the windows' means subtracted, which is the same as a fitted T0 for each.
    IntegralFit solve() const;
    /// Excludes readings far from the fit: those at least half as far as the worst, which distorts the fit.
    /// Returns false if there is none.
    bool leaveOut(const IntegralFit& fit);

    /// Returns s F of a row.
    double heating(std::size_t k) const { return m_record[k].viewFactor * m_record[k].sourceStrength; }
    /// Returns the mean of s F between row k and the next.
    double meanHeating(std::size_t k) const;
    /// Returns the term that a column's rate is multiplied by, but for Heating and Delay, at this
    /// temperature, with this room and what neighbours add to its T^4, 1, K or K4.
    double term(FitColumn column, double T_K, double environment_K, double neighbours_K4) const;

private:
    using Row = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>; ///< one entry for each column

    /// One integral for each column, from reading a to reading b; not finite if the heating between them is
    /// not known.
    Row integrals(std::size_t a, std::size_t b) const;
    void close(IntegralWindow& window, std::vector<Row>& rows);

    const std::vector<HeatSample>& m_record;
    IdentificationOptions m_options;
    std::vector<FitColumn> m_columns;
    std::vector<bool> m_used;
    double m_shortest_s, m_window_s, m_largestGap_s;
    std::vector<IntegralWindow> m_windows;
    int m_outliers = 0;
};

} // namespace bask
