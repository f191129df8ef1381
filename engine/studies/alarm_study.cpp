#include "engine/studies/alarm_study.h"

#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/base/units.h"
#include "engine/control/feasibility.h"
#include "engine/model/mounting_check.h"
#include "engine/rig/rig_setup.h"
#include "engine/runtime/fault_script.h"
#include "engine/runtime/servo_loop.h"
#include "engine/runtime/target_watch.h"
#include "engine/studies/camera_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <set>

namespace bask {
namespace {

constexpr double kAfterFault_s = 900.0; // from a fault to the end of its run
constexpr double kTellingOf_K = 1.0;    // a limit is truly met within this, of noise and offset
constexpr double kBareEmittance = 0.5;
constexpr std::size_t kTellingOf_px = 3; // an object is truly too small within this, of where the robot was
constexpr double kWindow_s = 600.0;
constexpr double kStudyTolerance = 1e-6; // of the plant's view factors

/// One run: rig and loop, its operator, its fault, and what is seen of them.
class AlarmRun {
public:
    explicit AlarmRun(const AlarmCase& drawn)
        : m_drawn(drawn), m_experiment(drawn.experiment), m_rig(config(drawn.experiment)),
          m_thermometer(objectThermometer(drawn.experiment, m_rig)),
          m_loop(drawn.experiment,
                 {m_rig.robot(),
                  m_thermometer ? *m_thermometer : m_rig.thermometer(),
                  m_rig.heatSource(),
                  {},
                  &m_rig.sourceTracker(),
                  false,
                  m_thermometer.get()},
                 m_rig.clock()),
          m_sight(drawn.experiment), m_wasReadCold(drawn.experiment.objects.size(), false) {
        m_row.drawn = factsOf(drawn);
        m_rig.simulatedThermometer().setOffLag(drawn.offLag_s);
    }

    AlarmStudyRow run() {
        for (int i = 0; i < 4 * m_experiment.sampling.window && m_loop.state() != RunState::Ready; ++i)
            period();
        if (!begin())
            return m_row;
        m_start_s = m_rig.clock().now_s();
        while (time_s() < end_s() && !isOver())
            period();
        m_row.simulated_s = time_s();
        return m_row;
    }

private:
    static AlarmRunFacts factsOf(const AlarmCase& drawn) {
        const Experiment& e = drawn.experiment;
        const auto& camera = e.simulation.thermalCamera;
        double emittanceError = 0.0;
        for (const ObjectSpec& object : e.objects) {
            const double error = object.material.emittance - trueMaterial(object).emittance;
            emittanceError = std::abs(error) > std::abs(emittanceError) ? error : emittanceError;
        }
        return {e.controller.kind.key(),
                static_cast<int>(e.objects.size()),
                e.source.temperature_K,
                e.source.model,
                e.simulation.sensorNoise_K,
                e.simulation.sensorLag_s,
                e.simulation.convection_W_m2K,
                e.objects.front().readBy,
                camera ? camera->noise_K : 0.0,
                emittanceError,
                drawn.fault.fault,
                isOfObject(drawn.fault.fault) ? e.objects[drawn.fault.object].name : std::string(),
                drawn.fault.time_s};
    }
    static SimulatedRigConfig config(const Experiment& experiment) {
        SimulatedRigConfig config = simulatedRigConfig(experiment);
        config.viewFactorTolerance = kStudyTolerance;
        if (config.thermalCamera)
            config.thermalCamera->showsObjectsOnly = true;
        return config;
    }
    bool isHealthy() const { return m_drawn.fault.fault == SimulatedFault::None; }
    double time_s() const { return m_rig.clock().now_s() - m_start_s; }
    double end_s() const { return isHealthy() ? m_drawn.duration_s : m_drawn.fault.time_s + kAfterFault_s; }
    // A false trip ends a healthy run. Of a fault that is found what follows within the window counts.
    bool isOver() const {
        return isHealthy() ? m_loop.state() == RunState::Fault
                           : m_row.acted_s && time_s() > m_drawn.fault.time_s + *m_row.acted_s + kWindow_s;
    }

