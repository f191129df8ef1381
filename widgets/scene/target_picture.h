#pragma once
// The content of a target scene, as values, and how its frames are made from them; private to widgets/scene.

#include "engine/control/rig_geometry.h"
#include "widgets/scene/scene_overlay.h"
#include "widgets/scene/scene_props.h"
#include "widgets/scene/target_props.h"
#include "widgets/scene/target_scene.h"
#include "widgets/scene/vtk_view.h"

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// A pose that was clicked.
struct PickedPose {
    Vector6d q = Vector6d::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero(); ///< clicked point, in the surfaces' coordinates
    PickedArrows arrows;
};

/// The whole picture can be made from its values at any time; the flags show which are new. GUI thread.
struct TargetPicture {
    Experiment experiment;
    std::shared_ptr<const RigGeometry> rig; ///< null without an experiment
    std::vector<HeatRates> rates;
    Box frame;
    Vector6d fixed = Vector6d::Zero();
    PoseSubset subset = PoseSubset::Translation;
    std::vector<Isosurface> surfaces;
    std::optional<SceneVerdict> verdict;
    std::optional<SceneCut> cut;
    bool stale = false;
    std::optional<PickedPose> picked;
    TemperatureUnit unit = TemperatureUnit::Celsius;
    ViewPreset preset = ViewPreset::Isometric;
    bool cameraIsPersons = false;
    double scale = 1.0; ///< scale of text and lines, while a large picture is saved

    // Changes that the picture does not show yet.
    bool rebuild = true;
    bool resurface = true;
    bool remark = true;
    NiceRange cutRange;
    OverlayContent content;

    VtkView* view = nullptr;
    std::unique_ptr<SceneProps> props;
    std::unique_ptr<TargetProps> targets;
    SceneOverlay overlay;

    bool isOverAngles() const { return subset == PoseSubset::Rotation; }
    bool isOverOwn() const { return subset == PoseSubset::OwnTranslation; }
    /// Sets the experiment. Returns whether only targets differ: then everything stays, otherwise all except
    /// the pick is removed.
    bool setExperiment(const Experiment& next);
    /// Drops the cut, which belongs to another subset.
    void setSubset(PoseSubset next);
    /// Returns the end-effector's pose where the line of sight hits a surface or the cut; empty if it hits
    /// none, or there is no view factor.
    std::optional<PickedPose> poseAt(QPointF place) const;
    /// Returns whether the pick, if there is one, has this pose except for the drawn coordinates.
    bool isPickAt(const Vector6d& other) const;
    /// Returns the values at a pose, one sentence for each object.
    QStringList words(const PickedPose& pose) const;

    /// Brings actors and camera up to date.
    void prepare(const QPalette& palette, const QFont& font);
    /// Draws over what VTK has drawn.
    void paint(QPainter& painter, const QPalette& palette, const QFont& font);

private:
    void rebuildActors(bool dark);
    void placeActors();
    Eigen::Vector3d drawn(const Vector6d& q) const;
    Box limits() const;
    Box turns() const;
    QString turnText() const;
    double inUnit(double value) const;
    QString unitWord() const;
    QString placeText(const Eigen::Vector3d& p) const;
    QSizeF size() const { return QSizeF(view->size()) / scale; }
    Vector6d ghost() const;
    double markRadius() const;
    std::vector<QColor> colours(bool dark) const;
    double cutValue(double F) const;
    std::vector<Eigen::Vector3d> clearancePolygon() const;
    Eigen::Vector3d offsetOf(std::size_t object) const;
    bool isAtVerdict() const;
    void showBounds();
    void pointArrows(PickedPose& pose) const;
    void showCut(bool dark);
    void showShadows(bool dark);
    void showMarks(bool dark);
    void addObjectLabels(OverlayContent& content, bool dark) const;
    OverlayContent overlayContent(bool dark) const;
};

} // namespace bask
