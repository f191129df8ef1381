#include "engine/thermography/silhouette_outline.h"

#include "engine/calibration/projection.h"
#include "engine/shape/contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr std::size_t kRingSamples = 360;
constexpr double kNearestOutline_m = 1e-3;  // in front of the camera
constexpr double kMinGrazing = 0.1;         // sine of the angle between a face and the line of sight
constexpr double kCurvatureWindow_px = 1.5; // to either side
constexpr double kMaxTurn_rad = 1.05;       // within that window: a corner, or too small an object
constexpr double kCornerReach_px = 2.5;     // how far a corner's blur bends the edge

std::vector<Eigen::Vector2d> evenlyAlong(const std::vector<Eigen::Vector2d>& ring) {
    std::vector<double> way{0.0};
    for (std::size_t k = 0; k < ring.size(); ++k)
        way.push_back(way.back() + (ring[(k + 1) % ring.size()] - ring[k]).norm());
    std::vector<Eigen::Vector2d> out;
    std::size_t edge = 0;
    for (std::size_t i = 0; i < kRingSamples; ++i) {
        const double at = way.back() * static_cast<double>(i) / kRingSamples;
        while (edge + 2 < way.size() && way[edge + 1] <= at)
            ++edge;
        const double share = (at - way[edge]) / std::max(way[edge + 1] - way[edge], 1e-300);
        out.push_back(ring[edge] + share * (ring[(edge + 1) % ring.size()] - ring[edge]));
    }
    return out;
}

/// Turns, normals and curvatures of a closed ring of pixels.
void setShape(ShownOutline& outline) {
    std::vector<OutlineSample>& samples = outline.samples;
    const std::size_t n = samples.size();
    double twiceArea = 0.0;
    std::vector<double> step(n), heading(n);
    for (std::size_t i = 0; i < n; ++i) {
        const Eigen::Vector2d &a = samples[i].shown_px, &b = samples[(i + 1) % n].shown_px;
        twiceArea += a.x() * b.y() - a.y() * b.x();
        samples[i].along_px = outline.length_px;
        step[i] = (b - a).norm();
        heading[i] = std::atan2(b.y() - a.y(), b.x() - a.x());
        outline.length_px += step[i];
    }
    const double sign = twiceArea > 0.0 ? 1.0 : -1.0;
    const double spacing = outline.length_px / static_cast<double>(n);
    const auto window = static_cast<std::size_t>(
        std::clamp(std::ceil(kCurvatureWindow_px / spacing), 1.0, static_cast<double>(n) / 4.0));
    const auto reach = static_cast<std::size_t>(
        std::clamp(std::ceil(kCornerReach_px / spacing), 1.0, static_cast<double>(n) / 4.0));
    std::vector<double> turn(n); // at each sample
    for (std::size_t i = 0; i < n; ++i)
        turn[i] = sign * std::remainder(heading[i] - heading[(i + n - 1) % n], 2.0 * std::numbers::pi);
    for (std::size_t i = 0; i < n; ++i) {
        double sum = 0.0, way = 0.0;
        for (std::size_t k = 0; k <= 2 * window; ++k) {
            sum += turn[(i + n - window + k) % n];
            way += step[(i + n - window + k) % n];
        }
        samples[i].curvature_px = sum / std::max(way, 1e-9);
        samples[i].isClear = true;
        const Eigen::Vector2d chord = samples[(i + 1) % n].shown_px - samples[(i + n - 1) % n].shown_px;
        samples[i].normal = sign * Eigen::Vector2d(chord.y(), -chord.x()).normalized();
    }
    for (std::size_t i = 0; i < n; ++i) {
        double sum = 0.0;
        for (std::size_t k = 0; k <= 2 * window; ++k)
            sum += turn[(i + n - window + k) % n];
        if (std::abs(sum) > kMaxTurn_rad)
            for (std::size_t k = 0; k <= 2 * reach; ++k)
                samples[(i + n - reach + k) % n].isClear = false;
    }
}

} // namespace

SilhouetteOutlines::SilhouetteOutlines(const CameraModel& camera, const SilhouetteScene& scene)
    : m_camera(camera), m_objects(scene.objects.size()) {
    constexpr int kPoints = 720, kPointsOfCover = 120; // of a disk
    const auto add = [&](const Shape& shape, bool isMounted, const Pose& X) {
        Plate plate{isMounted, X, shapeRings(shape, kPointsOfCover), {}, shapeRadius(shape)};
        for (const auto& ring : shapeRings(shape, kPoints))
            plate.samples.push_back(evenlyAlong(ring));
        m_plates.push_back(std::move(plate));
    };
    for (const auto& plates : {&scene.objects, &scene.fixtures})
        for (const MountedPlate& plate : *plates)
            add(plate.shape, true, plate.X_EO);
    for (const PlacedPlate& plate : scene.fixed)
        add(plate.shape, false, plate.X_WO);
}

