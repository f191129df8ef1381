#include "engine/drivers/program_check.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/pose.h"
#include "engine/base/units.h"
#include "engine/drivers/confirmed_programs.h"
#include "engine/drivers/program_clock.h"
#include "engine/drivers/program_files.h"
#include "engine/drivers/program_link.h"
#include "engine/protocols/line_splitter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace bask {
namespace {

using Finding = ProgramFinding::Kind;

constexpr double kStart_s = 3.0, kHelloWithin_s = 10.0, kAnswer_s = 1.0, kPrompt_s = 0.5;
constexpr double kRead_s = 0.05;
constexpr int kReads = 40;
constexpr double kRate_m_s = 0.002, kRate_rad_s = 0.02; ///< slow enough for any robot
constexpr double kSlow = 0.2;                           ///< of these rates, where a program may not end it
constexpr double kStill = 2e-5;                         ///< m or rad: noise of a place at rest
constexpr double kOther = 2e-4;                         ///< m or rad: of an axis that is to stand
constexpr double kMaxTurn_rad = 6.4, kUnlimited = 50.0; ///< a program that tells no limit has a larger one
constexpr double kSettle_s = 0.3;                       ///< until a robot that was told to stand does
constexpr double kSwitched_s = 2.0;                     ///< until a relay has switched and the device says so
constexpr double kWarmer_K = 5.0;
constexpr double kClockOff_s = 0.5;
constexpr double kTooCold_K = 150.0; ///< for a laboratory: degrees Celsius, probably

/// What cannot go on.
struct ProgramIsGone {
    std::string words;
};

std::string seconds(double s) {
    return formatNumber(s, 2) + " s";
}

/// The program and what was seen of its lines so far.
class CheckedProgram {
public:
    CheckedProgram(const std::string& command, ProgramRole role,
                   const std::shared_ptr<const ConfirmedPrograms>& confirmed, std::function<bool()> isStopped)
        : m_isStopped(std::move(isStopped)), m_role(role),
          m_link(std::make_unique<ProgramLink>(command, programRoleWord(role), confirmed)) {
        m_link->open();
        const double began_s = m_clock.now_s();
        while (!m_link->isOpen() && m_link->problem().code == MessageCode::None &&
               m_clock.now_s() - began_s < kStart_s)
            rest();
        if (!m_link->isOpen())
            throw ProgramIsGone{describe(m_link->problem())};
    }

