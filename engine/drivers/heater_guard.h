#pragma once
// The guard process that owns a heater's port instead of Bask, as the engine sees it: starts it, sends it
// heartbeats, and detects whether it has taken over or ended.

#include "engine/base/clock.h"
#include "engine/base/message.h"
#include "engine/base/message_code.h"
#include "engine/drivers/serial_port.h"
#include "engine/guard/guard_messages.h"
#include "engine/protocols/serial_settings.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace bask {

/// Use it only on the engine thread, because a heartbeat means that this thread is alive. Only handOver()
/// waits.
class HeaterGuard {
public:
    enum class State {
        None,     ///< never started, or it could not be
        Starting, ///< started, but it has not answered yet
        Guarding,
        TookOver, ///< it switches the heater off by itself, and passes nothing on
        Ended     ///< it had the heater and has ended: the port is free again
    };
    /// Without an answer to its heartbeats for this long it counts as dead.
    static constexpr double kSilent_s = 0.7;

    /// `logFile`: the guard appends its actions to it; empty: to no file. `clock` must outlive it. `portId`:
    /// the port's own name, which is a link to the port in `idFolder`; empty: it has none or it is unknown,
    /// and the first one found is used.
    HeaterGuard(std::string port, const SerialSettings& settings, std::string logFile, const Clock& clock,
                std::string portId = {}, std::string idFolder = kPortIds);
    /// An armed guard takes over.
    ~HeaterGuard();
    HeaterGuard(const HeaterGuard&) = delete;
    HeaterGuard& operator=(const HeaterGuard&) = delete;

    /// Starts a new guard with that program; only if there is none. It is started on another thread, because
    /// a disk may hang; problem() reports later why it could not be started.
    void start(const std::string& program);
    /// Reads its answers, and sends a heartbeat.
    void work();
    State state() const { return m_state; }
    /// Returns HeaterGuardMissing, HeaterGuardTookOver or HeaterGuardLost; None if it guards, or starts.
    const Message& problem() const { return m_problem; }

    /// Arms the guard: heat may be on from now, and `off` switches it off.
    void arm(const guard::OffProgram& off);
    /// Disarms the guard: the heat is known to be off.
    void disarm();
    bool isArmed() const { return m_isArmed; }
    /// Lets an armed guard take over, and waits for its confirmation; false if none came within that time.
    bool handOver(double within_s);

    // Its port: the functions that a link of bytes needs.
    void openPort();
    void closePort();
    bool isPortOpen() const { return m_isPortOpen && m_state == State::Guarding; }
    bool isPortOpening() const { return m_isPortOpening; }
    const Message& portProblem() const { return m_portProblem; }
    std::string read();
    void write(std::string_view bytes);
    const std::string& port() const { return m_port; }
    /// Returns the port's name, as expected or as first found; a port with another name is not opened.
    const std::string& portId() const { return m_portId; }

    std::optional<int> processId() const; ///< empty: there is none, or not yet

private:
    struct Process;

    void receive();
    void take(guard::Told kind, std::string_view bytes);
    bool tell(guard::Order order, std::string_view bytes = {}); ///< false if the guard does not accept it
    void losePort(Message problem);
    void hangUp();
    void end(); ///< of the process: its port is free

    std::string m_port;
    SerialSettings m_settings;
    std::string m_logFile, m_portId, m_idFolder;
    const Clock& m_clock;
    State m_state = State::None;
    Message m_problem, m_portProblem;
    int m_socket = -1;
    std::shared_ptr<Process> m_process;
    double m_hungUp_s = 0.0; ///< since when its end is awaited
    std::string m_off;       ///< the last program that it was given
    bool m_isArmed = false, m_isPortOpen = false, m_isPortOpening = false;
    std::string m_unread;
    double m_beat_s = -1e300, m_answered_s = 0.0, m_worked_s = -1e300;
};

/// Returns the guard's executable: beside this program, in ../libexec/bask, or in this build's folder. Empty
/// if there is none. Searched once.
const std::string& guardProgram();

} // namespace bask
