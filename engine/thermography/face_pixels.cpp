#include "engine/thermography/face_pixels.h"

#include "engine/base/message_code.h"
#include "engine/calibration/picture_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace bask {
namespace {

using Ring2 = std::vector<Eigen::Vector2d>;

constexpr int kMaxSide_px = 4096;
constexpr int kOutlinePoints = 128;     ///< of a disk or a Fourier outline: 0.03 px off at a radius of 100 px
constexpr double kMinStep_px = 0.1;     ///< nearer points of an outline are left out
constexpr double kMaxBentEdge_px = 6.0; ///< longer edges are divided, since the lens bends them

/// Returns a ring without points that are nearly where the one before is.
Ring2 thinned(const Ring2& ring) {
    Ring2 out;
    for (const Eigen::Vector2d& p : ring)
        if (out.empty() || (p - out.back()).norm() >= kMinStep_px)
            out.push_back(p);
    return out;
}

/// What a plate covers of the picture: a box of pixels, each inside or not, near an edge or not.
struct Footprint {
    enum Flag : unsigned char { kInside = 1, kNearEdge = 2 };
    int left = 0, top = 0, right = -1, bottom = -1; ///< inclusive
    std::vector<unsigned char> flags;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ(); ///< of the plane, in camera axes
    double offset = 0.0;                               ///< normal . p of its points
    bool isWhole = true;