    ProgramHello hello() {
        const auto line = ask([this](std::int64_t id) { return programHello(id, m_role); }, kHelloWithin_s);
        if (!line)
            throw ProgramIsGone{"it does not answer hello within " + seconds(kHelloWithin_s) + lastDefect()};
        const auto* told = std::get_if<ProgramHello>(&line->what);
        if (told == nullptr)
            throw ProgramIsGone{"it answers hello with something else"};
        return *told;
    }
    /// The answer to one request; empty: none came in time.
    template <class Write> std::optional<ProgramLine> ask(Write text, double within_s = kAnswer_s) {
        const std::int64_t id = ++m_id;
        m_link->write(text(id));
        const double sent_s = m_clock.now_s();
        while (m_clock.now_s() - sent_s < within_s) {
            std::optional<ProgramLine> answer;
            for (ProgramLine& line : take(sent_s)) // a second answer may come with the first
                if (line.id == id && !answer) {
                    m_answered_s.push_back(m_clock.now_s() - sent_s);
                    answer = std::move(line);
                } else if (line.id) {
                    defect("id", "it answers request " + std::to_string(*line.id) +
                                     (answer ? " (id) after " : " (id) instead of ") + std::to_string(id) +
                                     ": answer each request once, with its own id");
                }
            if (answer)
                return answer;
            rest();
        }
        return std::nullopt;
    }
    std::optional<ProgramLine> ask(const char* what) {
        return ask([what](std::int64_t id) { return programRequest(id, what); });
    }
    template <class State> State read() {
        const auto line = ask("read");
        if (!line)
            throw ProgramIsGone{"it does not answer read within " + seconds(kAnswer_s) + lastDefect()};
        if (const auto* refusal = std::get_if<ProgramRefusal>(&line->what))
            throw ProgramIsGone{"it refuses read: " + refusal->words};
        if (const auto* state = std::get_if<State>(&line->what))
            return *state;
        throw ProgramIsGone{"it answers read with something else"};
    }
    /// Nothing is sent or read.
    void rest(double for_s = 1e-3) const {
        const double until_s = m_clock.now_s() + for_s;
        do {
            if (m_isStopped())
                throw ProgramIsGone{"the check was interrupted"};
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (m_clock.now_s() < until_s);
    }
    void write(const std::string& line) { m_link->write(line); }
    /// Each line that comes within this time.
    std::vector<ProgramLine> listen(double for_s) {
        std::vector<ProgramLine> out;
        const double until_s = m_clock.now_s() + for_s;
        while (m_clock.now_s() < until_s) {
            std::ranges::move(take(m_clock.now_s()), std::back_inserter(out));
            rest();
        }
        return out;
    }
    /// Ends its input; returns how long it took to end, and whether it ended by itself.
    std::pair<double, bool> end() {
        const double ended_s = m_clock.now_s();
        m_link.reset();
        ProgramLink::waitForAll();
        const double took_s = m_clock.now_s() - ended_s;
        return {took_s, took_s < 1.0};
    }
    const std::vector<double>& answered_s() const { return m_answered_s; }
    /// Those that were not told yet.
    std::set<std::string> takeDefects() { return std::exchange(m_defects, {}); }

private:
    std::string lastDefect() const { return m_defects.empty() ? std::string() : "; " + *m_defects.rbegin(); }
    /// One of a kind is enough: the numbers in its words differ each time.
    void defect(const char* kind, const std::string& words) {
        if (m_told.insert(kind).second)
            m_defects.insert(words);
    }
    std::vector<ProgramLine> take(double asked_s) {
        std::vector<ProgramLine> out;
        m_lines.add(m_link->read());
        while (const auto text = m_lines.next())
            if (const auto line = parseProgramLine(*text, m_role)) {
                check(*line, asked_s);
                out.push_back(*line);
            } else {
                defect("line",
                       "\"" + plainWords(text->substr(0, 80)) + "\" is no line of the protocol (" +
                           describe(line.error()) +
                           "): write lines of the protocol, and nothing else, to the standard output");
            }
        if (out.empty() && !m_link->isOpen())
            throw ProgramIsGone{describe(m_link->problem())};
        return out;
    }
    void check(const ProgramLine& line, double asked_s) {
        if (line.seq != ++m_seq)
            defect("seq", "line " + std::to_string(line.seq) + " (seq) comes instead of line " +
                              std::to_string(m_seq) + ": count each line that is written, from 1");
        m_seq = line.seq;
        if (std::holds_alternative<ProgramHello>(line.what)) // it may have started slowly before
            return;
        const double off_s = m_programClock.off_s(line.time_s, asked_s, m_clock.now_s());
        if (off_s > kClockOff_s)
            defect("time", "its time is off by " + seconds(off_s) +
                               " since it began: take a clock that is never set, in seconds");
    }

    const SteadyClock m_clock;
    const std::function<bool()> m_isStopped;
    const ProgramRole m_role;
    std::unique_ptr<ProgramLink> m_link;
    LineSplitter m_lines{"\n", program::kLongestLine};
    std::int64_t m_id = 0, m_seq = 0;
    ProgramClock m_programClock;
    std::vector<double> m_answered_s;
    std::set<std::string> m_defects, m_told;
};

class ProgramCheck {
public:
    ProgramCheck(const std::string& command, ProgramRole role, const ProgramCheckOptions& options,
                 const std::function<void(const ProgramFinding&)>& tell)
        : m_command(command), m_role(role), m_options(options), m_tell(tell) {
        if (const auto files = programFiles(command)) {
            auto confirmed = std::make_shared<ConfirmedPrograms>();
            confirmed->add(files->hash);
            m_confirmed = std::move(confirmed);
        }
    }

