#pragma once
// A simulated camera: renders the true rig, with lens, noise, blur and uneven light.

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

/// Returns the axes of a camera (x right, y down, z forward) at `eye`, upright, that looks at a point; both
/// are in R, z up.
Pose lookingAt(const Eigen::Vector3d& eye, const Eigen::Vector3d& at);

/// Returns a camera of 1280 x 720, 65 degrees wide, with mild barrel distortion.
CameraModel usualCamera();
/// Returns X_RC of a camera 0.75 m from a source at R's origin, which sees it obliquely from above, with room
/// above the source for an end-effector.
Pose usualCameraPose();

/// The true rig and camera.
struct SimulatedCameraConfig {
    CameraModel camera = usualCamera(); ///< with known width and height
    Pose X_RC = usualCameraPose();
    MarkerLayout markers;
    Shape source = Disk{0.10};
    struct Object {
        Shape shape;
        Pose X_EO = Pose::Identity();
    };
    std::vector<Object> objects;
    double frameRate_Hz = 30.0; ///< by the engine's clock
    bool isWallLimited = true;  ///< also limits the frames to this rate by the computer's clock
    double noise_grey = 2.0;    ///< standard deviation of a pixel, of 255
    double blur_px = 0.7;       ///< standard deviation of the lens's spot
    double lightFall = 0.3;     ///< how much darker the darker side is, 0..1
    double delay_s = 0.03;      ///< from the exposure to the delivered frame, by the engine's clock
    std::uint64_t seed = 1;
};

/// The rig at one time.
struct SceneMoment {
    double time_s = 0.0;
    Pose X_RE = Pose::Identity();
    Pose X_RS = Pose::Identity();
};

/// Call observe() and the setters from one thread (the engine's), and newest() from one thread, which
/// renders.
class SimulatedCamera final : public Camera {
public:
    /// Throws std::invalid_argument for a camera without size and a layout that checkLayout refuses. Slow
    /// parts are made with the first picture, because most runs have none.
    explicit SimulatedCamera(SimulatedCameraConfig config);

    /// Returns the frame of the time delay_s before the newest observed one; CameraLost before the first.
    Result<std::shared_ptr<const CameraFrame>> newest() override;

    void observe(const SceneMoment& moment);
    /// Sets other markers on the rig; throws as the constructor.
    void setMarkers(const MarkerLayout& markers);
    /// Shows a board in front of the camera, which moves from one calibration view to the next and is still
    /// for a while at each, as a patient person would move it; empty: none.
    void setBoard(std::optional<Board> board);
    /// Shows a hand in front of the source's markers.
    void setCovered(bool covered);
    bool isCovered() const;
    void setUnplugged(bool unplugged);
    bool isUnplugged() const;

private:
    struct Observed {
        SceneMoment moment;
        double caught_s; ///< the computer's time then
    };
    struct ShownBoard {
        Board board;
        double since_s;
    };
    /// The content of a picture.
    struct View {
        Observed now;
        std::optional<ShownBoard> board;
        bool isCovered = false;
    };

    std::optional<View> view() const;
    bool isDue(const Observed& now, double wall_s) const;
    void prepare();
    GreyPicture rendered(const View& view, std::uint64_t number);

    const SimulatedCameraConfig m_config;
    const SteadyClock m_wall;

    mutable std::mutex m_mutex; // protects the next six members
    MarkerLayout m_markers;
    bool m_areMarkersNew = true;
    std::deque<Observed> m_observed;
    std::optional<ShownBoard> m_board;
    bool m_isCovered = false;
    bool m_isUnplugged = false;

    // Used by the thread of newest().
    std::vector<PartFace> m_rig, m_hands;
    std::optional<SceneRenderer> m_renderer;
    std::shared_ptr<const CameraFrame> m_frame;
    double m_rendered_s = 0.0; // the computer's time of m_frame
};

} // namespace bask
