#include "engine/device_simulators/dobot_simulator.h"

#include "engine/base/message_code.h"
#include "engine/device_simulators/fault_names.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace bask {
namespace {

constexpr double kPeriod_s = 0.008; // of the packets
constexpr double kPlannerStep_s = 0.001;
constexpr double kSlowAnswer_s = 3.0; // "slow-reply"
constexpr int kOutOfReach = 17, kCollision = 22;
constexpr int kUnknown = -10000, kCount = -20000, kType = -30001, kNotDone = -1;

std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

} // namespace

DobotSimulator::DobotSimulator(const DobotSimulatorConfig& config)
    : m_config(config), m_position(config.start),
      m_mode(config.startsDisabled ? DobotMode::Disabled : DobotMode::Idle), m_user(config.user),
      m_tool(config.tool), m_speedFactor(config.speedFactor) {}

std::vector<std::string> DobotSimulator::faults() const {
    return {"none", "silent", "alarm", "disabled", "paused", "slow-reply", "lost-steps", "garbage"};
}

Result<void> DobotSimulator::setFault(const std::string& name) {
    if (const auto known = checkFault(name, faults()); !known)
        return known;
    m_fault = name;
    if (name == "alarm")
        raise(kCollision);
    if (name == "disabled") {
        m_queue.clear();
        m_mode = DobotMode::Disabled;
    }
    if (name == "paused" && (m_mode == DobotMode::Idle || m_mode == DobotMode::Running))
        m_mode = DobotMode::Paused;
    return {};
}

void DobotSimulator::raise(int error) {
    m_isQueueStopped = true; // what is in it waits
    m_mode = DobotMode::Error;
    m_error = error;
}

// --- Ports ---

void DobotSimulator::receive(Port& port, std::string_view bytes, double now_s) {
    advance(now_s);
    port.m_unread += bytes;
    for (std::size_t end = 0; (end = port.m_unread.find(')')) != std::string::npos;) {
        const std::string text = port.m_unread.substr(0, end + 1);
        port.m_unread.erase(0, end + 1);
        if (&port == &m_motion) {
            m_commands.push_back(
                {m_now_s + (m_fault == "slow-reply" ? kSlowAnswer_s : m_config.moveDelay_s), text});
        } else if (&port == &m_dashboard) {
            std::string values;
            const std::size_t bracket = text.find('(');
            const int error = takeDashboard(inSmallLetters(text.substr(0, bracket)),
                                            std::atoi(text.c_str() + bracket + 1), values);
            port.m_said += std::to_string(error) + ",{" + values + "}," + text + ";";
        }
    }
}

std::string DobotSimulator::transmit(Port& port, double now_s) {
    advance(now_s);
    std::string out = std::exchange(port.m_said, {});
    if (m_fault == "silent")
        return {};
    if (m_fault == "garbage" && !out.empty() && ++m_spoilt % 5 == 0)
        out.erase(out.size() / 2, 1);
    return out;
}

int DobotSimulator::takeDashboard(const std::string& name, int number, std::string& values) {
    if (name == "enablerobot") {
        if (m_mode == DobotMode::Error)
            return kNotDone;
        m_mode = DobotMode::Idle;
        runQueue();
    } else if (name == "disablerobot") {
        m_queue.clear();
        m_mode = DobotMode::Disabled;
    } else if (name == "clearerror") {
        if (m_mode == DobotMode::Error)
            m_mode = DobotMode::Disabled;
        m_error = 0;
    } else if (name == "resetrobot") {
        m_queue.clear(); // what is still on its way on the other port is not stopped
        if (m_mode != DobotMode::Error && m_mode != DobotMode::Disabled)
            m_mode = DobotMode::Idle;
    } else if (name == "robotmode") {
        values = std::to_string(static_cast<std::uint64_t>(m_mode));
    } else if (name == "geterrorid") {
        values = "[\n\t[" + (m_error == 0 ? std::string() : std::to_string(m_error)) +
                 "],\n\t[],\n\t[],\n\t[],\n\t[]\n]\n";
    } else if (name == "continue") {
        if (m_mode == DobotMode::Error || m_mode == DobotMode::Disabled)
            return kNotDone;
        m_isQueueStopped = false;
        if (m_mode == DobotMode::Paused)
            m_mode = DobotMode::Idle;
        runQueue();
    } else if (name == "user" || name == "tool") { // taken, though a disabled arm does not carry it out
        if (m_mode == DobotMode::Idle || m_mode == DobotMode::Running)
            m_queue.push_back({{}, 1.0, 0.0, name == "user" ? &m_user : &m_tool, number});
        runQueue();
    } else if (name == "speedfactor") {
        m_speedFactor = 0.01 * number;
    } else {
        return kUnknown;
    }
    return 0;
}

