#pragma once
// The readings of the last seconds: their rate, and whether they tell of heating or cooling beyond noise.

#include <deque>
#include <optional>

namespace bask {

class ReadingTrend {
public:
    static constexpr double kOver_s = 10.0;

    void clear() { *this = {}; }
    /// Forgets what is older than kOver_s; everything if the time has gone back: it is another clock.
    void passTo(double time_s);
    /// Takes a reading that is newer than the last; `rate_K_s` is an estimate of its rate, NaN without one.
    void add(double time_s, double reading_K, double rate_K_s);

    double meanRate_K_s() const; ///< of the estimates; NaN if there is none, and in the first 4 s
    double slope_K_s() const;    ///< of the readings; NaN with fewer than 3
    /// Returns the slope where it is beyond noise: 2.5 of its standard errors, by the scatter of the
    /// readings, at least that of readings rounded to 0.1 K, and more than one step of 0.1 K makes. 0:
    /// neither heating nor cooling is told, nor by readings of less than 4 s, nor against meanRate_K_s().
    double told_K_s() const;

private:
    struct Reading {
        double time_s, reading_K, rate_K_s;
    };
    struct Line {
        double slope_K_s, scatter_K, spread_s; ///< spread_s: root of the sum of squared times
    };
    Line fitted() const;

    std::deque<Reading> m_readings;
    std::optional<double> m_begin_s; ///< of the first reading since clear()
};

} // namespace bask