    void run() {
        try {
            begin();
            checkReads();
            checkNonsense();
            if (m_role == ProgramRole::Robot)
                checkRobot();
            else if (m_role == ProgramRole::HeatSource)
                checkHeater();
            tellDefects();
            checkEnd();
        } catch (const ProgramIsGone& gone) {
            tellDefects();
            broken(gone.words);
        }
    }

private:
    void kept(const std::string& words) { m_tell({Finding::Kept, words}); }
    void broken(const std::string& words) { m_tell({Finding::Broken, words}); }
    void notTried(const std::string& words) { m_tell({Finding::NotTried, words}); }
    void judge(bool isKept, const std::string& good, const std::string& bad) {
        if (isKept)
            kept(good);
        else
            broken(bad);
    }
    void tellDefects() {
        if (m_program == nullptr)
            return;
        for (const std::string& words : m_program->takeDefects())
            broken(words);
    }

    void begin() {
        m_program = std::make_unique<CheckedProgram>(m_command, m_role, m_confirmed, m_options.isStopped);
        m_hello = m_program->hello();
        std::string words = "says hello: \"" + m_hello.name + "\"" +
                            (m_hello.serial.empty() ? std::string(", no serial number")
                                                    : ", serial number \"" + m_hello.serial + "\"");
        if (m_role == ProgramRole::Robot) {
            words += ", takes " + std::string(m_hello.takesVelocities ? "velocities" : "steps") + ", axes " +
                     coordinateNames(m_hello.axes);
            checkAngleLimits();
        } else if (m_role == ProgramRole::Thermometer) {
            words += ", " + std::to_string(m_hello.channels) + " channels";
        } else {
            words += ", heats up to " + formatNumber(m_hello.maxTemperature_K) + " K" +
                     (m_hello.hasWatchdog ? ", has a watchdog" : ", no watchdog of its own");
        }
        kept(words);
    }

    void readState() {
        if (m_role == ProgramRole::Robot) {
            m_robot = m_program->read<ProgramRobotState>();
            if (m_robot.position.size() != m_hello.axes.size())
                throw ProgramIsGone{"a position of " + std::to_string(m_robot.position.size()) +
                                    " numbers, but hello has " + std::to_string(m_hello.axes.size()) +
                                    " axes: one number an axis"};
        } else if (m_role == ProgramRole::Thermometer) {
            const auto channels = m_program->read<std::vector<ProgramChannel>>();
            if (static_cast<int>(channels.size()) != m_hello.channels)
                throw ProgramIsGone{std::to_string(channels.size()) + " temperatures, but hello has " +
                                    std::to_string(m_hello.channels) + " channels"};
            m_channels = channels;
        } else {
            m_heater = m_program->read<ProgramHeaterState>();
        }
    }
    void checkReads() {
        for (int i = 0; i < kReads; ++i) {
            readState();
            m_program->rest(kRead_s);
        }
        std::vector<double> times = m_program->answered_s();
        times.erase(times.begin()); // the hello's
        std::ranges::sort(times);
        const double median_s = times[times.size() / 2], worst_s = times.back();
        const std::string words = "within " + formatNumber(1e3 * median_s, 2) + " ms (median), " +
                                  formatNumber(1e3 * worst_s, 2) + " ms (worst of " +
                                  std::to_string(times.size()) + ")";
        judge(worst_s <= kPrompt_s, "answers read " + words,
              "answers read " + words + ", but " + seconds(kPrompt_s) +
                  " is the limit: read a slow device in the background, and give \"age\"");
        if (m_role == ProgramRole::Thermometer)
            for (std::size_t i = 0; i < m_channels.size(); ++i) {
                checkKelvins("channel " + std::to_string(i), m_channels[i].temperature_K);
                kept("channel " + std::to_string(i) + ": " +
                     (m_channels[i].temperature_K
                          ? formatNumber(*m_channels[i].temperature_K, 5) + " K (" +
                                formatNumber(*m_channels[i].temperature_K - 273.15, 4) + " degC)"
                          : std::string("no temperature")));
            }
        if (m_role == ProgramRole::HeatSource)
            checkKelvins("its surface", m_heater.temperature_K);
    }
    void checkKelvins(const std::string& of, const std::optional<double>& temperature_K) {
        if (temperature_K && *temperature_K < kTooCold_K)
            broken(of + " has " + formatNumber(*temperature_K, 5) +
                   " K, which is too cold: tell kelvins (add 273.15 to degrees Celsius)");
    }
    void checkNonsense() {
        const auto unknown = m_program->ask("dance");
        judge(unknown && std::holds_alternative<ProgramRefusal>(unknown->what),
              "refuses a request that it does not know", "does not answer an unknown request with \"error\"");
        m_program->write("this is no JSON\n");
        m_program->write("[]\n");
        const auto answers = m_program->listen(0.2);
        judge(std::ranges::any_of(answers,
                                  [](const ProgramLine& line) {
                                      return !line.id && std::holds_alternative<ProgramRefusal>(line.what);
                                  }),
              "says that it cannot read a line",
              R"(does not answer a line that it cannot read with "id": null and "error")");
        readState();
        kept("goes on after lines that it cannot read");
    }

