#include "engine/control/controller_settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bask {

NaturalGains naturalGains(const ModelBasedGains& gains) {
    const double frequency = std::sqrt(gains.K);
    return {frequency, 0.5 * gains.D / frequency};
}

ModelBasedGains gainsFromNatural(const NaturalGains& gains) {
    return {2.0 * gains.damping * gains.frequency_rad_s, gains.frequency_rad_s * gains.frequency_rad_s};
}

double errorAfterStep(const ModelBasedGains& gains, double t_s) {
    const double a = 0.5 * gains.D;
    const double square = gains.K - a * a; // of the damped frequency
    const double w = std::sqrt(std::abs(square));
    const double x = w * t_s;
    if (x < 1e-6) // also critical damping: sin x / w = t
        return std::exp(-a * t_s) * (1.0 + a * t_s);
    if (square > 0.0)
        return std::exp(-a * t_s) * (std::cos(x) + a / w * std::sin(x));
    // The two exponentials separately, since cosh would overflow.
    return 0.5 * ((1.0 + a / w) * std::exp((w - a) * t_s) + (1.0 - a / w) * std::exp((-w - a) * t_s));
}

StepPrediction predictStep(const ModelBasedGains& gains, double step_K, double band_K) {
    const double band = band_K / std::abs(step_K);
    const double a = 0.5 * gains.D;
    const double square = gains.K - a * a;
    StepPrediction out;
    double from_s = 0.0, to_s = 0.0; // between them |e| falls below the band for good
    double sign = 1.0;
    if (square > 0.0) {
        const double half_s = std::numbers::pi / std::sqrt(square); // between two extremes of e
        out.overshoot = std::exp(-a * half_s);
        if (gains.D <= 0.0) {
            out.settling_s = std::numeric_limits<double>::infinity();
            return out;
        }
        const double last = std::floor(std::max(0.0, -std::log(band) / (a * half_s)));
        from_s = last * half_s;
        to_s = from_s + half_s;
        sign = std::fmod(last, 2.0) == 0.0 ? 1.0 : -1.0;
    } else {
        to_s = 1.0 / a;
        while (errorAfterStep(gains, to_s) > band)
            to_s *= 2.0;
    }
    if (band >= 1.0)
        return out;
    for (int i = 0; i < 60; ++i) {
        const double middle_s = 0.5 * (from_s + to_s);
        (sign * errorAfterStep(gains, middle_s) > band ? from_s : to_s) = middle_s;
    }
    out.settling_s = to_s;
    return out;
}

double predictSettling_s(const AdaptiveGains& gains, double step_K, double band_K) {
    return std::max(0.0, std::log(std::abs(step_K) / band_K) / gains.mu);
}

} // namespace bask