    bool isEmpty() const { return right < left || bottom < top; }
    unsigned char& flag(int column, int row) {
        return flags[static_cast<std::size_t>(row - top) * static_cast<std::size_t>(right - left + 1) +
                     static_cast<std::size_t>(column - left)];
    }
    unsigned char flagOr0(int column, int row) const {
        if (column < left || column > right || row < top || row > bottom)
            return 0;
        return const_cast<Footprint*>(this)->flag(column, row);
    }
    /// Z of the plane on a line of sight.
    double depth(const Eigen::Vector2d& ray) const {
        return offset / (normal.x() * ray.x() + normal.y() * ray.y() + normal.z());
    }
};

/// Pixel centres inside the rings, by the even-odd rule.
void fill(Footprint& out, const std::vector<Ring2>& rings) {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(out.bottom - out.top + 1));
    for (const Ring2& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k) {
            const Eigen::Vector2d &a = ring[k], &b = ring[(k + 1) % ring.size()];
            const double low = std::min(a.y(), b.y()), high = std::max(a.y(), b.y());
            const int first = std::max(out.top, static_cast<int>(std::ceil(low)));
            for (int row = first; row <= out.bottom && row < high; ++row) // low <= row < high
                crossings[static_cast<std::size_t>(row - out.top)].push_back(
                    a.x() + (row - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
        }
    for (int row = out.top; row <= out.bottom; ++row) {
        std::vector<double>& at = crossings[static_cast<std::size_t>(row - out.top)];
        std::ranges::sort(at);
        for (std::size_t k = 0; k + 1 < at.size(); k += 2) {
            const int first = std::max(out.left, static_cast<int>(std::ceil(at[k])));
            for (int column = first; column <= out.right && column <= at[k + 1]; ++column)
                out.flag(column, row) |= Footprint::kInside;
        }
    }
}

void markNear(Footprint& out, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double distance_px) {
    const auto floorOf = [&](double value) { return static_cast<int>(std::floor(value - distance_px)); };
    const auto ceilOf = [&](double value) { return static_cast<int>(std::ceil(value + distance_px)); };
    const int left = std::max(out.left, floorOf(std::min(a.x(), b.x())));
    const int right = std::min(out.right, ceilOf(std::max(a.x(), b.x())));
    const int top = std::max(out.top, floorOf(std::min(a.y(), b.y())));
    const int bottom = std::min(out.bottom, ceilOf(std::max(a.y(), b.y())));
    const Eigen::Vector2d edge = b - a;
    const double squared = std::max(edge.squaredNorm(), 1e-30);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const Eigen::Vector2d from = Eigen::Vector2d(column, row) - a;
            const Eigen::Vector2d off = from - std::clamp(from.dot(edge) / squared, 0.0, 1.0) * edge;
            if (off.squaredNorm() < distance_px * distance_px)
                out.flag(column, row) |= Footprint::kNearEdge;
        }
}

bool isExact(const SightUncertainty& sight) {
    return sight.across_m == 0.0 && sight.angle_rad == 0.0;
}

/// By how many pixels an edge at p_C may be elsewhere: at most the picture's size, which leaves none.
double offAt(const CameraModel& camera, const SightUncertainty& sight, const Eigen::Vector3d& p_C) {
    const double range_m = p_C.norm();
    const double off_m = 2.0 * std::hypot(sight.across_m, sight.angle_rad * range_m);
    return std::min(std::max(camera.fx, camera.fy) * off_m * range_m / (p_C.z() * p_C.z()),
                    static_cast<double>(std::max(camera.width, camera.height)));
}

/// At the rim of a picture a pixel can be twice as wide as in its middle. What cuts off then lies outside of
/// the picture by the margin and more, so that no edge in it is one of cutting.
Eigen::AlignedBox2d boundsFor(const CameraModel& camera, double margin_px) {
    return raysInPicture(camera, 2.0 * (margin_px + 2.0));
}

/// How far from a plate's edges a pixel has to lie, px, by what of them may be in the picture.
double marginOf(const CameraModel& camera, const std::vector<Ring2>& rings_O, const Pose& X_CO,
                const FacePixelOptions& options) {
    if (isExact(options.sight))
        return options.blur_px;
    double off_px = 0.0; // in the picture's middle, where it does not grow without bounds
    for (const Ring2& ring_O : rings_O)
        for (const Eigen::Vector2d& p : ring_O) {
            const Eigen::Vector3d p_C = X_CO * Eigen::Vector3d(p.x(), p.y(), 0.0);
            off_px = std::max(off_px, offAt(camera, options.sight, {0.0, 0.0, p_C.norm()}));
        }
    const Eigen::AlignedBox2d bounds = boundsFor(camera, options.blur_px + off_px);
    off_px = 0.0;
    for (const Ring2& ring_O : rings_O)
        for (const Eigen::Vector3d& p_C : ringWithin(bounds, X_CO, ring_O))
            off_px = std::max(off_px, offAt(camera, options.sight, p_C));
    return options.blur_px + off_px;
}

Footprint footprintOf(const PixelRays& rays, const PlacedPlate& plate, const Pose& X_CO,
                      const FacePixelOptions& options) {
    const CameraModel& camera = rays.camera();
    const Lens lens(camera);
    const std::vector<Ring2> rings_O = shapeRings(plate.shape, kOutlinePoints);
    const double margin_px = marginOf(camera, rings_O, X_CO, options);
    const Eigen::AlignedBox2d bounds = boundsFor(camera, margin_px);
    Footprint out;
    out.normal = X_CO.linear().col(2);
    out.offset = out.normal.dot(X_CO.translation());
    std::vector<Ring2> rings;
    Eigen::Vector2d min = Eigen::Vector2d::Constant(std::numeric_limits<double>::max()), max = -min;
    for (const Ring2& ring_O : rings_O) {
        const Ring2 shown = thinned(ringInPicture(lens, bounds, X_CO, ring_O, kMaxBentEdge_px));
        for (const Eigen::Vector2d& p : shown) {
            min = min.cwiseMin(p);
            max = max.cwiseMax(p);
        }
        if (shown.size() >= 2)
            rings.push_back(shown);
    }
    if (rings.empty())
        return out;
    out.isWhole =
        min.x() >= -0.5 && min.y() >= -0.5 && max.x() <= camera.width - 0.5 && max.y() <= camera.height - 0.5;
    const auto within = [](double value, int size) {
        return static_cast<int>(std::clamp(value, -1.0, static_cast<double>(size)));
    };
    out.left = std::max(0, within(std::floor(min.x() - margin_px), camera.width));
    out.top = std::max(0, within(std::floor(min.y() - margin_px), camera.height));
    out.right = std::min(camera.width - 1, within(std::ceil(max.x() + margin_px), camera.width));
    out.bottom = std::min(camera.height - 1, within(std::ceil(max.y() + margin_px), camera.height));
    if (out.isEmpty())
        return out;
    const int columns = out.right - out.left + 1, rows = out.bottom - out.top + 1;
    out.flags.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0);
    if (margin_px >= 0.5 * std::hypot(columns, rows)) {
        std::ranges::fill(out.flags, Footprint::kNearEdge);
        return out;
    }
    fill(out, rings);
    for (const Ring2& ring : rings)
        for (std::size_t k = 0; k < ring.size(); ++k)
            markNear(out, ring[k], ring[(k + 1) % ring.size()], margin_px);
    return out;
}

/// Whether a plate covers what lies at `depth` on the line of sight. Plates in one plane do not cover each
/// other.
bool covers(const Footprint& plate, int column, int row, const Eigen::Vector2d& ray, double depth) {
    constexpr double kSamePlane = 1e-6;
    if (plate.flagOr0(column, row) == 0)
        return false;
    const double own = plate.depth(ray);
    return own > 0.0 && own < depth * (1.0 - kSamePlane);
}

