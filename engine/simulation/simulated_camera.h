#pragma once
// A simulated camera: renders the rig as it truly is, with lens, noise, blur and uneven light.

#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"
#include "engine/devices/camera.h"
#include "engine/shape/shape.h"

#include <mutex>
#include <optional>
#include <vector>

namespace bask {

/// As it truly is.
struct SimulatedCameraConfig {
    CameraModel camera; ///< width and height known
    Pose X_RC = Pose::Identity();
    MarkerLayout markers;
    Shape source = Disk{0.10};
    struct Object {
        Shape shape;
        Pose X_EO = Pose::Identity();
    };
    std::vector<Object> objects;
    double frameRate_Hz = 30.0; ///< of the engine's clock, and at most as many a second of the computer's
    double noise_grey = 2.0;    ///< standard deviation of a pixel, of 255
    double blur_px = 0.7;       ///< standard deviation of the lens's spot
    double lightFall = 0.3;     ///< how much darker the darker side is, 0..1
    double delay_s = 0.03;      ///< from the light caught to the frame handed out, on the engine's clock
    std::uint64_t seed = 1;
};

/// The rig at one moment.
struct SceneMoment {
    double time_s = 0.0;
    Pose X_RE = Pose::Identity();
    Pose X_RS = Pose::Identity();
};

/// observe() and the setters from one thread (the engine's), newest() from one, which renders.
class SimulatedCamera final : public Camera {
public:
    explicit SimulatedCamera(SimulatedCameraConfig config);

    Result<std::shared_ptr<const CameraFrame>> newest() override;

    void observe(const SceneMoment& moment);
    /// A board that is held before the camera, moved by itself from one view that calibrates to the next and
    /// still for a while at each, as a patient person would; empty: none.
    void setBoard(std::optional<Board> board);
    /// A hand before the source's markers.
    void setCovered(bool covered);
    void setUnplugged(bool unplugged);
};

} // namespace bask
