#pragma once
// The VTK actors that a target scene has more than a scene: surfaces, clearance plane, cut, verdict, what was
// picked; private to widgets/scene.

#include "engine/exchange/isosurface.h"

#include <QColor>

#include <functional>
#include <memory>
#include <vector>

class vtkRenderer;

namespace bask {

/// A plane through a field: its samples in rows, and where they are.
struct CutSheet {
    int columns = 0;
    std::vector<Eigen::Vector3d> points; ///< R, m
    std::vector<double> values;          ///< one a point; NaN: none
    std::vector<double> lines;           ///< values that get a contour line
};

/// Arrows from one point.
struct PickedArrows {
    Eigen::Vector3d p_R = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> directions; ///< one an object, unit or zero
    double length_m = 0.03;
};

/// Owns the actors and keeps them in the renderer. All calls on the GUI thread; none draws.
class TargetProps {
public:
    explicit TargetProps(vtkRenderer& renderer);
    ~TargetProps();

    /// Puts the actors into the renderer again, after SceneProps::build took everything out.
    void addActors();

    void setSurfaces(const std::vector<Isosurface>& surfaces);
    /// Surface i in colour i, translucent; paler when `stale`.
    void setColours(const std::vector<QColor>& surfaces, const QColor& marks, const QColor& contours,
                    bool stale);
    void setLineScale(double scale);

    void setClearance(const std::vector<Eigen::Vector3d>& polygon); ///< empty: none
    void setCut(const CutSheet& sheet, const std::function<QColor(double)>& colour);
    /// A sphere at each point; two points are joined by a line.
    void setMarks(const std::vector<Eigen::Vector3d>& points, double radius_m);
    /// A sphere and an arrow an object, in the surfaces' colours; null: none.
    void setArrows(const PickedArrows* arrows, double radius_m, const std::vector<QColor>& colours);
    /// Moves lines on the cut, and marks and arrows, towards the viewer (R, m), as SceneProps::setPoses does:
    /// the marks far enough to be seen before everything.
    void setLift(const Eigen::Vector3d& lines, const Eigen::Vector3d& marks);

private:
    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
