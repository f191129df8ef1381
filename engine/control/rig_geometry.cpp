#include "engine/control/rig_geometry.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace bask {

namespace {

constexpr double kTableTolerance = 1e-6;
constexpr double kSlack = 1e-9; ///< tolerance of positions, m and rad

/// Faces in one plane have no view factor: objects stop this far above it even without a clearance.
constexpr double kMinClearance_m = 1e-4;

std::optional<Pose> inverseUnlessIdentity(const Pose& X) {
    if (X.matrix() == Pose::Identity().matrix())
        return std::nullopt;
    return X.inverse();
}

} // namespace

RigGeometry::RigGeometry(const Shape& source, const std::vector<Shape>& shapes,
                         const std::vector<Vector6d>& mountings, const RobotLimits& limits, const Pose& X_RS,
                         const std::vector<FaceMaterial>& fronts, const Screens& screens)
    : m_source(RadiatingContour(source)), m_limits(limits), m_X_RS(X_RS), m_X_SR(inverseUnlessIdentity(X_RS)),
      m_floor_m(shieldTop_m(screens, X_RS)) {
    if (shapes.size() != mountings.size())
        throw std::invalid_argument("RigGeometry: one mounting a shape");
    m_limits.clearance_m = std::max(limits.clearance_m, kMinClearance_m);
    for (int k = 0; k < 6; ++k)
        if (limits.free[static_cast<std::size_t>(k)])
            m_free.push_back(k);
    constexpr int kOutlinePoints = 72;
    std::vector<MountedContour> mounted;
    const auto addOutline = [&](const Shape& shape, const Pose& X_EO) {
        std::vector<Eigen::Vector3d> outline;
        for (const Eigen::Vector2d& p : shapeOutline(shape, kOutlinePoints))
            outline.push_back(X_EO * Eigen::Vector3d(p.x(), p.y(), 0.0));
        m_outlines_E.push_back(std::move(outline));
    };
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        mounted.push_back({RadiatingContour(shapes[i]), poseFromCoordinates(mountings[i])});
        addOutline(shapes[i], mounted.back().X_EO);
    }
    for (const MountedContour& fixture : screens.fixtures)
        addOutline(fixture.contour.shape(), fixture.X_EO);
    m_mounted = MountedObjects(std::move(mounted), screens, X_RS);
    if (!fronts.empty())
        m_neighbours = Neighbours(m_mounted, fronts);
}

std::shared_ptr<const RigGeometry> RigGeometry::withSourceAt(const Pose& X_RS) const {
    auto moved = std::make_shared<RigGeometry>(*this);
    moved->m_X_RS = X_RS;
    moved->m_X_SR = inverseUnlessIdentity(X_RS);
    moved->m_mounted.setSourceAt(X_RS);
    moved->m_floor_m = shieldTop_m(m_mounted.screens(), X_RS);
    return moved;
}

std::shared_ptr<const RigGeometry> RigGeometry::withSource(std::vector<SourceTerm> terms,
                                                           SourceEmission emission, double source_K) const {
    auto uneven = std::make_shared<RigGeometry>(*this);
    uneven->m_source = RadiatingSource(std::move(terms), emission.factors(source_K));
    uneven->m_maxViewFactor = emission.maxWeight(source_K);
    uneven->m_emission = std::move(emission);
    uneven->m_source_K = source_K;
    return uneven;
}

std::shared_ptr<const RigGeometry> RigGeometry::withSourceTemperature(double source_K) const {
    if (isSourceEven())
        return std::make_shared<RigGeometry>(*this);
    return withSource(m_source.terms(), m_emission, source_K);
}

Pose RigGeometry::X_SE(const Vector6d& q) const {
    const Pose X_RE = poseFromCoordinates(q);
    return m_X_SR ? *m_X_SR * X_RE : X_RE;
}

ViewFactors RigGeometry::viewFactors(const Vector6d& q, Shade shade, const std::vector<bool>& wanted) const {
    const InteractionMatrix byTwist =
        shade == Shade::Rough && mayShade()
            ? roughInteractionMatrix(m_source, m_mounted, X_SE(q), m_X_RS.linear(), kTableTolerance,
                                     m_neighbours.exchange() ? std::vector<bool>{} : wanted)
            : interactionMatrix(m_source, m_mounted, X_SE(q), kAllFree, m_X_RS.linear());
    ViewFactors out{m_neighbours.withReflections(byTwist.F), byTwist.J};
    for (int i = 0; i < objects(); ++i)
        out.dF.row(i) = coordinateGradient(q, byTwist.J.row(i).transpose()).transpose();
    if (m_neighbours.exchange())
        out.dF = m_neighbours.withReflections(out.dF);
    return out;
}

