// No line whose target was not approved ever goes to a Grbl robot, whatever is asked of the driver and
// whatever the controller and its cable do.

#include "engine/base/units.h"
#include "tests/engine/drivers/robot_on_simulator.h"

#include <array>
#include <cmath>
#include <random>

namespace bask::test {
namespace {

constexpr int kActions = 100'000;
const std::vector<AxisSpec> kAxes{
    {'X', 0, true, 0.01}, {'Y', 1, false, 0.0}, {'Z', 2, false, 0.12}, {'A', 3, false, radFromDeg(5.0)}};

/// A box, and an object of 6 cm that tilts above the source's plane.
bool isInside(const Vector6d& q, double slack = 0.0) {
    const bool isInBox = std::abs(q[0]) <= 0.05 + slack && std::abs(q[1]) <= 0.03 + slack &&
                         q[2] <= 0.2 + slack && std::abs(q[3]) <= 0.6 + slack;
    return isInBox && q[2] - 0.03 * std::abs(std::sin(q[3])) >= 0.02 - slack;
}

/// Read apart from the driver's own code: the numbers of `$J=G21G90G53X..Y..Z..A..F..`.
std::vector<double> numbersIn(const std::string& line) {
    std::array<double, 5> n{};
    int end = 0;
    const int count = std::sscanf(line.c_str(), "$J=G21G90G53X%lfY%lfZ%lfA%lfF%lf%n", &n[0], &n[1], &n[2],
                                  &n[3], &n[4], &end);
    if (count != 5 || static_cast<std::size_t>(end) != line.size())
        return {};
    return {n.begin(), n.end()};
}

class GrblBoundsTest : public RobotOnSimulator {
protected:
    void start(bool isHal) {
        GrblSimulatorConfig config;
        config.isHal = isHal;
        config.startsLocked = false;
        m_guard = [](const Vector6d& target) { return isInside(target); };
        make(config, false, kAxes);
        run(1.0);
        clear();
    }
    double uniform(double a, double b) { return std::uniform_real_distribution(a, b)(m_random); }
    int upTo(int n) { return std::uniform_int_distribution(0, n)(m_random); }

    void askForMotion() {
        Vector6d twist;
        for (int k = 0; k < 6; ++k)
            twist[k] = upTo(3) == 0 ? 0.0 : uniform(-1.0, 1.0) * (k < 3 ? 0.03 : 0.3);
        (void)m_robot->setTwist(twist, std::pow(10.0, uniform(-2.0, 1.0)));
    }
    void faultSomething(const std::vector<std::string>& names) {
        ASSERT_TRUE(
            m_device->setFault(names[static_cast<std::size_t>(upTo(static_cast<int>(names.size()) - 1))]));
    }
    /// Somebody at the robot's own panel.
    void press(const std::vector<std::string>& keys) {
        m_device->receive(keys[static_cast<std::size_t>(upTo(static_cast<int>(keys.size()) - 1))],
                          m_clock.now_s());
    }
    void cable() {
        if (upTo(1) == 0)
            m_link->unplug();
        run(uniform(0.0, 1.0));
        m_link->plug();
        m_link->setDelay(upTo(2) == 0 ? uniform(0.0, 0.05) : 0.0);
    }
    void checkLines() {
        const AxisMap map(kAxes, Vector6d::Zero());
        for (const std::string& line : linesIn(m_link->takeSent(), "$J")) {
            ++m_lines;
            const std::vector<double> n = numbersIn(line);
            ASSERT_EQ(n.size(), 5U) << line;
            ASSERT_TRUE(isInside(map.coordinates({n[0], n[1], n[2], n[3]}))) << line;
            ASSERT_GT(n[4], 0.0) << line;
        }
    }

    std::mt19937 m_random{20240607};
    int m_lines = 0;
};

// Everything at once: lies in the controller's name, too.
TEST_F(GrblBoundsTest, NoTargetIsOutsideWhateverHappens) {
    const std::vector<std::string> lies{"ok\r\n",
                                        "error:9\r\n",
                                        "ALARM:1\r\n",
                                        "<Idle|MPos:999.000,0.000,0.000,0.000>\r\n",
                                        "<Idle|MPos:-20.000,10.000,-60.000,20.000>\r\n",
                                        "<Jog|MPos:1.000,1.000,1.000,1.000>\r\n",
                                        "<Hold:0|MPos:0,0,0,0>\r\n",
                                        "<Idle|WPos:0,0,0,0|WCO:1e9,0,0,0>\r\n",
                                        "<Idle|MPos:99999999999,0,0,0>\r\n",
                                        "\r\nGrbl 1.1h ['$' for help]\r\n",
                                        "[GC:G0]\r\nok\r\n",
                                        "$13=0\r\nok\r\n",
                                        "\x01\xff<>",
                                        "<Idle|MPos:"};
    start(true);
    for (int i = 0; i < kActions && !HasFatalFailure(); ++i) {
        const int action = upTo(999);
        if (action < 500)
            askForMotion();
        else if (action < 560)
            (void)m_robot->halt();
        else if (action < 640)
            (void)m_robot->clearAlarm();
        else if (action < 645)
            (void)m_robot->home();
        else if (action < 650)
            faultSomething(m_device->faults());
        else if (action < 660)
            faultSomething({"none"});
        else if (action < 664)
            press({"!", "~", "\x18", "\x84", "\x85", "$X\n", "$J=G91X1F600\n", "G1 X3 F300\n"});
        else if (action < 670)
            m_link->inject(lies[static_cast<std::size_t>(upTo(static_cast<int>(lies.size()) - 1))]);
        else if (action < 672)
            cable();
        run(uniform(0.0, 0.15));
        checkLines();
    }
    EXPECT_GT(m_lines, 2000);
    RecordProperty("lines", m_lines);
}

// A controller that does not lie: the robot itself stays inside, and no second step is ever begun before the
// first is over.
TEST_F(GrblBoundsTest, TheRobotStaysInsideAndMakesOneStepAtATime) {
    const AxisMap map(kAxes, Vector6d::Zero());
    for (const bool isHal : {false, true}) {
        start(isHal);
        std::size_t moved = 0;
        for (int i = 0; i < kActions / 2 && !HasFatalFailure(); ++i) {
            const int action = upTo(999);
            if (action < 500)
                askForMotion();
            else if (action < 560)
                (void)m_robot->halt();
            else if (action < 640)
                (void)m_robot->clearAlarm();
            else if (action < 643)
                faultSomething({"silent", "door", "slow-ok", "lost-steps", "garbage"});
            else if (action < 663)
                faultSomething({"none"});
            else if (action < 669)
                press({"!", "~", "~", "\x85"});
            else if (action < 671)
                cable();
            run(uniform(0.0, 0.15));
            checkLines();
            ASSERT_LE(m_device->queued(), 1U);
            ASSERT_TRUE(isInside(map.coordinates(m_device->positions()), 2e-5));
            moved += m_device->queued();
        }
        EXPECT_GT(moved, 2000U);
    }
    EXPECT_GT(m_lines, 10'000);
    RecordProperty("lines", m_lines);
}

} // namespace
} // namespace bask::test