    bool begin() {
        Result<void> begun = m_loop.arm();
        if (begun)
            begun = m_loop.start(true);
        if (!begun)
            m_row.refusal = describe(begun.error().message);
        m_isPausedByPerson = m_isEndedByPerson = false;
        return static_cast<bool>(begun);
    }

    void act() {
        using Kind = AlarmAction::Kind;
        for (; m_next < m_drawn.actions.size() && m_drawn.actions[m_next].time_s <= time_s(); ++m_next) {
            const AlarmAction& action = m_drawn.actions[m_next];
            if (action.kind == Kind::SetTargets)
                (void)m_loop.setTargets(action.targets_K);
            else if (action.kind == Kind::Hold && m_loop.hold())
                m_isPausedByPerson = true;
            else if (action.kind == Kind::Resume && m_isPausedByPerson && m_loop.resume())
                m_isPausedByPerson = false;
            else if (action.kind == Kind::Stop && m_loop.stop()) {
                m_isEndedByPerson = true;
                m_again = action.targets_K;
            }
        }
        if (m_loop.state() == RunState::Stopped && !m_again.empty()) {
            (void)m_loop.setTargets(std::exchange(m_again, {}));
            (void)begin();
        }
    }

    void beginFault() {
        if (isHealthy() || m_isFaulty || time_s() < m_drawn.fault.time_s)
            return;
        m_isFaulty = true;
        m_frozen_K = m_loop.latest().objects[m_drawn.fault.object].measured_K;
        setFault(m_rig, m_drawn.fault.fault, m_drawn.fault.object, true);
    }

    void period() {
        if (m_start_s >= 0.0) {
            act();
            beginFault();
        }
        m_rig.advance(m_experiment.sampling.period_s);
        m_loop.tick();
        (void)m_loop.takeRecord();
        if (m_start_s >= 0.0)
            look();
        else if (m_thermometer)
            noteReadCold();
    }

    /// Which objects the camera could read before there was heat: only then it is zeroed.
    void noteReadCold() {
        for (std::size_t i = 0; i < m_wasReadCold.size(); ++i)
            m_wasReadCold[i] = m_wasReadCold[i] || !isUnread(i, {MessageCode::ThermalFaceSmall, {}});
    }

    void look() {
        const std::vector<double> true_K = m_rig.trueTemperatures_K();
        for (std::size_t i = 0; i < true_K.size(); ++i) {
            m_row.overTrip_K =
                std::max(m_row.overTrip_K, true_K[i] - tripLimit_K(m_experiment, m_experiment.objects[i]));
            m_row.overTarget_K =
                std::max(m_row.overTarget_K, true_K[i] - m_loop.latest().objects[i].target_K);
        }
        lookAtFault(true_K);
        lookAtAlarms(true_K);
        lookAtRun();
    }

    bool areBothSeen() {
        const Message small{MessageCode::ThermalFaceSmall, {}};
        return !isUnread(m_drawn.fault.object, small) && !isUnread(otherOfSwapped(), small);
    }

