#pragma once
// The readings of a rig's devices, taken once in each sampling period, and what follows from them alone.

#include "engine/base/clock.h"
#include "engine/control/rig_geometry.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/source_tracker.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/model/trace_sample.h"
#include "engine/rig/object_thermometer.h"
#include "engine/runtime/sensor_channels.h"
#include "engine/runtime/snapshot.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// The devices of a rig, borrowed for the loop's lifetime.
struct RigDevices {
    Robot& robot;
    Thermometer& thermometer;
    HeatSource& source;
    /// True temperatures of the plant, K, if the rig is simulated; otherwise an empty function.
    std::function<std::vector<double>()> truth;
    /// Used if the experiment's source is tracked; may be null.
    SourceTracker* tracker = nullptr;
    /// A real rig starts in a fault until a person has looked and reset, and its source may be hot with the
    /// heat off.
    bool isReal = false;
    /// The same as the thermometer, if the rig has a thermal camera; null if it has none.
    ObjectThermometer* byCamera = nullptr;
};

/// Which devices have ever answered since they were first given to a loop.
struct RigAnswers {
    double made_s = 0.0; ///< when they were first given to a loop
    bool hasThermometer = false, hasRobot = false, hasSource = false;
};

/// Borrows its arguments for its lifetime. One thread.
class RigReadings {
public:
    /// Writes the measured values into `sample` at each read().
    RigReadings(const Experiment& experiment, const RigDevices& devices, const Clock& clock,
                TraceSample& sample);

    /// Reads all devices.
    void read();
    /// Writes the sensors' values into the sample again, as they are after zeroing.
    void takeSensors();

    SensorChannels& sensors() { return m_sensors; }
    const SensorChannels& sensors() const { return m_sensors; }
    const TraceSample& sample() const { return m_sample; }
    double sampleTime_s() const { return m_sampleTime_s; }

    /// Geometry with the source where it was seen last. For a real rig the limits are slightly tighter than
    /// the experiment's.
    const std::shared_ptr<const RigGeometry>& geometry() const { return m_geometry; }
    /// Pose coordinates of the end-effector, as last reported by the robot; before that, the experiment's
    /// start.
    const Vector6d& coordinates() const { return m_coordinates; }
    const RobotState& robot() const { return m_robot; }
    /// Whether the robot answered at the last read().
    bool isRobotTelling() const { return m_isRobotTelling; }

    /// Newest temperature of the source, K, measured or typed; empty if it is invalid or the source does not
    /// answer.
    const std::optional<double>& source_K() const { return m_source_K; }
    /// Age of sample().source_K, s; infinite if the source has not given any value.
    double sourceAge_s() const;
    /// Time of the source's newest valid temperature; before the first one, the time of construction.
    double sourceRead_s() const { return m_sourceRead_s; }
    /// Net power of the source as a fraction of the power at the experiment's source temperature.
    double sourceStrength() const { return m_sourceStrength; }
    /// T3, K, as measured by zeroing; before that, as the experiment states it.
    double environment_K() const;

    /// Whether the pose of a tracked source was measured lately; true for one that is not tracked.
    bool isSourceSeen() const;
    /// Whether the pose of a tracked source was ever measured.
    bool wasSourceSeen() const { return m_sourceSeen_s >= 0.0; }
    /// How the source is followed; empty if it is not tracked.
    std::optional<SourceTracking> tracking() const;

    const RigAnswers& answers() const { return m_answers; }
    void use(const RigAnswers& answers) { m_answers = answers; }
    /// Returns whether a device has not answered yet, but still has time to.
    bool isConnecting() const;
    /// Why a device does not answer; the code is None if it does, or if it still has time to.
    const Message& thermometerProblem() const { return m_thermometerProblem; }
    const Message& robotProblem() const { return m_robotProblem; }
    const Message& sourceProblem() const { return m_sourceProblem; }
    /// Returns the problem for another answer of the source, by the same rule.
    Message sourceProblem(const Result<void>& answer) const { return problemOf(answer, m_answers.hasSource); }
    /// Returns the devices that are not set up: this is not an error, but no run can begin.
    std::vector<Message> missing() const;

    /// The rig's thermal camera; null if it has none.
    const ObjectThermometer* byCamera() const { return m_devices.byCamera; }
    /// Why a sensor gives no value, in a sentence about its object.
    Message noReading(std::size_t object) const;

    /// Errors: the sensor is not trusted, or it has given no valid value lately.
    Result<void> requireFreshSensor(std::size_t object) const;
    Result<void> requireFreshSensors() const;
    /// Returns the message about an untrusted sensor: its reading, and the range in which its object can be,
    /// if that is known.
    Message distrust(std::size_t object) const;

    bool allWithinBand() const;
    /// Returns the objects outside the band with their errors: "circle +1.2 K, hand -0.8 K".
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
    Eigen::VectorXd m_unshaded; ///< view factors; a member, so that it is not allocated at every sample
    SensorChannels m_sensors;
    double m_sampleTime_s = 0.0;
    RigAnswers m_answers;
    Message m_thermometerProblem, m_robotProblem, m_sourceProblem; ///< code None: no problem
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
