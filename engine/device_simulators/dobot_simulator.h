#pragma once
// A simulated four-axis Dobot arm: its dashboard, motion and feedback ports, and a queue of straight moves
// and frames that an alarm stops and only Continue() starts again.

#include "engine/device_simulators/byte_device.h"
#include "engine/protocols/dobot_messages.h"

#include <deque>

namespace bask {

struct DobotSimulatorConfig {
    DobotPosition start{200.0, 0.0, 50.0, 0.0};
    double fullSpeed_mm_s = 500.0; ///< at 100 %, degrees counted as millimetres
    double reach_mm = 440.0;       ///< a move beyond this ends in an alarm
    bool startsDisabled = false;
    int user = 0, tool = 0;    ///< frames selected earlier; only reported, positions are those of frame 0
    double speedFactor = 1.0;  ///< speed factor set earlier
    double moveDelay_s = 0.02; ///< before a command on the motion port is processed
};

/// Not a ByteDevice itself: it has three, one for each port. A fault can be started at any of them.
class DobotSimulator {
public:
    explicit DobotSimulator(const DobotSimulatorConfig& config = {});

    ByteDevice& dashboard() { return m_dashboard; } ///< 29999
    ByteDevice& motion() { return m_motion; }       ///< 30003
    ByteDevice& feedback() { return m_feedback; }   ///< 30004

    /// Returns "none", "silent", "alarm", "disabled", "paused", "slow-reply", "lost-steps" (it reports that
    /// moves ended, but stands still), "garbage".
    std::vector<std::string> faults() const;
    Result<void> setFault(const std::string& name);

    const DobotPosition& position() const { return m_position; }
    /// Returns the number of moves that are in progress or waiting.
    std::size_t queued() const;
    DobotMode mode() const { return m_mode; }

private:
    class Port final : public ByteDevice {
    public:
        explicit Port(DobotSimulator& arm) : m_arm(arm) {}
        void receive(std::string_view bytes, double now_s) override { m_arm.receive(*this, bytes, now_s); }
        std::string transmit(double now_s) override { return m_arm.transmit(*this, now_s); }
        std::vector<std::string> faults() const override { return m_arm.faults(); }
        Result<void> setFault(const std::string& name) override { return m_arm.setFault(name); }

    private:
        friend class DobotSimulator;
        DobotSimulator& m_arm;
        std::string m_unread, m_said;
    };
    struct Command {
        double time_s;
        std::string text;
    };
    /// A move, or a frame to select.
    struct Queued {
        DobotPosition to{};
        double speed = 1.0;
        double lost = 0.0; ///< part of the way that was not moved
        int* frame = nullptr;
        int index = 0;
    };

    void receive(Port& port, std::string_view bytes, double now_s);
    std::string transmit(Port& port, double now_s);
    void advance(double now_s);
    void move(double dt_s);
    int takeDashboard(const std::string& name, int number, std::string& values);
    void runQueue();
    int takeMotion(const std::string& name, const std::string& arguments);
    void raise(int error);

    DobotSimulatorConfig m_config;
    Port m_dashboard{*this}, m_motion{*this}, m_feedback{*this};
    double m_now_s = 0.0, m_packet_s = 0.0;
    DobotPosition m_position;
    DobotMode m_mode;
    std::deque<Queued> m_queue;
    bool m_isQueueStopped = false;
    int m_user = 0, m_tool = 0;
    double m_speedFactor = 1.0;
    std::deque<Command> m_commands; ///< received on the motion port, not yet processed
    int m_error = 0;
    std::string m_fault = "none";
    int m_spoilt = 0;
};

} // namespace bask
