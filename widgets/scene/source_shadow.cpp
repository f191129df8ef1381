#include "widgets/scene/source_shadow.h"

#include "engine/shape/shape.h"

#include <optional>

namespace bask {
namespace {

constexpr int kPoints = 240; // of a curved outline
constexpr double kNear_m = 1e-4;

using Ring = std::vector<Eigen::Vector2d>;

/// Within the outline and in no hole.
bool isOn(const std::vector<Ring>& source, const Eigen::Vector2d& p) {
    bool inside = false;
    for (const Ring& ring : source)
        inside = inside != encloses(ring, p);
    return inside;
}

} // namespace

std::vector<Eigen::Vector3d> shadowLines(const Experiment& experiment, std::size_t object,
                                         const Vector6d& q) {
    const Pose X_RS = poseFromCoordinates(experiment.source.pose);
    const Pose X_SE = X_RS.inverse() * poseFromCoordinates(q);
    const Pose X_SO = X_SE * poseFromCoordinates(experiment.objects[object].mounting);
    const Eigen::Vector3d eye = X_SO.translation();
    const Eigen::Vector3d face = -X_SO.linear().col(2);
    const std::vector<Ring> source = shapeRings(experiment.source.shape, kPoints);
    const auto shadowOf = [&](const Eigen::Vector3d& p) -> std::optional<Eigen::Vector3d> {
        if (p.z() <= 0.0 || p.z() >= eye.z() - kNear_m || face.dot(p - eye) <= kNear_m)
            return std::nullopt;
        const Eigen::Vector3d on = eye + (p - eye) * (eye.z() / (eye.z() - p.z()));
        if (!isOn(source, on.head<2>()))
            return std::nullopt;
        return X_RS * Eigen::Vector3d(on.x(), on.y(), 0.0);
    };
    std::vector<Eigen::Vector3d> lines;
    const auto addShadow = [&](const Shape& shape, const Pose& X_SB) {
        for (const Ring& ring : shapeRings(shape, kPoints)) {
            std::optional<Eigen::Vector3d> before;
            for (std::size_t k = 0; k <= ring.size(); ++k) {
                const Eigen::Vector2d& p = ring[k % ring.size()];
                const auto at = shadowOf(X_SB * Eigen::Vector3d(p.x(), p.y(), 0.0));
                if (before && at)
                    lines.insert(lines.end(), {*before, *at});
                before = at;
            }
        }
    };
    for (std::size_t other = 0; other < experiment.objects.size(); ++other)
        if (other != object)
            addShadow(experiment.objects[other].shape,
                      X_SE * poseFromCoordinates(experiment.objects[other].mounting));
    for (const PlateSpec& fixture : experiment.fixtures)
        addShadow(fixture.shape, X_SE * poseFromCoordinates(fixture.pose));
    for (const PlateSpec& shield : experiment.shields)
        addShadow(shield.shape, X_RS.inverse() * poseFromCoordinates(shield.pose));
    return lines;
}

} // namespace bask
