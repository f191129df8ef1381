#pragma once
// The outlines of held objects as a camera at a given pose shows them, and where nothing hides or crosses
// them.

#include "engine/base/pose.h"
#include "engine/calibration/camera_model.h"
#include "engine/thermography/face_pixels.h"

#include <vector>

namespace bask {

/// A thin opaque plate on the end-effector.
struct MountedPlate {
    Shape shape;
    Pose X_EO = Pose::Identity();
};

/// What a camera sees of a rig, as plates.
struct SilhouetteScene {
    std::vector<MountedPlate> objects;  ///< whose outlines are looked for
    std::vector<MountedPlate> fixtures; ///< that move with them and may hide them
    std::vector<PlacedPlate> fixed;     ///< in R (X_WO is X_RO): source, shields
};

/// A point of an object's outline as the lens shows it.
struct OutlineSample {
    Eigen::Vector3d p_E = Eigen::Vector3d::Zero();
    Eigen::Vector2d shown_px = Eigen::Vector2d::Zero();
    Eigen::Vector2d normal = Eigen::Vector2d::UnitX(); ///< outwards; length 1
    double along_px = 0.0;                             ///< way along the shown outline
    double curvature_px = 0.0;                         ///< 1/px, smoothed; positive where it is convex
    bool isClear = false; ///< within the picture, not hidden, at no corner, with no other edge nearby
};

/// A closed outline, and its length. Empty if it lies partly behind the camera or is seen edge-on.
struct ShownOutline {
    std::vector<OutlineSample> samples;
    double length_px = 0.0;
};

/// Projects the outlines of a scene. Not changed after it is made; thread-safe.
class SilhouetteOutlines {
public:
    SilhouetteOutlines(const CameraModel& camera, const SilhouetteScene& scene);

    const CameraModel& camera() const { return m_camera; }
    std::size_t objects() const { return m_objects; }

    /// Returns the outline of each object, with isClear false throughout: what hides it is not looked for.
    std::vector<ShownOutline> shown(const Pose& X_RE, const Pose& X_RC) const;
    /// Returns the same with isClear set. `reach_px`: how far the surroundings of a sample have to be in the
    /// picture and free of edges of other plates.
    std::vector<ShownOutline> clear(const Pose& X_RE, const Pose& X_RC, double reach_px) const;

private:
    struct Plate {
        bool isMounted = false; ///< its pose is in E, else in R
        Pose X = Pose::Identity();
        std::vector<std::vector<Eigen::Vector2d>> rings;   ///< m, to tell what is hidden
        std::vector<std::vector<Eigen::Vector2d>> samples; ///< of each ring, evenly, m
        double radius_m = 0.0;
    };
    struct PlacedInCamera {
        Pose X_CO, X_OC;
        Eigen::Vector3d normal;
        double offset;
    };
    std::vector<PlacedInCamera> placed(const Pose& X_RE, const Pose& X_RC) const;
    ShownOutline outline(const Plate& plate, const PlacedInCamera& at) const;
    bool isHidden(const std::vector<PlacedInCamera>& at, const Eigen::Vector3d& p_C, std::size_t own) const;

    CameraModel m_camera;
    std::size_t m_objects = 0;
    std::vector<Plate> m_plates; ///< first the objects
};

} // namespace bask