    // --- Robot ---

    std::vector<double> ratesOf(double share) const {
        std::vector<double> rates(m_hello.axes.size(), 0.0);
        rates[m_axis] = share * (isTurning() ? kRate_rad_s : kRate_m_s);
        return rates;
    }
    bool isTurning() const { return m_hello.axes[m_axis] >= 3; }
    double place() const { return m_robot.position[m_axis]; }
    void velocity(double share, double validFor_s) {
        command([&](std::int64_t id) { return programVelocity(id, ratesOf(share), validFor_s); }, "velocity");
    }
    void step(double to, double duration_s) {
        std::vector<double> goal = m_robot.position;
        goal[m_axis] = to;
        command([&](std::int64_t id) { return programStep(id, goal, duration_s); }, "step");
    }
    void go(double share, double for_s) {
        if (m_hello.takesVelocities)
            velocity(share, for_s);
        else
            step(place() + ratesOf(share)[m_axis] * for_s, for_s);
    }
    template <class Write> bool command(Write text, const std::string& name) {
        const auto answer = m_program->ask(text);
        if (!answer) {
            broken("does not answer " + name + " within " + seconds(kAnswer_s));
            return false;
        }
        if (const auto* refusal = std::get_if<ProgramRefusal>(&answer->what)) {
            broken("refuses " + name + ": " + refusal->words);
            if (m_role == ProgramRole::Robot && drift() > kStill)
                broken("refuses " + name + ", and moves nevertheless");
            return false;
        }
        return true;
    }
    /// A command that must not be carried out.
    bool isRefused(const std::string& what, const std::string& rest) {
        const auto answer = m_program->ask([&](std::int64_t id) {
            return R"({"id": )" + std::to_string(id) + R"(, "do": ")" + what + "\", " + rest + "}\n";
        });
        return answer && std::holds_alternative<ProgramRefusal>(answer->what);
    }
    void readFor(double for_s) {
        const double until_s = m_clock.now_s() + for_s;
        while (m_clock.now_s() < until_s) {
            readState();
            m_wasMoving = m_wasMoving || m_robot.isMoving;
            m_program->rest(kRead_s);
        }
    }
    /// How far it goes on within a short time.
    double drift() {
        readState();
        const double from = place();
        readFor(0.3);
        return std::abs(place() - from);
    }
    bool isStanding() { return drift() < kStill && !m_robot.isMoving; }
    std::string far(double way) const {
        return isTurning() ? formatNumber(degFromRad(way), 3) + " degrees"
                           : formatNumber(1e3 * way, 3) + " mm";
    }
    std::string axisName() const { return coordinateNames({m_hello.axes[m_axis]}); }
    void checkAngleLimits() {
        for (const int axis : m_hello.axes) {
            const auto& [min, max] = m_hello.limits[static_cast<std::size_t>(axis)];
            const double most = std::max(std::abs(min), std::abs(max));
            if (axis >= kThetaX && most > kMaxTurn_rad && most < kUnlimited)
                broken("its limits of " + coordinateNames({axis}) + " are " + formatNumber(min, 4) + " to " +
                       formatNumber(max, 4) +
                       " rad, more than a turn: tell radians (degrees times 0.017453)");
        }
    }