Result<FacePixels> pixelsOf(const PixelRays& rays, const std::vector<Footprint>& plates, std::size_t object,
                            const Pose& X_CO, const FacePixelOptions& options) {
    const Footprint& own = plates[object];
    const Eigen::Vector3d camera_O = X_CO.inverse().translation();
    FacePixels out;
    out.isFront = camera_O.z() < 0.0;
    out.isWhole = own.isWhole;
    out.angle_rad = std::acos(std::clamp(std::abs(camera_O.z()) / camera_O.norm(), 0.0, 1.0));
    bool isShown = false;
    int clear = 0;
    for (int row = own.top; row <= own.bottom; ++row)
        for (int column = own.left; column <= own.right; ++column) {
            const unsigned char flag = own.flagOr0(column, row);
            isShown = isShown || flag != 0;
            if (flag != Footprint::kInside)
                continue;
            ++clear;
            const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(rays.camera().width) +
                               static_cast<std::size_t>(column);
            const Eigen::Vector2d& ray = rays.ray(pixel);
            const double depth = own.depth(ray);
            bool isHidden = false;
            for (std::size_t k = 0; k < plates.size() && !isHidden; ++k)
                isHidden = k != object && covers(plates[k], column, row, ray, depth);
            if (!isHidden)
                out.pixels.push_back(static_cast<int>(pixel));
        }
    if (!isShown)
        return Error{MessageCode::ThermalFaceOutside, {}};
    if (!(out.angle_rad <= std::numbers::pi / 2.0 - options.minAngle_rad))
        return Error{MessageCode::ThermalFaceGrazing,
                     {},
                     {formatNumber(90.0 - out.angle_rad * 180.0 / std::numbers::pi, 2)}};
    const std::vector<MessageArg> counts{std::to_string(out.pixels.size()),
                                         std::to_string(options.minPixels)};
    if (clear < options.minPixels)
        return Error{MessageCode::ThermalFaceSmall, {}, counts};
    if (static_cast<int>(out.pixels.size()) < options.minPixels)
        return Error{MessageCode::ThermalFaceHidden, {}, counts};
    return out;
}

} // namespace

PixelRays::PixelRays(const CameraModel& camera) : m_camera(camera) {
    if (camera.width < 1 || camera.height < 1 || camera.width > kMaxSide_px || camera.height > kMaxSide_px)
        throw std::invalid_argument("PixelRays: a camera of 1 to 4096 pixels each way is needed");
    const Lens lens(camera);
    m_rays.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
    for (int row = 0; row < camera.height; ++row)
        for (int column = 0; column < camera.width; ++column) {
            const auto ray = rayOf(lens, Eigen::Vector2d(column, row));
            if (!ray)
                throw std::invalid_argument(
                    "PixelRays: the lens model cannot be inverted within the picture");
            m_rays.push_back(*ray);
        }
}

bool PixelRays::isUsable(const CameraModel& camera) {
    const Lens lens(camera);
    constexpr int kLines = 24; // both ways, with the edges; where a lens model fails it fails beyond a curve
    for (int i = 0; i <= kLines; ++i)
        for (int k = 0; k <= kLines; ++k)
            if (!rayOf(lens, Eigen::Vector2d((camera.width - 1.0) * i / kLines,
                                             (camera.height - 1.0) * k / kLines)))
                return false;
    return true;
}

std::vector<Result<FacePixels>> facePixels(const PixelRays& rays, const Pose& X_WC,
                                           std::span<const PlacedPlate> objects,
                                           std::span<const PlacedPlate> screens,
                                           const FacePixelOptions& options) {
    if (!(options.blur_px >= kMinBlur_px && options.blur_px <= 100.0) || options.minPixels < 1 ||
        !(options.minAngle_rad >= 0.0) || !(options.sight.across_m >= 0.0) ||
        !(options.sight.angle_rad >= 0.0))
        throw std::invalid_argument("facePixels: a blur of 1.5 to 100 px, at least one pixel");
    const Pose X_CW = X_WC.inverse();
    std::vector<Pose> poses;
    std::vector<Footprint> footprints;
    poses.reserve(objects.size() + screens.size());
    footprints.reserve(objects.size() + screens.size());
    for (const auto& plates : {objects, screens})
        for (const PlacedPlate& plate : plates) {
            poses.push_back(X_CW * plate.X_WO);
            footprints.push_back(footprintOf(rays, plate, poses.back(), options));
        }
    std::vector<Result<FacePixels>> out;
    for (std::size_t i = 0; i < objects.size(); ++i)
        out.push_back(pixelsOf(rays, footprints, i, poses[i], options));
    if (isExact(options.sight) ||
        std::ranges::all_of(out, [](const Result<FacePixels>& found) { return found.ok(); }))
        return out;
    FacePixelOptions known = options;
    known.sight = {};
    const std::vector<Result<FacePixels>> asIfKnown = facePixels(rays, X_WC, objects, screens, known);
    for (std::size_t i = 0; i < objects.size(); ++i)
        if (!out[i])
            out[i] = asIfKnown[i] ? Error{MessageCode::ThermalPlaceVague, {}} : asIfKnown[i].error();
    return out;
}

} // namespace bask
