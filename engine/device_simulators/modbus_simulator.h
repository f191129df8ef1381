#pragma once
// Modbus units at the far end of one serial line or of one network address: thermometer modules and
// temperature controllers, described by profiles.

#include "engine/device_simulators/byte_device.h"
#include "engine/protocols/modbus_frame.h"
#include "engine/protocols/modbus_profile.h"

#include <deque>
#include <map>
#include <optional>

namespace bask {

/// The heated plate of a simulated controller: it approaches its set point while it heats and the ambient
/// temperature while it does not, both exponentially.
struct SimulatedPlate {
    double ambient_K = 296.15;
    double heating_s = 60.0; ///< time constants
    double cooling_s = 300.0;
};

/// Faults, of all units: "silent"; "open" and "short", as the profile reports such sensors; "frozen":
/// registers do not change; "jumping": thermometers show 30 K more every other half second; "rising": 2 K/s
/// more; "wrong-unit", "short-reply", "late-reply" and "exception" answers; of RTU "bad-crc", of TCP
/// "wrong-id", the number of another request, and "garbage".
class ModbusSimulator final : public ByteDevice {
public:
    enum class Frames { Rtu, Tcp };

    explicit ModbusSimulator(Frames frames = Frames::Rtu) : m_frames(frames) {}

    static constexpr double kReplyTime_s = 0.005;
    static constexpr double kLateReply_s = 0.75;

    /// Every channel starts at `t_K`. Throws std::invalid_argument for a profile without channels.
    void addThermometer(int unit, const ModbusProfile& profile, double t_K);
    /// Throws std::invalid_argument for a profile without a process value.
    void addController(int unit, const ModbusProfile& profile, const SimulatedPlate& plate = {});

    /// A temperature beyond the range of the registers sets them to the end of the range. Throws
    /// std::out_of_range for an unknown unit.
    void setTemperature(int unit, int channel, double t_K);
    double plate_K(int unit) const { return m_units.at(unit).plate_K; }
    void setPlate(int unit, double t_K) { m_units.at(unit).plate_K = t_K; }
    /// Removes a channel, as if it were not set up: requests that contain it are refused.
    void removeChannel(int unit, int channel);
    /// Returns the set point from the last client.
    double setPoint_K(int unit) const;
    /// Returns whether the controller heats towards its set point; one without a run register always does.
    bool isOn(int unit) const;
    /// Returns what a client reads there.
    std::uint16_t registerAt(int unit, int function, int address) const;
    void setRegister(int unit, int function, int address, std::uint16_t value);
    /// Returns the number of registers written by clients so far.
    int writes() const { return m_writes; }
    /// Returns the functions of all requests so far, also those to units that are not there.
    const std::vector<int>& functions() const { return m_functions; }

    void opened(double now_s) override;
    void receive(std::string_view bytes, double now_s) override;
    std::string transmit(double now_s) override;
    std::vector<std::string> faults() const override;
    Result<void> setFault(const std::string& name) override;

private:
    struct Unit {
        ModbusProfile profile;
        SimulatedPlate plate{};
        double plate_K = 0.0;
        std::vector<double> channels_K;
        std::map<std::pair<int, int>, std::uint16_t> registers; ///< by function and address
        /// Time of the newest request, for the watchdog.
        double asked_s = 0.0;
    };

    void advance(double now_s);
    static void advance(Unit& unit, double from_s, double to_s);
    static void store(Unit& unit, const RegisterSpec& spec, const std::vector<std::uint16_t>& values,
                      int shift = 0);
    static double temperatureAt(const Unit& unit, const RegisterSpec& spec);
    static double quantityAt(const Unit& unit, const RegisterSpec& spec);
    static bool isOn(const Unit& unit);
    static void addKind(Unit& unit);
    void refresh(Unit& unit) const;
    double shownTooMuch_K() const;
    void refreshSensor(Unit& unit, const RegisterSpec& spec, int channel, double t_K) const;
    void answer(const ModbusQuery& query, double now_s, int transaction = 0);
    void takeTcp(double now_s);
    std::string framed(const std::string& frame, int transaction) const;
    std::string reply(Unit& unit, const ModbusQuery& query);
    std::string read(const Unit& unit, const ModbusQuery& query) const;
    std::string write(Unit& unit, const ModbusQuery& query);

    Frames m_frames;
    std::map<int, Unit> m_units;
    std::vector<int> m_functions;
    std::string m_received, m_fault = "none";
    double m_now_s = 0.0, m_heard_s = 0.0;
    double m_fault_s = 0.0; ///< start of the fault
    bool m_hasTime = false;
    std::deque<std::pair<double, std::string>> m_answers; ///< with the times at which they are sent
    int m_writes = 0;
};

} // namespace bask
