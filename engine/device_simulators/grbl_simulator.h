#pragma once
// A simulated robot with Grbl 1.1 or grblHAL: the exact bytes, motors that ramp, switches, and the pitfalls
// that were found with real controllers.

#include "engine/device_simulators/byte_device.h"

#include <deque>
#include <map>
#include <optional>
#include <random>

namespace bask {

/// Millimetres and degrees, one number for each axis, in the order of X Y Z A B C.
struct GrblSimulatorConfig {
    /// Behaves as grblHAL: 0x85 discards unread bytes, `?` is answered while homing.
    bool isHal = false;
    /// Position at the start, and what it reports there.
    std::vector<double> start{0.0, 0.0, 0.0, 0.0};
    std::vector<double> home{0.0, 0.0, 0.0, 0.0}; ///< positions of the homing switches
    /// Ends of travel: limit switches, soft limits.
    std::vector<double> lower{-1000.0, -1000.0, -1000.0, -360.0};
    std::vector<double> upper{1000.0, 1000.0, 1000.0, 360.0};
    double maxRate_mm_min = 6000.0;    ///< of each axis
    double acceleration_mm_s2 = 500.0; ///< 0: full speed at once
    double homingRate_mm_min = 3000.0;
    bool canHome = true;           ///< $22
    bool hasSoftLimits = false;    ///< $20; they apply only after homing
    bool resetsWhenOpened = false; ///< like an Arduino: the host's DTR resets it
    bool startsLocked = false;     ///< starts in an alarm until it is homed or unlocked
    bool tellsWork = false;        ///< reports WPos instead of MPos, $10
    bool tellsOffset = true;       ///< reports WCO from time to time
    bool tellsInches = false;      ///< $13
    std::vector<double> workOffset{0.0, 0.0, 0.0, 0.0};
    std::string name = "";     ///< name that its `$I` reports
    double lineTime_s = 0.001; ///< before a received line is processed
};

class GrblSimulator final : public ByteDevice {
public:
    explicit GrblSimulator(const GrblSimulatorConfig& config = {});

    void opened(double now_s) override;
    void receive(std::string_view bytes, double now_s) override;
    std::string transmit(double now_s) override;
    /// Returns "none", "silent", "restart", "alarm" (limit switch), "door", "slow-ok", "lost-steps" (an
    /// encoder reports that the motors stand), "garbage", "inches" (it begins to report its place in them,
    /// and says nothing about that), "homing-fails" (it finds no switch).
    std::vector<std::string> faults() const override;
    Result<void> setFault(const std::string& name) override;

    /// Power off and on: sends the banner, loses all lines, and reports zero at any position.
    void restart();
    /// Returns the true positions of the axes; it may report others after a restart.
    const std::vector<double>& positions() const { return m_true; }
    /// Returns the number of moves that are in progress or waiting.
    std::size_t queued() const { return m_blocks.size(); }
    bool isMoving() const { return m_speed > 0.0 || !m_homing.empty(); }
    /// Returns "Idle", "Hold:0" ...
    std::string state() const;

private:
    static constexpr std::size_t kBlocks = 15;
    static constexpr double kInch_mm = 25.4;
    static constexpr double kThere = 1e-9;

    enum class State { Idle, Run, Hold, Jog, Alarm, Door, Home };
    struct Line {
        double time_s; ///< when it is processed
        std::string text;
    };
    struct Block {
        std::vector<double> to; ///< in reported positions
        double feed_mm_s;
    };
    struct Words {
        std::map<char, double> values; ///< F and axes
        std::vector<int> g;
        int error = 0;
    };

    void advance(double now_s);
    void work(double dt_s);
    void takeLines();
    bool takesLines() const;
    void takeByte(char byte);
    void say(const std::string& line) { m_said += line + "\r\n"; }
    void answer(int error) { say(error == 0 ? "ok" : "error:" + std::to_string(error)); }

    void take(const std::string& line);
    int takeDollar(const std::string& line);
    int takeJog(const std::string& text);
    int takeCode(const std::string& text);
    Words readWords(const std::string& text) const;
    /// Returns the error number; 0 if the move was queued.
    int queue(const Words& words, bool isRelative, bool isInches, double feed_mm_s, bool isJog);
    int takeSetting(const std::string& line);
    void home();

    void reset();
    void startUp(bool isLocked);
    void raiseAlarm(int number);
    void cancelJog();
    static double distance(const std::vector<double>& a, const std::vector<double>& b);
    void move(double dt_s);
    void moveHome(double dt_s);
    double speedAllowed(double left) const;
    void stepTo(const Block& block, double way);
    void endBlock();
    void stopped();
    std::string status();
    void spoil(std::string& bytes);

    GrblSimulatorConfig m_config;
    std::map<int, std::string> m_settings;
    double m_now_s = 0.0;
    State m_state = State::Idle;
    bool m_needsReset = false; ///< an alarm that only 0x18 clears
    bool m_isHomed = false;
    bool m_isDoorOpen = false;
    bool m_isStopping = false; ///< slows down because of a hold, a door or a cancelled jog
    std::vector<double> m_true, m_reads;
    std::deque<Block> m_blocks;
    double m_speed = 0.0;         ///< along the first block, mm/s
    std::vector<double> m_homing; ///< target of homing; empty: it does not home
    double m_homingLeft_s = 0.0;  ///< until it gives up searching
    double m_dwellUntil_s = -1.0;
    bool m_isDwelling = false;
    std::string m_partial;
    std::deque<Line> m_lines;
    std::string m_said;
    bool m_isRelative = false, m_isInches = false;
    int m_motion = 0; ///< G0, G1
    double m_feed_mm_s = 0.0;
    int m_reports = 0;
    std::string m_fault = "none";
    std::mt19937 m_random{7};
};

} // namespace bask
