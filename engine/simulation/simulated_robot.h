#pragma once
// A position-stepping robot: moves in steps of its resolution, respects its own limits, obeys with a delay,
// ramps to a new velocity, and stops if its velocity is not renewed.

#include "engine/base/clock.h"
#include "engine/devices/robot.h"

#include <array>
#include <deque>

namespace bask {

/// Its mechanics.
struct SimulatedRobotConfig {
    std::array<bool, 6> free{};
    Vector6d lower = Vector6d::Zero();
    Vector6d upper = Vector6d::Zero();
    double maxSpeed_m_s = 0.02;
    double maxRotation_rad_s = 0.1;
    double maxAcceleration_m_s2 = 0.0; ///< 0: takes a velocity at once
    double maxAngularAcceleration_rad_s2 = 0.0;
    double step_m = 0.0; ///< 0: continuous
    double step_rad = 0.0;
    Vector6d start = Vector6d::Zero();
    double latency_s = 0.0; ///< delay until a command takes effect, also halt
};

/// The faults of a simulated robot.
enum class RobotTrouble {
    None,
    LinkLost,
    Alarm,
    Restarted, ///< stands, and is not sure of its position
    Slow       ///< reports nothing new, and obeys kSlow_s late
};

class SimulatedRobot final : public Robot {
public:
    SimulatedRobot(const SimulatedRobotConfig& config, const Clock& clock);

    Result<RobotState> state() override;
    Result<void> setTwist(const Vector6d& twist, double validFor_s) override;
    Result<void> halt() override;
    Result<void> home() override; ///< at its present position
    Result<void> clearAlarm() override;

    /// Moves for dt_s of the clock's time.
    void advance(double dt_s);
    /// Returns its true position: the steps that its motors have made.
    Vector6d coordinates() const;
    /// Puts it there, within its limits; fixed coordinates stay.
    void placeAt(const Vector6d& coordinates);
    void setLinkLost(bool lost) { m_trouble = lost ? RobotTrouble::LinkLost : RobotTrouble::None; }
    /// An alarm, and an unsure position, last until they are cleared or another fault is set.
    void setTrouble(RobotTrouble trouble);
    RobotTrouble trouble() const { return m_trouble; }

    static constexpr double kSlow_s = 5.0;

private:
    struct Order {
        double time_s; ///< when it takes effect
        Vector6d twist;
        double validFor_s;
    };
    void give(const Vector6d& twist, double validFor_s);
    void obey(double now_s);
    /// Moves for dt_s towards the rates `wanted`; all coordinates ramp together.
    void ramp(const Vector6d& wanted, double dt_s);

    SimulatedRobotConfig m_config;
    const Clock& m_clock;
    Vector6d m_exact;                     ///< continuous position that the steps follow
    Vector6d m_wanted = Vector6d::Zero(); ///< last commanded rates
    Vector6d m_rates = Vector6d::Zero();  ///< present rates
    double m_expires_s = 0.0;
    std::deque<Order> m_orders; ///< not yet in effect
    RobotTrouble m_trouble = RobotTrouble::None;
    RobotState m_told; ///< last reported
};

} // namespace bask
