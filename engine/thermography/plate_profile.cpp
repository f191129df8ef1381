#include "engine/thermography/plate_profile.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/thermography/region_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <stdexcept>

namespace bask {
namespace {

/// A ring in one picture.
struct SeenRing {
    double apparent_K = 0.0, standardError_K = 0.0;
    double radius_m = 0.0; ///< mean
    int pixels = 0;
};

struct RingPixels {
    std::vector<int> pixels;
    double radii_m = 0.0; ///< their sum
};

/// Sorts the pixels that tell a temperature into rings.
std::vector<RingPixels> sorted(const ThermalPicture& picture, const PixelRays& rays, const Pose& X_CO,
                               const std::vector<int>& pixels, std::size_t rings, double radius_m) {
    std::vector<RingPixels> out(rings);
    const Eigen::Vector3d normal = X_CO.linear().col(2);
    const double offset = normal.dot(X_CO.translation());
    const Pose X_OC = X_CO.inverse();
    for (const int pixel : pixels) {
        if (!std::isfinite(picture.T_K[static_cast<std::size_t>(pixel)]))
            continue;
        const Eigen::Vector2d& ray = rays.ray(static_cast<std::size_t>(pixel));
        const Eigen::Vector3d direction(ray.x(), ray.y(), 1.0);
        const double r_m = (X_OC * (offset / normal.dot(direction) * direction)).head<2>().norm();
        const auto ring = static_cast<std::size_t>(r_m / radius_m * static_cast<double>(rings));
        RingPixels& into = out[std::min(ring, rings - 1)];
        into.pixels.push_back(pixel);
        into.radii_m += r_m;
    }
    return out;
}

/// The mean over pictures, by their pixels. Where they differ by more than their noise, that counts.
SeenRing meanOf(const std::vector<SeenRing>& seen) {
    SeenRing out;
    for (const SeenRing& one : seen)
        out.pixels += one.pixels;
    double noise = 0.0, scatter = 0.0;
    for (const SeenRing& one : seen) {
        const double share = static_cast<double>(one.pixels) / out.pixels;
        out.apparent_K += share * one.apparent_K;
        out.radius_m += share * one.radius_m;
        noise += share * share * one.standardError_K * one.standardError_K;
    }
    for (const SeenRing& one : seen)
        scatter +=
            static_cast<double>(one.pixels) / out.pixels * std::pow(one.apparent_K - out.apparent_K, 2);
    const double others = std::max(1.0, static_cast<double>(seen.size()) - 1.0);
    out.standardError_K = std::sqrt(std::max(noise, scatter / others));
    return out;
}

} // namespace

Result<PlateProfile> plateProfile(const BandRadiance& band, const PixelRays& rays, const Pose& X_WC,
                                  const PlacedPlate& plate, std::span<const PlateView> views,
                                  const FaceSurroundings& face, const ReadingUncertainty& uncertainty,
                                  const PlateProfileOptions& options, const ShareDone& done) {
    constexpr double kMinRing_px = 1.5;
    if (views.empty() || options.maxRings < 1)
        throw std::invalid_argument("plateProfile: at least one picture and one ring");
    const CameraModel& camera = rays.camera();
    for (const PlateView& view : views)
        if (view.picture.width != camera.width || view.picture.height != camera.height)
            throw std::invalid_argument("plateProfile: a picture of another size");
    const Pose X_CO = X_WC.inverse() * plate.X_WO;
    const double radius_m = shapeRadius(plate.shape), distance_m = X_CO.translation().norm();
    const double facing = -X_CO.linear().col(2).dot(X_CO.translation()) / distance_m; // cosine
    if (facing <= 0.0)
        return Error{MessageCode::ThermalFaceHidden, "", {"0", std::to_string(options.pixels.minPixels)}};
    const double ring_m = std::max(radius_m / options.maxRings,
                                   kMinRing_px * distance_m / (facing * std::min(camera.fx, camera.fy)));
    const auto count = static_cast<std::size_t>(std::max(1.0, std::floor(radius_m / ring_m)));
    std::vector<std::vector<SeenRing>> seen(count);
    std::size_t seenPixels = 0;
    ShareCount share(done, static_cast<double>(views.size()));
    for (const PlateView& view : views) {
        const auto found = facePixels(rays, X_WC, std::span(&plate, 1), view.covers, options.pixels).front();
        if (!found)
            return found.error();
        const auto rings = sorted(view.picture, rays, X_CO, found->pixels, count, radius_m);
        for (std::size_t k = 0; k < count; ++k) {
            seenPixels += rings[k].pixels.size();
            const auto n = static_cast<int>(rings[k].pixels.size());
            if (n < options.pixels.minPixels)
                continue;
            const auto statistics = regionStatistics(view.picture, rings[k].pixels, options.pixels.minPixels);
            if (!statistics)
                return statistics.error();
            seen[k].push_back({statistics->mean_K, statistics->standardError_K, rings[k].radii_m / n, n});
        }
        share.add();
    }
    PlateProfile out;
    for (std::size_t k = 0; k < count; ++k) {
        if (seen[k].empty()) {
            const auto edge_mm = [&](std::size_t ring) {
                return formatNumber(1e3 * radius_m * static_cast<double>(ring) / static_cast<double>(count),
                                    3);
            };
            out.remarks.push_back({MessageCode::PlateProfileRingUnseen, {edge_mm(k), edge_mm(k + 1)}});
            continue;
        }
        const SeenRing ring = meanOf(seen[k]);
        ReadingUncertainty ofRing = uncertainty;
        ofRing.pixels_K = ring.standardError_K;
        const auto reading = estimateFace(band, face, ring.apparent_K, ofRing);
        if (!reading)
            return reading.error();
        out.rings.push_back({ring.radius_m, reading->T_K, reading->standardUncertainty_K,
                             reading->fromPixels_K, ring.pixels});
    }
    if (out.rings.empty())
        return Error{MessageCode::PlateProfilePixelsFew,
                     "",
                     {std::to_string(seenPixels), std::to_string(options.pixels.minPixels)}};
    return out;
}

std::string radialProfileCsv(const PlateProfile& profile, double own_K, double environment_K) {
    if (!(own_K > environment_K))
        throw std::invalid_argument("radialProfileCsv: the source is hotter than its environment");
    std::string out = "radius_mm,temperature_ratio,temperature_degC,standard_uncertainty_K\n";
    for (const PlateRing& ring : profile.rings) {
        std::array<char, 160> line{};
        std::snprintf(line.data(), line.size(), "%.3f,%.6f,%.3f,%.3f\n", 1e3 * ring.radius_m,
                      (ring.T_K - environment_K) / (own_K - environment_K), celsiusFromKelvin(ring.T_K),
                      ring.standardUncertainty_K);
        out += line.data();
    }
    return out;
}

} // namespace bask
