#pragma once
// The 3-D view of targets: source, workspace and clearance, and for each object the surface of end-effector
// positions that hold its target.

#include "engine/base/result.h"
#include "engine/base/units.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment.h"

#include <QImage>
#include <QStringList>
#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace bask {

enum class ViewPreset;

/// The pose where all targets are met, or nearly.
struct SceneVerdict {
    Vector6d pose = Vector6d::Zero(); ///< end-effector in R: the objects' ghost is shown there
    bool feasible = false;            ///< marked as the surfaces' common point
    /// Points where two surfaces are closest, in their coordinates: joined by a line if not feasible.
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> closest = {};
};

/// A plane through one object's field.
struct SceneCut {
    std::shared_ptr<const Field> field; ///< view factors over the surfaces' coordinates, as from targetFields
    int object = 0;
    Coordinate axis = kY;      ///< normal to the plane
    double position = 0.0;     ///< m or rad
    bool asTemperature = true; ///< true: steady temperature of the object; false: its view factor
};

/// Setters in, a picture and picked poses out; R axes in cm. Setters only note what is new: frames are drawn
/// later, and none while hidden. Without OpenGL 3.2 it says so in words. Colours follow the palette, words
/// the language. A click on a surface or the cut picks a pose: it gets a mark and, for each object, an arrow
/// along which it gets hotter.
class TargetScene : public QWidget {
    Q_OBJECT
public:
    explicit TargetScene(QWidget* parent = nullptr);
    ~TargetScene() override;

    /// Shows another experiment with its objects' ghost at the start pose; removes surfaces, verdict, cut and
    /// pick unless only targets differ.
    void setExperiment(const Experiment& experiment);
    /// Sets one surface for each object, over the subset's coordinates of the end-effector in R; `fixed` has
    /// the other coordinates. A missing or empty one means none for that object. Over the angles, the axes
    /// are angles: surfaces, the robot's limits and marks are shown, but neither source nor objects. Over the
    /// objects' own positions nothing is marked: each object of the ghost is on its surface. The verdict's
    /// point is marked only if `fixed` is that of its pose. Another subset removes cut and pick, another
    /// `fixed` the pick.
    void setSurfaces(std::vector<Isosurface> surfaces, const Vector6d& fixed,
                     PoseSubset subset = PoseSubset::Translation);
    void setVerdictPoint(const std::optional<SceneVerdict>& verdict);
    /// Sets the cut; call it after setSurfaces of its subset. Throws std::invalid_argument unless the field
    /// is over this subset.
    void setCut(const std::optional<SceneCut>& cut);
    /// Dims and hatches the picture, because it belongs to older input.
    void setStale(bool stale);
    void setTemperatureUnit(TemperatureUnit unit);
    void clearPick();

    void viewAlongMinusZ(); ///< from above: x to the right, y up
    void viewAlongX();      ///< from the side: y to the left, z up
    void viewIsometric();

    /// Whether there is a picture at all.
    bool hasPicture() const;
    /// Returns the picture in this size, pixels; text and lines grow with it. Null before the scene was shown
    /// and without OpenGL.
    QImage image(QSize size);
    /// Saves the picture as a PNG. Errors: FileUnwritable.
    Result<void> saveImage(const QString& path, QSize size);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// A point was clicked: the end-effector's coordinates (that move the object there, if the surfaces are
    /// over its own position), and one line for each object: F, steady temperature, and how fast that rises
    /// along its arrow.
    void posePicked(const bask::Vector6d& coordinates, const QStringList& words);
    /// The last picked point was removed, for any reason: also another experiment, subset or `fixed`.
    void pickDropped();
    void surfacesDrawn(); ///< the first frame with new surfaces was made

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void makePicture();
    void showNotice();
    void turnTo(ViewPreset preset);
    void pick(QPointF place);
    void dropPick();
    void requestFrame();

    struct Impl;
    std::unique_ptr<Impl> m;
};

} // namespace bask
