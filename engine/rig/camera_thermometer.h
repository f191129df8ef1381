#pragma once
// A thermal camera as the rig's thermometer: what it tells of each object, with the reflection of the source
// computed for the pose at which the frame was taken.

#include "engine/control/rig_geometry.h"
#include "engine/devices/heat_source.h"
#include "engine/devices/robot.h"
#include "engine/devices/thermal_camera.h"
#include "engine/devices/thermometer.h"
#include "engine/model/experiment.h"
#include "engine/thermography/face_thermometer.h"

#include <deque>
#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// What the thermometer knows of the rig; emittances are those of the camera's band.
struct CameraThermometerSetup {
    CameraModel camera;
    Pose X_RC = Pose::Identity();
    std::vector<ObjectSpec> objects;
    std::vector<PlateSpec> fixtures, shields;
    Shape source;                                ///< at the geometry's X_RS
    std::shared_ptr<const RigGeometry> geometry; ///< of these objects
    double sourceEmittance = 1.0;
    double environment_K = 298.15;
    /// The source is behind a shutter: with the heat off the objects see the room instead.
    bool hasShutter = false;
};

/// Frames before any heat have to show the objects as cold as the room: with the first that does so the
/// camera is zeroed on an object. Until then, while an object cannot be read, and while the robot does not
/// know its place, its reading is invalid. The pose at a frame's time is between those of two readings, on a
/// line. The source is taken for even and stays where it is; what neighbours emit is not reflected: in one
/// plane they do not see one another. Use it on the engine thread.
class CameraThermometer final : public Thermometer {
public:
    /// The devices must outlive it.
    CameraThermometer(CameraThermometerSetup setup, ThermalCamera& camera, Robot& robot, HeatSource& source);

    int channels() const override { return static_cast<int>(m_setup.objects.size()); }
    /// Errors: those of robot and camera.
    Result<std::vector<Reading>> read() override;
    /// Returns why an object could not be read the last time; None if it could, or if it is not yet zeroed.
    Message reason(std::size_t object) const { return m_reasons.at(object); }

private:
    /// What the rig's other devices told when the thermometer was read.
    struct Moment {
        double time_s;
        Vector6d q;
        bool isPlaceSure;
        std::optional<double> source_K; ///< what the objects see; empty: unknown
    };
    std::optional<double> seenSource_K();
    Vector6d placeAt(double time_s) const;
    const Moment& nearest(double time_s) const;
    std::vector<ReadObject> objectsAt(const Vector6d& q, double source_K) const;
    std::vector<PlacedPlate> screensAt(const Vector6d& q) const;

    CameraThermometerSetup m_setup;
    ThermalCamera& m_camera;
    Robot& m_robot;
    HeatSource& m_source;
    PixelRays m_rays;
    std::deque<Moment> m_moments;
    std::uint64_t m_number = 0; ///< of the last frame
    bool m_wasHeated = false;
    std::vector<std::optional<CameraZero>> m_zeros;
    std::vector<Reading> m_readings;
    std::vector<Message> m_reasons;
};

} // namespace bask