    void lookAtFault(const std::vector<double>& true_K) {
        if (!m_isFaulty)
            return;
        const double now_s = time_s() - m_drawn.fault.time_s;
        if (m_drawn.fault.fault == SimulatedFault::SensorsSwapped && now_s <= kAlarmSoon_s && areBothSeen())
            m_row.apartSoon_K = std::max(m_row.apartSoon_K,
                                         std::abs(true_K[m_drawn.fault.object] - true_K[otherOfSwapped()]));
        if (m_row.acted_s)
            return;
        const double of_K = true_K[m_drawn.fault.object];
        bool isShown = true;
        if (m_drawn.fault.fault == SimulatedFault::SensorFrozen) {
            m_row.unseen_K = std::max(m_row.unseen_K, std::abs(of_K - m_frozen_K));
            isShown = m_row.unseen_K >= kAlarmShown_K;
        } else if (m_drawn.fault.fault == SimulatedFault::SensorOff) {
            const bool isHeated = m_loop.latest().objects[m_drawn.fault.object].viewFactor > kAlarmHeated;
            if (const double told_K =
                    m_loop.readings().sensors().told_K(m_drawn.fault.object, m_rig.clock().now_s());
                isHeated && std::isfinite(told_K))
                m_row.unseen_K = std::max(m_row.unseen_K, std::abs(of_K - told_K));
            isShown = m_row.unseen_K >= kAlarmShown_K;
        } else if (m_drawn.fault.fault == SimulatedFault::SensorsSwapped) {
            if (areBothSeen())
                m_row.unseen_K = std::max(m_row.unseen_K, std::abs(of_K - true_K[otherOfSwapped()]));
            isShown = m_row.unseen_K >= kAlarmShown_K;
        } else if (m_drawn.fault.fault == SimulatedFault::ObjectHot) {
            isShown = of_K > warningLimit_K(m_experiment, m_experiment.objects[m_drawn.fault.object]);
        } else if (m_drawn.fault.fault == SimulatedFault::SourceHeatsAlone ||
                   m_drawn.fault.fault == SimulatedFault::SourceKeepsHeat) {
            isShown = m_isEndedByPerson;
        } else if (m_drawn.fault.fault == SimulatedFault::SourceNotHeating) {
            isShown = !m_row.isTripped; // of a run that had ended there is no heat to miss
        }
        if (isShown && !m_row.shown_s)
            m_row.shown_s = now_s;
    }

    void lookAtAlarms(const std::vector<double>& true_K) {
        std::set<std::string> present;
        for (const AlarmCondition& condition : m_loop.alarmConditions()) {
            present.insert(condition.key);
            if (m_present.contains(condition.key))
                continue;
            m_row.alarms.push_back({time_s(), condition.priority, messageName(condition.message.code),
                                    describe(condition.message), !condition.cause.empty(),
                                    isHealthy() && !isTrue(condition.message, true_K)});
            if (m_isFaulty && !m_row.told_s && isOfFault(condition.message))
                m_row.told_s = time_s() - m_drawn.fault.time_s;
        }
        m_present = std::move(present);
        // Told, and something is done about it: the run holds or ends, or it had ended.
        if (m_row.told_s && !m_row.acted_s && m_loop.state() != RunState::Running &&
            m_loop.state() != RunState::Settled)
            m_row.acted_s = time_s() - m_drawn.fault.time_s;
    }

    void lookAtRun() {
        const RunState state = m_loop.state();
        const bool isPaused = state == RunState::Holding && !m_isPausedByPerson;
        const bool isEnded = (state == RunState::Stopping || state == RunState::Fault) && !m_isEndedByPerson;
        m_row.isTripped = m_row.isTripped || isPaused || isEnded || state == RunState::Fault;
    }

    /// Of a run without a fault: an object may truly be too warm. What a controller says of its targets is
    /// advice, not a condition of the rig.
    bool isTrue(const Message& message, const std::vector<double>& true_K) {
        if (message.code == MessageCode::EventCompromise)
            return true;
        for (std::size_t i = 0; i < true_K.size(); ++i) {
            const ObjectSpec& object = m_experiment.objects[i];
            if (message.args.empty() || message.args.front() != object.name)
                continue;
            if (message.code == MessageCode::SafetyCameraCannotCheck ||
                message.code == MessageCode::SafetyCameraCannotRead)
                return isUnread(i, message.args.at(1).sentences().at(0));
            if (message.code == MessageCode::SafetyTargetLeft)
                return std::abs(true_K[i] - m_loop.experiment().objects[i].target_K) >
                       TargetWatch::kFar_K - tellingOf_K(i);
            if (message.code == MessageCode::SafetyObjectWarm)
                return true_K[i] > warningLimit_K(m_experiment, object) - tellingOf_K(i);
            if (message.code == MessageCode::SafetyObjectHot)
                return true_K[i] > tripLimit_K(m_experiment, object) - tellingOf_K(i);
        }
        return false;
    }

