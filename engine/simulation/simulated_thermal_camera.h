#pragma once
// A simulated thermal camera: renders the radiance of the true rig, with the source's reflections by the true
// view factors, and hands out frames through the decoder of a real camera.

#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"
#include "engine/devices/thermal_camera.h"
#include "engine/shape/shape.h"
#include "engine/simulation/scene_painter.h"
#include "engine/simulation/thermal_sensor.h"
#include "engine/thermal/source_emission.h"
#include "engine/thermography/face_temperature.h"
#include "engine/thermography/usual_thermal_camera.h"

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// Returns the camera's numbers for a picture as its bytes: the inverse of frameOfBytes. What is colder or
/// hotter than it can tell is its least or largest number.
std::string bytesOfFrame(const ThermalPicture& picture, const ThermalProfile& profile);

struct SimulatedThermalCameraConfig {
    ThermalProfile profile;
    CameraModel camera; ///< of the profile's size
    Pose X_RC = usualThermalPose();
    /// A plate that radiates along +z of P, its back being as cold as the room.
    struct HotPlate {
        Shape shape;
        Pose X_SP = Pose::Identity();
        double emittance = 1.0;
        PartTemperature temperature{}; ///< by the source's own, for SimulatedRig
    };
    std::vector<HotPlate> source; ///< in one plane a later one covers an earlier one
    struct Object {
        Shape shape;
        Pose X_EO = Pose::Identity();
    };
    std::vector<Object> objects;
    std::vector<Object> fixtures; ///< as cold as the room, with the objects
    struct Shield {
        Shape shape;
        Pose X_RB = Pose::Identity();
    };
    std::vector<Shield> shields; ///< as cold as the room, fixed
    double environment_K = 298.15;
    ThermalSensorErrors errors{};
    double delay_s = 0.1; ///< from the exposure to the delivered frame, at least
    /// The picture is as warm as the room, without noise, where no object is near: three times as fast,
    /// for many runs in which nobody looks at it.
    bool showsObjectsOnly = false;
};

/// The rig at one time, in true values.
struct ThermalMoment {
    double time_s = 0.0;
    Pose X_RE = Pose::Identity();
    Pose X_RS = Pose::Identity();
    std::vector<double> source_K; ///< of each hot plate
    struct Object {
        double T_K = 0.0;
        FaceSurroundings front, back; ///< what each of its faces reflects
    };
    std::vector<Object> objects;
};

/// Call observe() and the setters from one thread (the engine's), and newest() from one thread, which
/// renders.
class SimulatedThermalCamera final : public ThermalCamera {
public:
    /// Throws std::invalid_argument for a camera of another size than the profile's, and one without a frame
    /// rate.
    explicit SimulatedThermalCamera(SimulatedThermalCameraConfig config);

    /// Returns a frame of the newest moment that is delay_s old (at first, of the first one). CameraLost
    /// before the first moment and while it is unplugged.
    Result<std::shared_ptr<const ThermalCameraFrame>> newest() override;
    const ThermalProfile& profile() const override { return m_config.profile; }
    const SimulatedThermalCameraConfig& config() const { return m_config; }
    const BandRadiance& band() const { return *m_band; }

    /// Shows the rig. Throws std::invalid_argument for another number of objects or hot plates.
    void observe(const ThermalMoment& moment);
    /// Shows a warm board in front of the camera, whose dark fields reflect the room; it moves as that of
    /// SimulatedCamera. Empty: none.
    void setBoard(std::optional<Board> board);
    void setUnplugged(bool unplugged);

private:
    GreyCanvas room() const;
    struct ShownBoard {
        Board board;
        double since_s = 0.0;
    };
    /// Parts of the picture that are rendered.
    std::vector<PixelBox> parts(const ThermalMoment& moment) const;
    const GreyCanvas& painted(const ThermalMoment& moment, const std::optional<ShownBoard>& shown);

    double radianceOf(const FaceSurroundings& face, double T_K) const;

    const SimulatedThermalCameraConfig m_config;
    std::shared_ptr<const BandRadiance> m_band;
    ThermalSensor m_sensor;
    ScenePainter m_painter;

    std::mutex m_mutex;                  // protects the next three members
    std::deque<ThermalMoment> m_moments; ///< the first is the one that is delivered
    std::optional<ShownBoard> m_board;
    bool m_isUnplugged = false;

    // Used by the thread of newest().
    std::vector<SceneFace> m_faces; ///< source, objects, fixtures and shields, in their orders
    std::shared_ptr<const ThermalCameraFrame> m_frame;
};

} // namespace bask
