#pragma once
// The VTK actors that a target scene has more than a scene: surfaces, bounds, cut, verdict, what was
// picked; private to widgets/scene. Points are in the surfaces' coordinates: m, or rad.

#include "engine/exchange/isosurface.h"
#include "widgets/scene/cut_sheet.h"

#include <QColor>

#include <functional>
#include <memory>
#include <vector>

class vtkRenderer;

namespace bask {

/// Arrows, one for each object.
struct PickedArrows {
    std::vector<Eigen::Vector3d> from;
    std::vector<Eigen::Vector3d> directions; ///< unit or zero
    double length = 0.03;
};

/// Owns the actors and keeps them in the renderer. All calls on the GUI thread; none draws.
class TargetProps {
public:
    explicit TargetProps(vtkRenderer& renderer);
    ~TargetProps();

    /// Puts the actors into the renderer again, after SceneProps::build took everything out.
    void addActors();

    void setSurfaces(const std::vector<Isosurface>& surfaces);
    /// Sets colour i for surface i, translucent; paler if `stale`. `contours`: lines on the cut, arrows'
    /// edges.
    void setColours(const std::vector<QColor>& surfaces, const QColor& marks, const QColor& contours,
                    bool stale);
    void setLineScale(double scale);

    /// Sets the limits of the robot: lines from each even point to the odd one after it, and the polygon of a
    /// plane or none. `before`: wide, and in front of everything like the marks.
    void setBounds(const std::vector<Eigen::Vector3d>& lines, const std::vector<Eigen::Vector3d>& polygon,
                   bool before);
    void setCut(const CutSheet& sheet, const std::function<QColor(double)>& colour);
    /// Sets a sphere at each point; two points are joined by a line.
    void setMarks(const std::vector<Eigen::Vector3d>& points, double radius);
    /// Sets the shadows on the source, seen through everything: lines from each even point to the odd one
    /// after it, a colour a line.
    void setShadows(const std::vector<Eigen::Vector3d>& lines, const std::vector<QColor>& colours);
    /// Sets arrows in the surfaces' colours, with a sphere where they start; null for none.
    void setArrows(const PickedArrows* arrows, double radius, const std::vector<QColor>& colours);
    /// Moves lines on the cut, and marks and arrows, towards the viewer (R, m), as SceneProps::setPoses does:
    /// marks far enough to be in front of everything.
    void setLift(const Eigen::Vector3d& lines, const Eigen::Vector3d& marks);

private:
    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
