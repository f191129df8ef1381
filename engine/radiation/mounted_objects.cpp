#include "engine/radiation/mounted_objects.h"

#include "engine/radiation/outline_table.h"
#include "engine/radiation/plate.h"
#include "engine/radiation/plate_crossing.h"

#include <algorithm>
#include <numbers>
#include <utility>

namespace bask {

double shieldTop_m(const Screens& screens, const Pose& X_RS) {
    const Eigen::Vector3d n = X_RS.linear().col(2);
    double top_m = 0.0;
    for (const StandingContour& shield : screens.shields) {
        const Plate& plate = shield.contour.impl().plate();
        top_m = std::max(top_m, n.dot(plate.farthest(shield.X_RB, n) - X_RS.translation()) +
                                    plate.margin_m(shield.X_RB, n));
    }
    return top_m;
}

MountedObjects::MountedObjects(std::vector<MountedContour> objects, Screens screens, const Pose& X_RS)
    : m_objects(std::move(objects)), m_screens(std::move(screens)), m_inFront(m_objects.size()) {
    for (std::size_t i = 0; i < size(); ++i)
        for (std::size_t j = 0; j < size() + m_screens.fixtures.size(); ++j) {
            const MountedContour& object = m_objects[i];
            const MountedContour& other = j < size() ? m_objects[j] : m_screens.fixtures[j - size()];
            if (i != j && isInFront(other.contour, other.X_EO, object.X_EO) &&
                !platesCross(object.contour, object.X_EO, other.contour, other.X_EO))
                m_inFront[i].push_back(j);
        }
    setSourceAt(X_RS);
}

void MountedObjects::setSourceAt(const Pose& X_RS) {
    const Pose X_SR = X_RS.inverse();
    m_shields.clear();
    for (const StandingContour& shield : m_screens.shields)
        m_shields.push_back({shield.contour, X_SR * shield.X_RB, false});
}

MountedObjects MountedObjects::turnedOver(const Pose& X_RS) const {
    const Pose turned(Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitX()));
    std::vector<MountedContour> backs;
    for (const MountedContour& object : m_objects)
        backs.push_back({object.contour.impl().plate().back(), object.X_EO * turned});
    return MountedObjects(std::move(backs), m_screens, X_RS);
}

Blocker MountedObjects::held(std::size_t plate, const Pose& X_SE) const {
    const MountedContour& it = plate < size() ? m_objects[plate] : m_screens.fixtures[plate - size()];
    return {it.contour, X_SE * it.X_EO};
}

std::vector<Blocker> MountedObjects::blockersOf(std::size_t i, const Pose& X_SE) const {
    std::vector<Blocker> blockers;
    for (const std::size_t plate : m_inFront[i])
        blockers.push_back(held(plate, X_SE));
    blockers.insert(blockers.end(), m_shields.begin(), m_shields.end());
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
    if (!mayBeShaded(i))
        return bask::viewFactor(source, m_objects[i].contour, X_SE * m_objects[i].X_EO, options);
    const ShadedViewFactor factor = shaded(source, i, X_SE, options);
    return {factor.value, factor.gradientRigid, factor.visibility, factor.errorEstimate};
}

double MountedObjects::viewFactorValue(const RadiatingSource& source, std::size_t i, const Pose& X_SE,
                                       double tolerance) const {
    if (!mayBeShaded(i))
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
    if (!mayBeShaded(i) || unshaded == 0.0)
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
        if (!mayBeShaded(i))
            continue;
        const Pose X_SO = X_SE * m_objects[i].X_EO;
        const double unshaded = bask::viewFactorValue(source, m_objects[i].contour, X_SO, kMinTolerance);
        ShadeOptions options;
        options.tolerance = std::max(kOfShare * unshaded, kMinTolerance);
        options.refusesCrossing = false;
        if (unshaded <= 0.0)
            continue;
        const auto add = [&](std::size_t taker, const Blocker& alone) {
            const ShadedViewFactor left =
                shadedViewFactor(source, m_objects[i].contour, X_SO, {&alone, 1}, options);
            const double share = std::clamp(1.0 - left.value / unshaded, 0.0, 1.0);
            if (share > 0.0 && share >= min)
                taken.push_back({i, taker, share});
        };
        for (const std::size_t plate : m_inFront[i])
            add(plate, held(plate, X_SE));
        for (std::size_t k = 0; k < m_shields.size(); ++k)
            add(size() + m_screens.fixtures.size() + k, m_shields[k]);
    }
    return taken;
}

} // namespace bask