std::vector<SilhouetteOutlines::PlacedInCamera> SilhouetteOutlines::placed(const Pose& X_RE,
                                                                           const Pose& X_RC) const {
    std::vector<PlacedInCamera> out;
    const Pose X_CR = X_RC.inverse();
    for (const Plate& plate : m_plates) {
        const Pose X_CO = plate.isMounted ? X_CR * X_RE * plate.X : X_CR * plate.X;
        const Eigen::Vector3d normal = X_CO.linear().col(2);
        out.push_back({X_CO, X_CO.inverse(), normal, normal.dot(X_CO.translation())});
    }
    return out;
}

ShownOutline SilhouetteOutlines::outline(const Plate& plate, const PlacedInCamera& at) const {
    const Lens lens(m_camera);
    ShownOutline out;
    if (std::abs(at.offset) < kMinGrazing * at.X_CO.translation().norm())
        return out;
    for (const Eigen::Vector2d& p_O : plate.samples.front()) {
        const Eigen::Vector3d p(p_O.x(), p_O.y(), 0.0), p_C = at.X_CO * p;
        if (p_C.z() < kNearestOutline_m)
            return {};
        OutlineSample sample;
        sample.p_E = plate.X * p;
        sample.shown_px = shownAt(lens, p_C);
        out.samples.push_back(sample);
    }
    setShape(out);
    return out;
}

/// Whether another plate is nearer on the line of sight. Plates in one plane do not hide each other.
bool SilhouetteOutlines::isHidden(const std::vector<PlacedInCamera>& at, const Eigen::Vector3d& p_C,
                                  std::size_t own) const {
    constexpr double kSamePlane = 1e-6;
    for (std::size_t k = 0; k < m_plates.size(); ++k) {
        if (k == own)
            continue;
        const double along = at[k].offset / at[k].normal.dot(p_C);
        if (!(along > 0.0 && along < 1.0 - kSamePlane))
            continue;
        const Eigen::Vector2d p_O = (at[k].X_OC * (along * p_C)).head<2>();
        if (p_O.norm() > m_plates[k].radius_m)
            continue;
        bool isInside = false;
        for (const auto& ring : m_plates[k].rings)
            isInside = isInside != encloses(ring, p_O);
        if (isInside)
            return true;
    }
    return false;
}

std::vector<ShownOutline> SilhouetteOutlines::shown(const Pose& X_RE, const Pose& X_RC) const {
    const std::vector<PlacedInCamera> at = placed(X_RE, X_RC);
    std::vector<ShownOutline> out;
    for (std::size_t k = 0; k < m_objects; ++k) {
        out.push_back(outline(m_plates[k], at[k]));
        for (OutlineSample& sample : out.back().samples)
            sample.isClear = false;
    }
    return out;
}

std::vector<ShownOutline> SilhouetteOutlines::clear(const Pose& X_RE, const Pose& X_RC,
                                                    double reach_px) const {
    const std::vector<PlacedInCamera> at = placed(X_RE, X_RC);
    const Lens lens(m_camera);
    // The edges that are seen; one of an object's own holes counts as another plate's.
    struct Edge {
        std::size_t plate, ring;
        Eigen::Vector2d shown_px;
    };
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < m_plates.size(); ++k)
        for (std::size_t r = 0; r < m_plates[k].samples.size(); ++r)
            for (const Eigen::Vector2d& p_O : m_plates[k].samples[r]) {
                const Eigen::Vector3d p_C = at[k].X_CO * Eigen::Vector3d(p_O.x(), p_O.y(), 0.0);
                if (p_C.z() > kNearestOutline_m && isInPicture(m_camera, p_C) && !isHidden(at, p_C, k))
                    edges.push_back({k, r, shownAt(lens, p_C)});
            }
    std::vector<ShownOutline> out;
    for (std::size_t k = 0; k < m_objects; ++k) {
        out.push_back(outline(m_plates[k], at[k]));
        std::vector<OutlineSample>& samples = out.back().samples;
        Eigen::AlignedBox2d box;
        for (const OutlineSample& sample : samples)
            box.extend(sample.shown_px);
        std::vector<Eigen::Vector2d> others;
        for (const Edge& edge : edges)
            if ((edge.plate != k || edge.ring != 0) &&
                box.squaredExteriorDistance(edge.shown_px) < reach_px * reach_px)
                others.push_back(edge.shown_px);
        const Pose X_CE = X_RC.inverse() * X_RE;
        for (OutlineSample& sample : samples) {
            const Eigen::Vector2d& p = sample.shown_px;
            const auto isNear = [&](const Eigen::Vector2d& q) {
                return (p - q).squaredNorm() < reach_px * reach_px;
            };
            sample.isClear = sample.isClear && p.x() >= reach_px && p.y() >= reach_px &&
                             p.x() <= m_camera.width - 1.0 - reach_px &&
                             p.y() <= m_camera.height - 1.0 - reach_px &&
                             std::ranges::none_of(others, isNear) && !isHidden(at, X_CE * sample.p_E, k);
        }
    }
    return out;
}

} // namespace bask
