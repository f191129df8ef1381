#pragma once
// The VTK actors of the scene: source, floor, workspace, objects, mounts and trails; private to
// widgets/scene.

#include "engine/devices/device.h"
#include "engine/model/experiment.h"
#include "widgets/scene/camera_fit.h"
#include "widgets/scene/trail.h"

#include <QColor>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace bask {

inline constexpr int kOutlinePoints = 160; ///< number of points of a curved outline in the picture

/// Colours of everything that is not a temperature.
struct SceneColours {
    bool dark = false;
    QColor ground;    ///< background
    QColor grid;      ///< lines on the floor
    QColor workspace; ///< edges of the workspace
    QColor mount;     ///< arms from the end-effector to the objects
};

/// Colour of a temperature (K).
using TemperatureColour = std::function<QColor(double temperature_K)>;

/// Owns the actors and keeps them in the renderer. All calls on the GUI thread; none draws.
class SceneProps {
public:
    explicit SceneProps(vtkRenderer& renderer);
    ~SceneProps();

    /// Creates all actors again; `frame` is the box in which the floor is drawn.
    void build(const Experiment& experiment, const Box& frame);
    void setColours(const SceneColours& colours);
    /// Sets the factor of all line widths: device pixel ratio, and less than that in a small view.
    void setLineScale(double scale);

    /// Sets the viewing direction (R): the workspace's edges on the viewer's side are left out.
    void setViewDirection(const Eigen::Vector3d& direction);
    /// Moves objects and source. Lines are also moved by `lift` (R, m), a few pixels towards the viewer: this
    /// is not visible in a parallel projection, and draws the full width of a line in front of the surface
    /// that it bounds.
    void setPoses(const Pose& X_RE, const Pose& X_RS, const Eigen::Vector3d& lift);
    /// Sets how hot the source looks: 0 as cold as the room, 1 incandescent.
    void setSourceWarmth(double share);
    /// Sets the colour of the source's rim: grey without heat, that of what is not known; none: incandescent.
    void setSourceHeat(std::optional<HeatState> heat);
    void setObjectColour(std::size_t index, const QColor& colour);
    /// Sets the opacity of the objects' surfaces, 0 to 1: for objects that are only possible there.
    void setObjectOpacity(double opacity);
    /// Uploads one trail of at most Trail::kMaxPoints points. What is old of a long one fades.
    void setTrail(std::size_t index, const Trail& trail, const TemperatureColour& colour);
    /// Sets the planned path of an object's centre, R, m; dashed, with a cross at its end if it arrives there
    /// to stay. Empty: none.
    void setPlan(std::size_t index, const std::vector<Eigen::Vector3d>& path_R, bool arrives);
    /// Sets whether planned paths are dimmer, beside trails.
    void setPlansDim(bool dim);

private:
    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
