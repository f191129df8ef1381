#pragma once
// A Grbl robot's driver with the simulated robot at its end, on a clock turned by hand.

#include "engine/device_simulators/grbl_simulator.h"
#include "engine/drivers/grbl_robot.h"
#include "tests/engine/drivers/test_links.h"

#include <gtest/gtest.h>

#include <memory>

namespace bask::test {

inline const std::vector<AxisSpec> kFourAxes{
    {'X', 0, false, 0.0}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.0}, {'A', 3, false, 0.0}};

inline std::vector<std::string> linesIn(const std::string& sent, const std::string& start) {
    std::vector<std::string> out;
    for (std::size_t at = sent.find(start); at != std::string::npos; at = sent.find(start, at + 1))
        out.push_back(sent.substr(at, sent.find('\n', at) - at));
    return out;
}

class RobotOnSimulator : public testing::Test {
protected:
    static constexpr double kTick_s = 0.005;

    void make(const GrblSimulatorConfig& config, std::optional<bool> mustHome = false,
              std::vector<AxisSpec> axes = kFourAxes) {
        m_robot.reset();
        m_device = std::make_unique<GrblSimulator>(config);
        m_link = std::make_unique<DeviceLink>(*m_device, m_clock);
        m_robot = std::make_unique<GrblRobot>(
            *m_link, m_clock, AxisMap(std::move(axes), Vector6d::Zero()),
            [this](const Vector6d& target) { return m_guard(target); }, mustHome);
    }
    /// Its place is confirmed where that is enough.
    void makeLive(const GrblSimulatorConfig& config = {}, std::optional<bool> mustHome = false) {
        make(config, mustHome);
        run(1.0);
        ASSERT_EQ(m_robot->status().link, LinkState::Live) << describe(m_robot->status().problem);
        if (alarm() == MessageCode::RobotPlaceUnsure)
            (void)m_robot->clearAlarm();
        run(0.3); // and marked
        m_link->takeSent();
    }
    void run(double time_s) {
        for (const double end_s = m_clock.now_s() + time_s; m_clock.now_s() < end_s - 1e-9;) {
            m_clock.advance(kTick_s);
            m_robot->work();
        }
    }
    /// As the servo loop does: 10 times a second, valid for one and a half periods. False: refused at last.
    bool drive(const Vector6d& twist, double time_s) {
        bool isTaken = false;
        for (double t = 0.0; t < time_s - 1e-9; t += 0.1) {
            isTaken = m_robot->setTwist(twist, 0.15).ok();
            run(0.1);
        }
        return isTaken;
    }
    MessageCode alarm() {
        const auto state = m_robot->state();
        return state ? state->alarm.code : state.error().code();
    }
    void clear() { EXPECT_TRUE(m_robot->clearAlarm()); }
    double x_mm() const { return m_device->positions()[0]; }

    ManualClock m_clock;
    MotionGuard m_guard = [](const Vector6d&) { return true; };
    std::unique_ptr<GrblSimulator> m_device;
    std::unique_ptr<DeviceLink> m_link;
    std::unique_ptr<GrblRobot> m_robot;
    const Vector6d m_right = (Vector6d() << 0.005, 0, 0, 0, 0, 0).finished(); ///< 5 mm/s
};

} // namespace bask::test
