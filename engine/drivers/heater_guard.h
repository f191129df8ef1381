#pragma once
// The process that has a heater's port in Bask's place, as the engine sees it: started, kept alive by beats,
// and told apart from one that has taken over or is gone.

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

/// Engine thread only: a beat says that this thread is alive. Nothing here waits but handOver().
class HeaterGuard {
public:
    enum class State {
        None,     ///< never started, or it could not be
        Starting, ///< and has not said a word yet
        Guarding,
        TookOver, ///< switches off by itself, and lets nothing through
        Ended     ///< it had the heater and is gone: the port is free again
    };
    static constexpr double kSilent_s = 0.7; ///< without an answer to its beats it is taken for dead

    /// `logFile`: the guard appends to it what it does; empty: to none. `clock` outlives it.
    /// `portId`: the port's own name; empty: it has none, or is not known, and the first one counts. It is a
    /// link to the port in `idFolder`.
    HeaterGuard(std::string port, const SerialSettings& settings, std::string logFile, const Clock& clock,
                std::string portId = {}, std::string idFolder = kPortIds);
    /// One that is armed takes over.
    ~HeaterGuard();
    HeaterGuard(const HeaterGuard&) = delete;
    HeaterGuard& operator=(const HeaterGuard&) = delete;

    /// A new one, by that program; only without one. It is started elsewhere, since a disk may hang;
    /// problem() tells later why it could not be.
    void start(const std::string& program);
    /// Takes what it says, and beats.
    void work();
    State state() const { return m_state; }
    /// HeaterGuardMissing, HeaterGuardTookOver or HeaterGuardLost; None: it guards, or begins to.
    const Message& problem() const { return m_problem; }

    /// From here on heat may be on, and `off` switches it off.
    void arm(const guard::OffProgram& off);
    /// Heat is known to be off.
    void disarm();
    bool isArmed() const { return m_isArmed; }
    /// Lets one that is armed take over, and waits until it says so; false: it did not within that time.
    bool handOver(double within_s);

    // Its port. What a link of bytes is asked.
    void openPort();
    void closePort();
    bool isPortOpen() const { return m_isPortOpen && m_state == State::Guarding; }
    bool isPortOpening() const { return m_isPortOpening; }
    const Message& portProblem() const { return m_portProblem; }
    std::string read();
    void write(std::string_view bytes);
    const std::string& port() const { return m_port; }
    /// Its own name, as expected or as it was first; another one is not opened.
    const std::string& portId() const { return m_portId; }

    std::optional<int> processId() const; ///< empty: none, or not yet

private:
    struct Process;

    void receive();
    void take(guard::Told kind, std::string_view bytes);
    bool tell(guard::Order order, std::string_view bytes = {}); ///< false: it does not take it
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
    double m_hungUp_s = 0.0; ///< its end is waited for since
    std::string m_off;       ///< as it was told last
    bool m_isArmed = false, m_isPortOpen = false, m_isPortOpening = false;
    std::string m_unread;
    double m_beat_s = -1e300, m_answered_s = 0.0, m_worked_s = -1e300;
};

/// The guard's executable: beside this program, in ../libexec/bask, or where this build has put it. Empty:
/// there is none. Looked for once.
const std::string& guardProgram();

} // namespace bask
