#pragma once
// A simulated camera: renders the rig as it truly is, with lens, noise, blur and uneven light.

#include "engine/base/clock.h"
#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"
#include "engine/calibration/marker_layout.h"
#include "engine/devices/camera.h"
#include "engine/shape/shape.h"
#include "engine/simulation/rig_faces.h"

#include <deque>
#include <mutex>
#include <optional>
#include <vector>

namespace bask {

/// A camera's axes (x right, y down, z forward) at `eye`, upright, looking at a point; both in R, z up.
Pose lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& at);

/// 1280 x 720, 65 degrees wide, mild barrel distortion.
CameraModel usualCamera();
/// X_RC of a camera that stands 0.75 m from a source at R's origin and sees it obliquely from above, with
/// room above it for an end-effector.
Pose usualCameraPose();

/// As it truly is.
struct SimulatedCameraConfig {
    CameraModel camera = usualCamera(); ///< width and height known
    Pose X_RC = usualCameraPose();
    MarkerLayout markers;
    Shape source = Disk{0.10};
    struct Object {
        Shape shape;
        Pose X_EO = Pose::Identity();
    };
    std::vector<Object> objects;
    double frameRate_Hz = 30.0; ///< of the engine's clock
    bool isWallLimited = true;  ///< and at most as many a second of the computer's
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
    /// Throws std::invalid_argument for a camera without size and a layout that checkLayout refuses. What
    /// takes time is made with the first picture: most runs have none.
    explicit SimulatedCamera(SimulatedCameraConfig config);

    /// Of the moment that is delay_s older than the newest observed; CameraLost before the first.
    Result<std::shared_ptr<const CameraFrame>> newest() override;

    void observe(const SceneMoment& moment);
    /// Other markers on the rig; throws as the constructor.
    void setMarkers(const MarkerLayout& markers);
    /// A board that is held before the camera, moved by itself from one view that calibrates to the next and
    /// still for a while at each, as a patient person would; empty: none.
    void setBoard(std::optional<Board> board);
    /// A hand before the source's markers.
    void setCovered(bool covered);
    void setUnplugged(bool unplugged);

private:
    struct Observed {
        SceneMoment moment;
        double caught_s; ///< the computer's time at that moment
    };
    struct HeldBoard {
        Board board;
        double since_s;
    };
    /// What is to be seen.
    struct View {
        Observed now;
        std::optional<HeldBoard> board;
        bool isCovered = false;
    };

    std::optional<View> view() const;
    bool isDue(const Observed& now, double wall_s) const;
    void prepare();
    GreyPicture rendered(const View& view, std::uint64_t number);

    const SimulatedCameraConfig m_config;
    const SteadyClock m_wall;

    mutable std::mutex m_mutex; // of the next six
    MarkerLayout m_markers;
    bool m_areMarkersNew = true;
    std::deque<Observed> m_observed;
    std::optional<HeldBoard> m_board;
    bool m_isCovered = false;
    bool m_isUnplugged = false;

    // Of newest()'s thread.
    std::vector<PartFace> m_rig, m_hands;
    std::optional<SceneRenderer> m_renderer;
    std::shared_ptr<const CameraFrame> m_frame;
    double m_rendered_s = 0.0; // the computer's time of m_frame
};

} // namespace bask