Eigen::VectorXd RigGeometry::viewFactorsFast(const Vector6d& q, const std::vector<bool>& wanted) const {
    const Pose X = X_SE(q);
    Eigen::VectorXd F = Eigen::VectorXd::Zero(objects());
    for (std::size_t i = 0; i < m_mounted.size(); ++i)
        if (wanted.empty() || wanted[i] || m_neighbours.exchange())
            F[static_cast<Eigen::Index>(i)] = m_mounted.viewFactorValue(m_source, i, X, kTableTolerance);
    return m_neighbours.withReflections(F);
}

void RigGeometry::directViewFactors(const Pose& X_SE, Eigen::VectorXd& F) const {
    F.resize(objects());
    for (int i = 0; i < objects(); ++i) {
        const MountedContour& object = m_mounted[static_cast<std::size_t>(i)];
        F[i] = viewFactorValue(m_source, object.contour, X_SE * object.X_EO, kTableTolerance);
    }
}

void RigGeometry::unshadedViewFactors(const Vector6d& q, Eigen::VectorXd& F) const {
    directViewFactors(X_SE(q), F);
    if (m_neighbours.exchange())
        F = m_neighbours.withReflections(F);
}

Eigen::VectorXd RigGeometry::roughShares(const Vector6d& q, const Eigen::VectorXd& unshaded) const {
    const Pose X = X_SE(q);
    Eigen::VectorXd direct = unshaded;
    if (m_neighbours.exchange())
        directViewFactors(X, direct);
    Eigen::VectorXd shares(objects());
    for (int i = 0; i < objects(); ++i)
        shares[i] = m_mounted.roughShare(m_source, static_cast<std::size_t>(i), X, direct[i]);
    if (!m_neighbours.exchange())
        return shares;
    const Eigen::VectorXd received = m_neighbours.withReflections(direct.cwiseProduct(shares));
    return (unshaded.array() > 0.0).select(received.array() / unshaded.array(), 1.0);
}

Eigen::VectorXd RigGeometry::roughViewFactors(const Vector6d& q) const {
    Eigen::VectorXd F;
    unshadedViewFactors(q, F);
    if (mayShade())
        F.array() *= roughShares(q, F).array();
    return F;
}

std::vector<TakenLight> RigGeometry::takenLight(const Vector6d& q) const {
    return m_mounted.takenLight(m_source, X_SE(q));
}

std::vector<Clearance> RigGeometry::clearances(const Vector6d& q, const Vector6d& lowestAt) const {
    const Pose X_RE = poseFromCoordinates(q);
    const Eigen::Vector3d n = away();
    const double origin_m = n.dot(X_RE.translation() - m_X_RS.translation()) - m_floor_m;
    const Eigen::RowVector3d down = n.transpose() * poseFromCoordinates(lowestAt).linear();
    std::vector<Clearance> out;
    for (const auto& outline : m_outlines_E) {
        const auto lowest = std::ranges::min_element(
            outline, {}, [&](const Eigen::Vector3d& p_E) { return down.dot(p_E.transpose()); });
        const Eigen::Vector3d arm = X_RE.linear() * *lowest;
        Vector6d byTwist;
        byTwist << n, arm.cross(n); // dh = n . (v + w x arm) = n . v + w . (arm x n)
        out.push_back({origin_m + n.dot(arm), coordinateGradient(q, byTwist)});
    }
    return out;
}

double RigGeometry::lowestPoint_m(const Vector6d& q) const {
    const Pose X_RE = poseFromCoordinates(q);
    const Eigen::Vector3d n = away();
    const Eigen::RowVector3d down = n.transpose() * X_RE.linear();
    double lowest = std::numeric_limits<double>::infinity();
    for (const auto& outline : m_outlines_E)
        for (const Eigen::Vector3d& p_E : outline)
            lowest = std::min(lowest, down.dot(p_E.transpose()));
    return n.dot(X_RE.translation() - m_X_RS.translation()) - m_floor_m + lowest;
}

bool RigGeometry::allowed(const Vector6d& q) const {
    for (const int k : m_free)
        if (q[k] < m_limits.lower[k] - kSlack || q[k] > m_limits.upper[k] + kSlack)
            return false;
    return m_mounted.empty() || lowestPoint_m(q) >= m_limits.clearance_m - kSlack;
}

bool RigGeometry::mayStep(const Vector6d& from, const Vector6d& to, const RobotLimits& limits) const {
    for (const int k : m_free)
        if (!(to[k] >= std::min(limits.lower[k], from[k]) - kSlack &&
              to[k] <= std::max(limits.upper[k], from[k]) + kSlack))
            return false;
    return m_mounted.empty() ||
           lowestPoint_m(to) >= std::min(limits.clearance_m, lowestPoint_m(from)) - kSlack;
}

} // namespace bask
