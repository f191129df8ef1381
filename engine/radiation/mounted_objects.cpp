#include "engine/radiation/mounted_objects.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"
#include "engine/radiation/plate_crossing.h"

#include <algorithm>

namespace bask {

MountedObjects::MountedObjects(std::vector<MountedContour> objects)
    : m_objects(std::move(objects)), m_inFront(m_objects.size()) {
    for (std::size_t i = 0; i < size(); ++i)
        for (std::size_t j = 0; j < size(); ++j) {
            const MountedContour& object = m_objects[i];
            const MountedContour& other = m_objects[j];
            if (i != j && isInFront(other.contour, other.X_EO, object.X_EO) &&
                !platesCross(object.contour, object.X_EO, other.contour, other.X_EO))
                m_inFront[i].push_back(j);
        }
}

Blocker MountedObjects::blocker(std::size_t i, const Pose& X_SE) const {
    return {m_objects[i].contour, X_SE * m_objects[i].X_EO};
}

std::vector<Blocker> MountedObjects::blockersOf(std::size_t i, const Pose& X_SE) const {
    std::vector<Blocker> blockers;
    for (const std::size_t other : m_inFront[i])
        blockers.push_back(blocker(other, X_SE));
    return blockers;
}

ShadedViewFactor MountedObjects::shaded(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                        const ViewFactorOptions& options) const {
    ShadeOptions shade;
    shade.unshaded = options;
    shade.tolerance = std::max(options.tolerance, kShadeTolerance);
    shade.refusesCrossing = false;
    return shadedViewFactor(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, blockersOf(i, X_SE),
                            shade);
}

ViewFactor MountedObjects::viewFactor(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                      const ViewFactorOptions& options) const {
    if (m_inFront[i].empty())
        return bask::viewFactor(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, options);
    const ShadedViewFactor factor = shaded(source, i, X_SE, options);
    return {factor.value, factor.gradientRigid, factor.visibility, factor.errorEstimate};
}

double MountedObjects::viewFactorValue(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                       double tolerance) const {
    if (m_inFront[i].empty())
        return bask::viewFactorValue(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, tolerance);
    return shaded(source, i, X_SE, {.tolerance = tolerance}).value;
}

RigidViewFactor MountedObjects::roughViewFactor(const RadiatingSource& source, std::size_t i,
                                                const Pose& X_SE, double tolerance) const {
    return roughShadedViewFactor(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, blockersOf(i, X_SE),
                                 tolerance);
}

double MountedObjects::roughShare(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                  double unshaded) const {
    if (m_inFront[i].empty() || unshaded == 0.0)
        return 1.0;
    const double taken =
        roughShade(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, blockersOf(i, X_SE));
    return std::clamp(1.0 - taken / unshaded, 0.0, 1.0);
}

std::vector<TakenLight> MountedObjects::takenLight(const RadiatingSource& source, const Pose& X_SE,
                                                   double min) const {
    constexpr double kOfShare = 1e-3;
    constexpr double kMinTolerance = 1e-9; // of a view factor that hardly is one
    std::vector<TakenLight> taken;
    for (std::size_t i = 0; i < size(); ++i) {
        if (m_inFront[i].empty())
            continue;
        const Pose X_SO = X_SE * m_objects[i].X_EO;
        const double unshaded = bask::viewFactorValue(source, m_objects[i].contour, X_SO, kMinTolerance);
        ShadeOptions options;
        options.tolerance = std::max(kOfShare * unshaded, kMinTolerance);
        options.refusesCrossing = false;
        for (const std::size_t taker : m_inFront[i]) {
            if (unshaded <= 0.0)
                break;
            const Blocker alone = blocker(taker, X_SE);
            const ShadedViewFactor left =
                shadedViewFactor(source, m_objects[i].contour, X_SO, {&alone, 1}, options);
            const double share = std::clamp(1.0 - left.value / unshaded, 0.0, 1.0);
            if (share > 0.0 && share >= min)
                taken.push_back({i, taker, share});
        }
    }
    return taken;
}

} // namespace bask