    /// A camera states by how much it may err beside a hot source: two of its standard uncertainties.
    double tellingOf_K(std::size_t i) const {
        if (m_experiment.objects[i].readBy != ReadBy::Camera)
            return kTellingOf_K;
        return std::fmax(kTellingOf_K, 2.0 * m_loop.latest().objects[i].camera.uncertainty_K);
    }

    /// Whether the camera truly cannot read an object for a reason.
    bool isUnread(std::size_t object, const Message& reason) {
        switch (reason.code) {
        case MessageCode::ThermalFaceOutside:
        case MessageCode::ThermalFaceGrazing:
        case MessageCode::ThermalFaceSmall:
        case MessageCode::ThermalFaceHidden:
            return m_sight.pixels(m_rig.simulatedRobot().coordinates())[object] <
                   static_cast<std::size_t>(rigPixels().minPixels) + kTellingOf_px;
        case MessageCode::ThermalNotZeroed:
            return !m_wasReadCold[object];
        case MessageCode::ThermalFaceUnusable: // what is painted can be read, bare metal cannot
            return trueMaterial(m_experiment.objects[object]).emittance < kBareEmittance;
        default:
            return false;
        }
    }

    /// Whether an alarm is about what has the fault.
    bool isOfFault(const Message& message) const {
        if (message.code == MessageCode::EventCompromise ||
            message.code == MessageCode::SafetyCameraCannotCheck)
            return false;
        if (!isOfObject(m_drawn.fault.fault))
            return true;
        const auto isAbout = [&](std::size_t object) {
            return !message.args.empty() && message.args.front() == m_experiment.objects[object].name;
        };
        return isAbout(m_drawn.fault.object) ||
               (m_drawn.fault.fault == SimulatedFault::SensorsSwapped && isAbout(otherOfSwapped()));
    }

    std::size_t otherOfSwapped() const { return (m_drawn.fault.object + 1) % m_experiment.objects.size(); }