int DobotSimulator::takeMotion(const std::string& name, const std::string& arguments) {
    if (name != "movl")
        return kUnknown;
    Queued move;
    std::size_t count = 0;
    for (std::size_t from = 0; from < arguments.size(); ++count) {
        const std::size_t to = std::min(arguments.find(',', from), arguments.size());
        std::string word = inSmallLetters(arguments.substr(from, to - from));
        const bool isSpeed = word.starts_with("speedl=");
        word.erase(0, word.find('=') == std::string::npos ? 0 : word.find('=') + 1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || end != word.data() + word.size())
            return kType;
        if (count < move.to.size())
            move.to[count] = value;
        else if (isSpeed)
            move.speed = value / 100.0;
        from = to + 1;
    }
    if (count < move.to.size())
        return kCount;
    if (m_mode != DobotMode::Idle && m_mode != DobotMode::Running)
        return kNotDone;
    if (std::hypot(move.to[0], move.to[1]) > m_config.reach_mm) {
        raise(kOutOfReach);
        return 0;
    }
    m_queue.push_back(move);
    runQueue();
    return 0;
}

std::size_t DobotSimulator::queued() const {
    return static_cast<std::size_t>(std::ranges::count(m_queue, nullptr, &Queued::frame));
}

/// It runs while there is a move to make.
void DobotSimulator::runQueue() {
    if (m_isQueueStopped || (m_mode != DobotMode::Idle && m_mode != DobotMode::Running))
        return;
    for (; !m_queue.empty() && m_queue.front().frame != nullptr; m_queue.pop_front())
        *m_queue.front().frame = m_queue.front().index;
    m_mode = m_queue.empty() ? DobotMode::Idle : DobotMode::Running;
}

// --- Time ---

void DobotSimulator::advance(double now_s) {
    while (m_now_s < now_s) {
        while (!m_commands.empty() && m_commands.front().time_s <= m_now_s) {
            const std::string text = m_commands.front().text;
            m_commands.pop_front();
            const std::size_t bracket = text.find('(');
            const int error = takeMotion(inSmallLetters(text.substr(0, bracket)),
                                         text.substr(bracket + 1, text.size() - bracket - 2));
            m_motion.m_said += std::to_string(error) + ",{}," + text + ";";
        }
        const double dt_s = std::min(kPlannerStep_s, now_s - m_now_s);
        if (m_mode == DobotMode::Running)
            move(dt_s);
        m_now_s += dt_s;
        if (m_now_s >= m_packet_s) {
            m_packet_s = m_now_s + kPeriod_s;
            m_feedback.m_said += dobotPacket(
                {m_mode, m_position, m_user, m_tool, static_cast<std::uint64_t>(1000.0 + 1e3 * m_now_s)});
            if (m_feedback.m_said.size() > 10 * DobotFeedbackReader::kPacketBytes) // nobody reads
                m_feedback.m_said.erase(0, DobotFeedbackReader::kPacketBytes);
        }
    }
}

void DobotSimulator::move(double dt_s) {
    if (!m_queue.empty()) {
        Queued& next = m_queue.front();
        double squares = 0.0;
        for (std::size_t i = 0; i < m_position.size(); ++i)
            squares += std::pow(next.to[i] - m_position[i], 2);
        const double left = std::sqrt(squares),
                     way = next.speed * m_speedFactor * m_config.fullSpeed_mm_s * dt_s;
        const double share = way < left ? way / left : 1.0;
        for (std::size_t i = 0; i < m_position.size() && m_fault != "lost-steps"; ++i)
            m_position[i] += share * (next.to[i] - m_position[i]);
        next.lost += m_fault == "lost-steps" ? way : 0.0;
        if (share == 1.0 || next.lost >= left)
            m_queue.pop_front();
    }
    runQueue();
}

} // namespace bask
