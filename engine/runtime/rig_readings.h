#pragma once
// What the devices of a rig tell, read once a sampling period, and what follows from that alone.

#include "engine/base/clock.h"
#include "engine/control/rig_geometry.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/source_tracker.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/model/trace_sample.h"
#include "engine/runtime/sensor_channels.h"
#include "engine/runtime/snapshot.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// The devices of a rig, borrowed for the loop's life.
struct RigDevices {
    Robot& robot;
    Thermometer& thermometer;
    HeatSource& source;
    /// The plant's own temperatures, K, where the rig is simulated; empty function otherwise.
    std::function<std::vector<double>()> truth;
    /// Asked where the experiment's source is tracked; may be null.
    SourceTracker* tracker = nullptr;
    /// Faulted from the start, until a person has looked and reset; and its source is hot with the heat off.
    bool isReal = false;
};

/// Which devices have answered, ever, since they were given to a loop first.
struct RigAnswers {
    double made_s = 0.0; ///< when they were given
    bool hasThermometer = false, hasRobot = false, hasSource = false;
};

/// Borrows its arguments for its life. One thread.
class RigReadings {
public:
    /// Writes what is measured into `sample` at each read().
    RigReadings(const Experiment& experiment, const RigDevices& devices, const Clock& clock,
                TraceSample& sample);

    /// Reads all devices.
    void read();
    /// Takes the sensors' values into the sample again, as they are after zeroing.
    void takeSensors();

    SensorChannels& sensors() { return m_sensors; }
    const SensorChannels& sensors() const { return m_sensors; }
    const TraceSample& sample() const { return m_sample; }
    double sampleTime_s() const { return m_sampleTime_s; }

    /// With the source where it was seen last; of a real rig a little inside of its limits.
    const std::shared_ptr<const RigGeometry>& geometry() const { return m_geometry; }
    /// Pose coordinates of the end-effector, as the robot told them last; before, the experiment's start.
    const Vector6d& coordinates() const { return m_coordinates; }
    const RobotState& robot() const { return m_robot; }
    /// The robot answered at the last read().
    bool isRobotTelling() const { return m_isRobotTelling; }

    /// Newest valid temperature of the source, K, or as typed; empty if it is invalid or does not answer.
    const std::optional<double>& source_K() const { return m_source_K; }
    /// Age of sample().source_K, s; infinite while the source has told none.
    double sourceAge_s() const;
    /// Time of the source's newest valid temperature; before, of construction.
    double sourceRead_s() const { return m_sourceRead_s; }
    /// Net power of the source as a fraction of what the experiment states.
    double sourceStrength() const { return m_sourceStrength; }
    /// T3, K, as measured by zeroing; before, as the experiment states it.
    double environment_K() const;

    /// Whether the pose of a tracked source was measured lately; true for one that is not tracked.
    bool isSourceSeen() const;
    /// Whether it was ever seen.
    bool wasSourceSeen() const { return m_sourceSeen_s >= 0.0; }
    /// Empty if the source is not tracked.
    std::optional<SourceTracking> tracking() const;

    const RigAnswers& answers() const { return m_answers; }
    void use(const RigAnswers& answers) { m_answers = answers; }
    /// A device that has told nothing yet has still time to.
    bool isConnecting() const;
    /// Why a device does not answer, of code None if it does or has still time to.
    const Message& thermometerProblem() const { return m_thermometerProblem; }
    const Message& robotProblem() const { return m_robotProblem; }
    const Message& sourceProblem() const { return m_sourceProblem; }
    /// The same of another answer of the source.
    Message sourceProblem(const Result<void>& answer) const { return problemOf(answer, m_answers.hasSource); }
    /// Devices that are not set up: nothing is wrong with them, and nothing can be begun.
    std::vector<Message> missing() const;

    /// Errors: a sensor that is not believed, or has told nothing valid lately.
    Result<void> requireFreshSensor(std::size_t object) const;
    Result<void> requireFreshSensors() const;
    /// What a sensor that is not believed tells, and where its object can be, if that is known.
    Message distrust(std::size_t object) const;

    bool allWithinBand() const;
    /// Objects outside of the band with their errors: "circle +1.2 K, hand -0.8 K".
    MessageArg objectsOffTarget() const;

private:
    void readSensors();
    void readSourcePose();
    bool facesObjects(const Pose& X_RS) const;
    void readRobot();
    void readViewFactors();
    void readSource();
    bool isAwaited(bool hasAnswered) const;
    template <class Answer> Message problemOf(const Answer& answer, bool hasAnswered) const {
        const Message problem = answer ? Message{} : answer.error().message;
        return problem.code != MessageCode::RigIncomplete && isAwaited(hasAnswered) ? Message{} : problem;
    }

    const Experiment& m_experiment;
    const RigDevices& m_devices;
    const Clock& m_clock;
    TraceSample& m_sample;
    std::shared_ptr<const RigGeometry> m_geometry;
    SensorChannels m_sensors;
    double m_sampleTime_s = 0.0;
    RigAnswers m_answers;
    Message m_thermometerProblem, m_robotProblem, m_sourceProblem; ///< None: none
    RobotState m_robot;
    bool m_isRobotTelling = false;
    Vector6d m_coordinates;
    std::optional<double> m_source_K;
    double m_sourceRead_s;
    double m_sourceStrength = 1.0;
    double m_sourceSeen_s = -1e300;
    PoseReading m_sourceReading;
};

} // namespace bask
