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

/// Where all targets are met, or nearly.
struct SceneVerdict {
    Vector6d pose = Vector6d::Zero(); ///< end-effector in R: the objects' ghost stands there
    bool feasible = false;            ///< marked as the surfaces' common point
    /// Where two surfaces come closest, in their coordinates: joined by a line when not feasible.
    std::optional<std::pair<Eigen::Vector3d, Eigen::Vector3d>> closest = {};
};

/// A plane through one object's field.
struct SceneCut {
    std::shared_ptr<const Field> field; ///< view factors over the surfaces' coordinates, as of targetFields
    int object = 0;
    Coordinate axis = kY;      ///< normal to the plane
    double position = 0.0;     ///< m or rad
    bool asTemperature = true; ///< steady temperature of the object, else its view factor
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

    /// Shows another experiment, its objects' ghost at the start pose; surfaces, verdict, cut and pick go.
    /// They stay when only targets are others.
    void setExperiment(const Experiment& experiment);
    /// One surface an object, over the subset's coordinates of the end-effector in R; `fixed` has the others.
    /// Fewer, or empty ones: none for those objects. Over the angles the axes are angles: there are surfaces,
    /// the robot's limits and marks, but neither source nor objects. Over the objects' own positions nothing
    /// is marked: each object of the ghost stands on its surface. The verdict's point is marked only where
    /// `fixed` is that of its pose. Another subset drops cut and pick, another `fixed` the pick.
    void setSurfaces(std::vector<Isosurface> surfaces, const Vector6d& fixed,
                     PoseSubset subset = PoseSubset::Translation);
    void setVerdictPoint(const std::optional<SceneVerdict>& verdict);
    /// After setSurfaces of its subset. Throws std::invalid_argument unless the field is over it.
    void setCut(const std::optional<SceneCut>& cut);
    /// Dims and hatches: what is shown belongs to older input.
    void setStale(bool stale);
    void setTemperatureUnit(TemperatureUnit unit);
    void clearPick();

    void viewAlongMinusZ(); ///< from above: x to the right, y up
    void viewAlongX();      ///< from the side: y to the left, z up
    void viewIsometric();

    /// Whether there is a picture at all.
    bool hasPicture() const;
    /// The picture in so many pixels; text and lines grow with it. Null before the scene was shown and
    /// without OpenGL.
    QImage image(QSize size);
    /// The same as a PNG. Errors: FileUnwritable.
    Result<void> saveImage(const QString& path, QSize size);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// A point was clicked: the end-effector's coordinates (that put the object there whose own position it
    /// is), and a line an object: F, steady temperature, and how fast that rises along its arrow.
    void posePicked(const bask::Vector6d& coordinates, const QStringList& words);
    /// The point picked last went, whatever made it go: also another experiment, subset or `fixed`.
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