    void checkRobot() {
        readState();
        if (!m_options.mayMove)
            return notTried("motion, stop and dead-man rule, by --no-motion");
        if (m_options.mayHome && m_hello.canHome)
            home();
        if (!m_robot.alarm.empty())
            return notTried("motion, since the robot tells the alarm \"" + m_robot.alarm + "\"");
        if (!m_robot.isSure)
            return notTried("motion, since its place is not sure: home it first" +
                            std::string(m_hello.canHome ? ", or take --home" : ""));
        judge(isStanding(), "stands before it is told to move",
              "moves, or says so, although nobody has told it to");
        checkWrongCount();
        checkWay(1.0);
        checkStop();
        (void)m_program->ask("clear");
        judge(isStanding(), "stands after clear", "moves after clear, which may only clear an alarm");
        checkRobotDeadMan();
        checkLimits();
        for (m_axis = 1; m_axis < m_hello.axes.size(); ++m_axis)
            checkWay(0.5);
        m_axis = 0;
    }
    void home() {
        if (!command([](std::int64_t id) { return programRequest(id, "home"); }, "home"))
            return;
        m_wasMoving = false;
        const double began_s = m_clock.now_s();
        do
            readFor(0.2);
        while (m_robot.isMoving && m_clock.now_s() - began_s < 120.0);
        judge(m_wasMoving, "says that it moves while it homes",
              "\"moving\" is false right after home: set it until homing has ended");
        judge(m_robot.isSure, "is sure of its place after homing", "is not sure of its place after homing");
    }
    /// One number more than it has axes.
    void checkWrongCount() {
        std::vector<double> goal = m_robot.position;
        goal[m_axis] += ratesOf(0.5)[m_axis];
        std::string numbers;
        for (const double number : m_hello.takesVelocities ? ratesOf(1.0) : goal)
            numbers += formatNumber(number, 17) + ", ";
        numbers += "0.0";
        const bool isNo = m_hello.takesVelocities
                              ? isRefused("velocity", "\"rates\": [" + numbers + "], \"valid_for\": 0.5")
                              : isRefused("step", "\"to\": [" + numbers + "], \"duration\": 0.5");
        judge(
            isNo && isStanding(), "refuses a command of a wrong length",
            "does not refuse a command with one number too many, or moves for it: answer it with \"error\"");
        (void)m_program->ask("stop");
        readFor(kSettle_s);
    }
    /// There, away from a limit that is near, and back by as much.
    void checkWay(double for_s) {
        const std::vector<double> began = m_robot.position;
        const double from = place(), width = ratesOf(1.0)[m_axis] * for_s;
        const bool isNear = from + width > m_hello.limits[static_cast<std::size_t>(m_hello.axes[m_axis])][1];
        const double share = isNear ? -1.0 : 1.0, wanted = share * width;
        m_wasMoving = false;
        go(share, for_s);
        readFor(for_s);
        judge(m_wasMoving, axisName() + " says that it moves",
              "\"moving\" stays false while " + axisName() + " moves");
        readFor(kSettle_s);
        const double way = place() - from;
        const double room = m_hello.takesVelocities ? 0.5 * width : 0.25 * width;
        const std::string words = axisName() + " goes " + far(way) + ", from " + far(from) + " to " +
                                  far(place()) + ", where " + far(wanted) + " were asked for";
        judge(std::abs(way - wanted) <= room, words,
              words + ": check the units (m, rad, s), the order of the axes and the sign");
        for (std::size_t k = 0; k < began.size(); ++k)
            if (k != m_axis && std::abs(m_robot.position[k] - began[k]) > kOther)
                broken(coordinateNames({m_hello.axes[k]}) + " moves, too, while only " + axisName() +
                       " was to move: check the order of the axes");
        judge(isStanding(),
              axisName() + " stands " +
                  (m_hello.takesVelocities ? "when valid_for is over" : "at the end of a step"),
              axisName() + " does not stand " +
                  (m_hello.takesVelocities ? "when valid_for is over: stop then, without another command"
                                           : "at the end of a step, or \"moving\" stays true"));
        go(-share, for_s);
        readFor(for_s + kSettle_s);
    }
    void checkStop() {
        go(1.0, 3.0);
        readFor(0.3);
        command([](std::int64_t id) { return programRequest(id, "stop"); }, "stop");
        readFor(kSettle_s);
        judge(isStanding(), "stands after stop", "does not stand after stop, or \"moving\" stays true");
    }
    void checkRobotDeadMan() {
        const double from = place();
        constexpr double kSilent_s = 2.0;
        go(-kSlow, 10.0);
        m_program->rest(kSilent_s);
        readState();
        const double way = std::abs(place() - from);
        const double mayBe = std::abs(ratesOf(kSlow)[m_axis]) * (program::kDeadMan_s + kSettle_s);
        const bool isStill = isStanding();
        judge(isStill && way <= mayBe,
              "stops by itself when nothing comes for " + seconds(program::kDeadMan_s),
              "goes on for " + far(way) + " although nothing came for " + seconds(kSilent_s) +
                  " (dead-man rule): stop when no line has come for " + seconds(program::kDeadMan_s));
        command([](std::int64_t id) { return programRequest(id, "stop"); }, "stop");
        readFor(kSettle_s);
    }
    void checkLimits() {
        const auto& limit = m_hello.limits[static_cast<std::size_t>(m_hello.axes[m_axis])];
        if (m_hello.takesVelocities || limit[1] > kUnlimited)
            return;
        std::vector<double> beyond = m_robot.position;
        beyond[m_axis] = limit[1] + 0.1;
        const double from = place(), slow_s = (beyond[m_axis] - from) / std::abs(ratesOf(1.0)[m_axis]);
        const auto answer =
            m_program->ask([&](std::int64_t id) { return programStep(id, beyond, std::min(slow_s, 60.0)); });
        const bool isRefused = answer && std::holds_alternative<ProgramRefusal>(answer->what);
        (void)m_program->ask("stop");
        readFor(kSettle_s);
        judge(isRefused && std::abs(place() - from) < kStill, "refuses a step beyond its limits",
              "does not refuse a step beyond the limits of its hello, or moves nevertheless");
    }