    const AlarmCase m_drawn;
    const Experiment m_experiment;
    SimulatedRig m_rig;
    std::unique_ptr<ObjectThermometer> m_thermometer; ///< null without a thermal camera
    ServoLoop m_loop;
    CameraSight m_sight;
    std::vector<bool> m_wasReadCold; ///< objects by the camera
    AlarmStudyRow m_row;
    double m_start_s = -1.0;
    std::size_t m_next = 0;
    std::vector<double> m_again; ///< targets of the run after a stopped one
    bool m_isPausedByPerson = false, m_isEndedByPerson = false;
    bool m_isFaulty = false;
    double m_frozen_K = 0.0;
    std::set<std::string> m_present; ///< alarms by key
};

std::string decimal(double value) {
    return formatNumber(value, 7);
}

std::string inQuotes(std::string text) {
    for (auto at = text.find('"'); at != std::string::npos; at = text.find('"', at + 2))
        text.insert(at, 1, '"');
    return '"' + text + '"';
}

/// Most alarms of any window of ten minutes.
int maxInWindow(const std::vector<RaisedAlarm>& alarms) {
    int max = 0;
    for (std::size_t first = 0, last = 0; last < alarms.size(); ++last) {
        while (alarms[last].time_s - alarms[first].time_s > kWindow_s)
            ++first;
        max = std::max(max, static_cast<int>(last - first + 1));
    }
    return max;
}

void addTo(std::array<int, 3>& sums, const std::array<int, 3>& counts) {
    for (std::size_t p = 0; p < sums.size(); ++p)
        sums[p] += counts[p];
}

/// Of alarms with their faults as often as a laboratory meets them, not as often as they were drawn.
std::array<double, 3> sharesOfPriorities(const std::vector<FaultSummary>& faults,
                                         const std::vector<std::array<int, 3>>& alarms) {
    std::array<double, 3> shares{};
    double all = 0.0;
    for (std::size_t k = 0; k < faults.size(); ++k)
        for (std::size_t p = 0; p < shares.size() && faults[k].draws > 0; ++p) {
            const double alarmsPerTime =
                alarmFaultFrequency(faults[k].fault) * alarms[k][p] / faults[k].draws;
            shares[p] += alarmsPerTime;
            all += alarmsPerTime;
        }
    for (double& share : shares)
        share /= all > 0.0 ? all : 1.0;
    return shares;
}

void add(FaultSummary& summary, const AlarmStudyRow& row, std::vector<double>& delays_s) {
    ++summary.draws;
    summary.overTrip_K = std::max(summary.overTrip_K, row.overTrip_K);
    const bool isToldOnly =
        row.drawn.fault == SimulatedFault::SensorFrozen ||
        (row.drawn.fault == SimulatedFault::CameraLost && row.drawn.readBy == ReadBy::Both);
    const auto found_s = isToldOnly ? row.told_s : row.acted_s;
    summary.shown += row.shown_s || found_s;
    summary.acted += row.acted_s.has_value();
    if (!found_s) {
        summary.unseen_K = std::max(summary.unseen_K, row.unseen_K);
        return;
    }
    ++summary.found;
    delays_s.push_back(row.shown_s ? std::max(0.0, *found_s - *row.shown_s) : 0.0);
}

} // namespace

Result<void> check(const AlarmStudy& study) {
    for (const Experiment& rig : study.rigs) {
        if (auto valid = validate(rig); !valid)
            return valid;
        if (auto mounting = checkMounting(rig); !mounting)
            return mounting;
    }
    return {};
}

AlarmStudyRow runAlarmCase(const AlarmStudy& study, int index) {
    return AlarmRun(drawAlarmCase(study.rigs, study.draw, study.readBy, study.seed, study.first - 1 + index))
        .run();
}

Result<std::vector<AlarmStudyRow>> runAlarmStudy(const AlarmStudy& study, int threads,
                                                 const std::function<void(int done)>& progress) {
    if (const auto valid = check(study); !valid)
        return valid.error();
    std::vector<AlarmStudyRow> rows(static_cast<std::size_t>(study.count));
    runInParallel(
        study.count, threads,
        [&](int index) { rows[static_cast<std::size_t>(index)] = runAlarmCase(study, index); }, progress);
    return rows;
}

AlarmSummary summarize(const std::vector<AlarmStudyRow>& rows) {
    AlarmSummary summary;
    for (int i = 1; i < kSimulatedFaults; ++i)
        summary.faults.push_back({static_cast<SimulatedFault>(i)});
    std::vector<std::vector<double>> delays_s(summary.faults.size());
    std::vector<std::array<int, 3>> ofFault(summary.faults.size());
    for (const AlarmStudyRow& row : rows) {
        summary.hours += row.simulated_s / 3600.0;
        summary.refused += !row.refusal.empty();
        summary.overTrip_K = std::max(summary.overTrip_K, row.overTrip_K);
        summary.maxIn10min = std::max(summary.maxIn10min, maxInWindow(row.alarms));
        const auto falseWords = std::ranges::count_if(row.alarms, &RaisedAlarm::isFalse);
        summary.falseWords += static_cast<int>(falseWords);
        summary.falseTrips += row.isTripped && falseWords > 0;
        std::array<int, 3> causes{};
        for (const RaisedAlarm& alarm : row.alarms)
            causes[static_cast<std::size_t>(std::clamp(alarm.priority, 1, 3) - 1)] += !alarm.isConsequence;
        addTo(summary.alarms, causes);
        const auto fault = std::ranges::find(summary.faults, row.drawn.fault, &FaultSummary::fault);
        if (fault == summary.faults.end())
            continue;
        const auto k = static_cast<std::size_t>(fault - summary.faults.begin());
        add(*fault, row, delays_s[k]);
        addTo(ofFault[k], causes);
    }
    for (std::size_t k = 0; k < delays_s.size(); ++k) {
        std::vector<double>& delays = delays_s[k];
        if (delays.empty())
            continue;
        std::ranges::sort(delays);
        summary.faults[k].median_s = delays[delays.size() / 2];
        summary.faults[k].worst_s = delays.back();
    }
    summary.shares = sharesOfPriorities(summary.faults, ofFault);
    std::erase_if(summary.faults, [](const FaultSummary& fault) { return fault.draws == 0; });
    for (std::size_t p = 0; p < summary.alarms.size(); ++p)
        summary.per10min[p] = summary.hours > 0.0 ? summary.alarms[p] / (6.0 * summary.hours) : 0.0;
    return summary;
}

std::string alarmCsv(const AlarmStudy& study, const std::vector<AlarmStudyRow>& rows) {
    std::string text =
        "# Bask alarm study: runs at random on the simulated rig, their alarms against what is true, seed " +
        std::to_string(study.seed) +
        ".\n"
        "# Times since the first Start. shown_s, told_s, acted_s: since the fault began; shown: its sensor "
        "is " +
        decimal(kAlarmShown_K) +
        " K from its object (frozen, off), both objects so far apart (swapped), the object over its warning "
        "limit, else at once;\n"
        "# told: an alarm is of it; acted: and the run holds or has ended. over_trip_K: hottest true "
        "temperature "
        "over its object's trip limit. false: alarms that state what is not so. Each alarm: time, priority, "
        "follows (from another).\n"
        "run,simulated_s,controller,objects,source_degC,source_model,noise_K,lag_s,convection_W_m2K,read_by,"
        "camera_noise_K,emittance_error,fault,object,fault_s,shown_s,told_s,acted_s,unseen_K,tripped,false,"
        "over_trip_K,over_target_K,alarms\n";
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const AlarmStudyRow& row = rows[k];
        const AlarmRunFacts& drawn = row.drawn;
        const auto optional = [](const std::optional<double>& value) {
            return value ? decimal(*value) : std::string();
        };
        std::string alarms = row.refusal;
        for (const RaisedAlarm& alarm : row.alarms)
            alarms += (alarms.empty() ? "" : "; ") + decimal(alarm.time_s) + " s, " +
                      std::to_string(alarm.priority) + (alarm.isConsequence ? ", follows" : "") +
                      (alarm.isFalse ? ", false: " : ": ") + alarm.sentence;
        const bool isFaulty = drawn.fault != SimulatedFault::None;
        text += std::to_string(study.first + static_cast<int>(k)) + ',' + decimal(row.simulated_s) + ',' +
                drawn.controller + ',' + std::to_string(drawn.objects) + ',' +
                decimal(celsiusFromKelvin(drawn.source_K)) + ',' +
                (drawn.sourceModel == SourceModel::Gray ? "gray" : "paper") + ',' + decimal(drawn.noise_K) +
                ',' + decimal(drawn.lag_s) + ',' + decimal(drawn.convection_W_m2K) + ',' +
                readByName(drawn.readBy) + ',' + decimal(drawn.cameraNoise_K) + ',' +
                decimal(drawn.emittanceError) + ',' + simulatedFaultName(drawn.fault) + ',' +
                (drawn.object.empty() ? std::string() : inQuotes(drawn.object)) + ',' +
                (isFaulty ? decimal(drawn.fault_s) : std::string()) + ',' + optional(row.shown_s) + ',' +
                optional(row.told_s) + ',' + optional(row.acted_s) + ',' + decimal(row.unseen_K) + ',' +
                (row.isTripped ? '1' : '0') + ',' +
                std::to_string(std::ranges::count_if(row.alarms, &RaisedAlarm::isFalse)) + ',' +
                decimal(row.overTrip_K) + ',' + decimal(row.overTarget_K) + ',' + inQuotes(alarms) + '\n';
    }
    return text;
}

} // namespace bask
