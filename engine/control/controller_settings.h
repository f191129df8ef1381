#pragma once
// Which controller runs, and its gains, as values.

#include "engine/base/named_values.h"

#include <map>
#include <string>
#include <string_view>

namespace bask {

/// Says which controller is meant, by its key in files. controllerCatalogue() lists them all; named here are
/// those that Bask's own studies and the paper's experiments ask for.
class ControllerKind {
public:
    // NOLINTNEXTLINE(readability-identifier-naming): used like enumerators
    static const ControllerKind LevelServo, ModelBased, Adaptive;

    explicit constexpr ControllerKind(const char* key) : m_key(key) {} ///< `key`: a literal
    constexpr const char* key() const { return m_key; }                ///< "level-servo"
    friend constexpr bool operator==(const ControllerKind& a, const ControllerKind& b) {
        return std::string_view(a.m_key) == b.m_key;
    }

private:
    const char* m_key;
};
inline constexpr ControllerKind ControllerKind::LevelServo{"level-servo"};
inline constexpr ControllerKind ControllerKind::ModelBased{"model-based"};
inline constexpr ControllerKind ControllerKind::Adaptive{"adaptive"};

/// Outer loop of Bask's own level servo.
struct LevelServoGains {
    double timeConstant_s = 8.0;  ///< tau_c: demanded rate = error / tau_c
    double integralTime_s = 60.0; ///< of the slow integral action near the target
    bool operator==(const LevelServoGains&) const = default;
};

/// Paper, model-based: dv/dt = -D v - K dtau.
struct ModelBasedGains {
    double D = 0.2;  ///< 1/s
    double K = 0.05; ///< 1/s2
    bool operator==(const ModelBasedGains&) const = default;
};

/// The same law given by a frequency and a damping ratio: D = 2 damping frequency, K = frequency^2.
struct NaturalGains {
    double frequency_rad_s = 0.0;
    double damping = 0.0; ///< 1: critical
};
NaturalGains naturalGains(const ModelBasedGains& gains);
ModelBasedGains gainsFromNatural(const NaturalGains& gains);

/// Returns the error t seconds after a step of the target at rest, as a fraction of the step: the analytic
/// solution of d2e/dt2 = -D de/dt - K e without limits, noise or delay.
double errorAfterStep(const ModelBasedGains& gains, double t_s);

/// Prediction of errorAfterStep for a step of step_K.
struct StepPrediction {
    double overshoot = 0.0;  ///< fraction of the step
    double settling_s = 0.0; ///< until the error stays within +-band_K; infinite without damping
};
StepPrediction predictStep(const ModelBasedGains& gains, double step_K, double band_K);

/// Paper, adaptive: zeta = v + mu dtau.
struct AdaptiveGains {
    double mu = 0.05;
    double K = 0.15;
    double gamma1 = 0.005;
    double gamma2 = 1e-22;
    bool operator==(const AdaptiveGains&) const = default;
};

/// Returns the time until the error is within +-band_K once zeta is zero; it then decays as exp(-mu t)
/// without overshoot. This is the behaviour of the adapted law, and its minimum settling time.
double predictSettling_s(const AdaptiveGains& gains, double step_K, double band_K);

/// The selected controller and the gains of all kinds, so that switching loses nothing.
struct ControllerSettings {
    ControllerKind kind = ControllerKind::LevelServo;
    LevelServoGains levelServo;
    ModelBasedGains modelBased;
    AdaptiveGains adaptive;
    /// Gains of further controllers in SI, by the group of their entry in the catalogue. A missing gain has
    /// its default.
    std::map<std::string, NamedValues> own{};
    /// Length that counts as one radian when rotations and translations are combined.
    double rotationLength_m = 0.10;
    double damping = 1e-3; ///< of the damped least squares, relative to the largest singular value
    double estimatedRateErrorFactor =
        1.0; ///< >= 1: estimated rates start with random errors: seeded factors in [1/f, f]
    bool operator==(const ControllerSettings&) const = default;
};

} // namespace bask