    // --- Heat source ---

    bool waitsFor(bool isHeating, double within_s) {
        const double until_s = m_clock.now_s() + within_s;
        do {
            readState();
            if (m_heater.isHeating == isHeating)
                return true;
            m_program->rest(kRead_s);
        } while (m_clock.now_s() < until_s);
        return false;
    }
    void heat(double validFor_s) {
        command([&](std::int64_t id) { return programHeat(id, m_setPoint_K, validFor_s); }, "heat");
    }
    void checkHeater() {
        command([](std::int64_t id) { return programRequest(id, "off"); }, "off");
        judge(waitsFor(false, kSwitched_s), "says that its heat is off after off",
              "says \"heating\" " + seconds(kSwitched_s) + " after off");
        if (!m_options.mayMove)
            return notTried("heat and dead-man rule, by --no-motion");
        const auto above = m_program->ask(
            [&](std::int64_t id) { return programHeat(id, m_hello.maxTemperature_K + 10.0, 1.0); });
        judge(above && std::holds_alternative<ProgramRefusal>(above->what),
              "refuses a set point above max_temperature",
              "does not refuse a set point above max_temperature");
        judge(isRefused("heat", R"("set_point": "w", "valid_for": 1.0)") && waitsFor(false, 0.2),
              "refuses a set point that is no number", "does not refuse a set point that is no number");
        (void)m_program->ask("off");
        m_setPoint_K = std::min(m_heater.temperature_K.value_or(295.0) + kWarmer_K, m_hello.maxTemperature_K);
        heat(5.0);
        judge(waitsFor(true, kSwitched_s), "heats when it is told to",
              "does not say \"heating\" within " + seconds(kSwitched_s) + " of heat");
        if (m_heater.setPoint_K)
            judge(std::abs(*m_heater.setPoint_K - m_setPoint_K) < 0.6, "reads its set point back",
                  "reads a set point of " + formatNumber(*m_heater.setPoint_K, 5) + " K back where " +
                      formatNumber(m_setPoint_K, 5) + " K was set");
        command([](std::int64_t id) { return programRequest(id, "off"); }, "off");
        judge(waitsFor(false, kSwitched_s), "switches off when it is told to", "heats on after off");
        heat(1.0);
        (void)waitsFor(true, kSwitched_s);
        judge(waitsFor(false, 1.0 + kSwitched_s), "switches off when valid_for is over",
              "heats on when valid_for is over: switch off then, without another command");
        (void)m_program->ask("off");
        heat(10.0);
        (void)waitsFor(true, kSwitched_s);
        m_program->rest(program::kDeadMan_s + 0.5);
        readState();
        judge(!m_heater.isHeating,
              "switches off by itself when nothing comes for " + seconds(program::kDeadMan_s),
              "heats on although nothing came for " + seconds(program::kDeadMan_s + 0.5) +
                  " (dead-man rule): switch off when no line has come for " + seconds(program::kDeadMan_s));
        (void)m_program->ask("off");
    }

