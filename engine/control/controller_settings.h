#pragma once
// Which controller runs, and its gains, as values.

namespace bask {

enum class ControllerKind { LevelServo, ModelBased, Adaptive };
const char* controllerKindName(ControllerKind kind); ///< "level-servo", "model-based", "adaptive"

/// Outer loop of Bask's own level servo.
struct LevelServoGains {
    double timeConstant_s = 8.0;  ///< tau_c: wanted rate = error / tau_c
    double integralTime_s = 60.0; ///< of the slow integral action near the target
    bool operator==(const LevelServoGains&) const = default;
};

/// Paper, model-based: dv/dt = -D v - K dtau.
struct ModelBasedGains {
    double D = 0.2;  ///< 1/s
    double K = 0.05; ///< 1/s2
    bool operator==(const ModelBasedGains&) const = default;
};

/// Paper, adaptive: zeta = v + mu dtau.
struct AdaptiveGains {
    double mu = 0.05;
    double K = 0.15;
    double gamma1 = 0.005;
    double gamma2 = 1e-22;
    bool operator==(const AdaptiveGains&) const = default;
};

/// Controller and gains of all three kinds, so that switching loses nothing.
struct ControllerSettings {
    ControllerKind kind = ControllerKind::LevelServo;
    LevelServoGains levelServo;
    ModelBasedGains modelBased;
    AdaptiveGains adaptive;
    double rotationLength_m = 0.10; ///< makes radians and metres compare
    double damping = 1e-3;          ///< of the damped least squares, relative to the largest singular value
    double believedRateErrorFactor =
        1.0; ///< >= 1: believed rates start wrong by seeded random factors in [1/f, f]
    bool operator==(const ControllerSettings&) const = default;
};

} // namespace bask