    // --- The end ---

    /// With motion or heat on: the next start sees whether they have ended.
    void checkEnd() {
        const bool moves =
            m_role == ProgramRole::Robot && m_options.mayMove && m_robot.isSure && m_robot.alarm.empty();
        const bool heats = m_role == ProgramRole::HeatSource && m_options.mayMove;
        if (moves)
            go(kSlow, 10.0);
        if (heats)
            heat(10.0);
        const auto [took_s, isByItself] = m_program->end();
        judge(isByItself, "ends " + seconds(took_s) + " after the end of its input",
              "does not end within 1 s of the end of its input: it was ended by a signal after " +
                  seconds(took_s));
        m_program = std::make_unique<CheckedProgram>(m_command, m_role, m_confirmed, m_options.isStopped);
        const ProgramHello before = std::exchange(m_hello, m_program->hello());
        judge(m_hello.name == before.name && m_hello.serial == before.serial,
              "is the same device after a new start",
              "has another name or serial number after a new start (\"" + m_hello.name + "\", \"" +
                  m_hello.serial + "\"): Bask would take it for another device");
        readState();
        if (moves)
            judge(isStanding(), "has stopped at the end of its input", "goes on after the end of its input");
        else if (heats)
            judge(!m_heater.isHeating, "has switched off at the end of its input",
                  "heats on after the end of its input");
        (void)m_program->end();
    }

    const SteadyClock m_clock;
    const std::string m_command;
    const ProgramRole m_role;
    const ProgramCheckOptions m_options;
    const std::function<void(const ProgramFinding&)>& m_tell;
    std::shared_ptr<const ConfirmedPrograms> m_confirmed;
    std::unique_ptr<CheckedProgram> m_program;
    ProgramHello m_hello;
    std::size_t m_axis = 0; ///< that is moved
    ProgramRobotState m_robot;
    std::vector<ProgramChannel> m_channels;
    ProgramHeaterState m_heater;
    double m_setPoint_K = 0.0;
    bool m_wasMoving = false;
};

} // namespace

void checkProgram(const std::string& command, ProgramRole role, const ProgramCheckOptions& options,
                  const std::function<void(const ProgramFinding&)>& tell) {
    ProgramCheck(command, role, options, tell).run();
}

} // namespace bask
