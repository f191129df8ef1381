#include "engine/thermography/silhouette_edges.h"

#include "engine/thermography/band_radiance.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bask {
namespace {

constexpr double kPiece_px = 2.5;
constexpr int kMinPixels = 8, kMinOnSide = 2;
constexpr double kMaxShift_px = 2.0;
constexpr double kMaxMisfit = 0.12; // of a piece's pixels, relative to its contrast; beside the noise

struct EdgePixel {
    double distance_px = 0.0, value_K = 0.0;
};

double normalDensity(double z) {
    return std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
}

double normalShare(double z) {
    return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// The pixels of each piece of an outline.
std::vector<std::vector<EdgePixel>> pixelsOfPieces(const LinearPicture& picture, const ShownOutline& outline,
                                                   std::size_t pieces, double reach_px) {
    const std::vector<OutlineSample>& samples = outline.samples;
    Eigen::AlignedBox2d box;
    for (const OutlineSample& sample : samples)
        box.extend(sample.shown_px);
    const int left =
        static_cast<int>(std::clamp(std::floor(box.min().x() - reach_px), 0.0, picture.width - 1.0));
    const int right =
        static_cast<int>(std::clamp(std::ceil(box.max().x() + reach_px), 0.0, picture.width - 1.0));
    const int top =
        static_cast<int>(std::clamp(std::floor(box.min().y() - reach_px), 0.0, picture.height - 1.0));
    const int bottom =
        static_cast<int>(std::clamp(std::ceil(box.max().y() + reach_px), 0.0, picture.height - 1.0));
    struct Nearest {
        double distance = std::numeric_limits<double>::infinity(); ///< not negative
        double outwards = 0.0;
        std::size_t sample = 0;
        double along = 0.0;
    };
    const int columns = right - left + 1;
    std::vector<Nearest> nearest(static_cast<std::size_t>(columns) *
                                 static_cast<std::size_t>(bottom - top + 1));
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const OutlineSample &from = samples[i], &to = samples[(i + 1) % samples.size()];
        const Eigen::Vector2d edge = to.shown_px - from.shown_px;
        const double length = edge.norm();
        const auto clampTo = [](double v, int low, int high) {
            return static_cast<int>(std::clamp(v, static_cast<double>(low), static_cast<double>(high)));
        };
        const Eigen::Vector2d low = from.shown_px.cwiseMin(to.shown_px),
                              high = from.shown_px.cwiseMax(to.shown_px);
        for (int row = clampTo(std::floor(low.y() - reach_px), top, bottom);
             row <= clampTo(std::ceil(high.y() + reach_px), top, bottom); ++row)
            for (int column = clampTo(std::floor(low.x() - reach_px), left, right);
                 column <= clampTo(std::ceil(high.x() + reach_px), left, right); ++column) {
                const Eigen::Vector2d off = Eigen::Vector2d(column, row) - from.shown_px;
                const double share = std::clamp(off.dot(edge) / std::max(length * length, 1e-12), 0.0, 1.0);
                const Eigen::Vector2d away = off - share * edge;
                Nearest& best =
                    nearest[static_cast<std::size_t>(row - top) * static_cast<std::size_t>(columns) +
                            static_cast<std::size_t>(column - left)];
                if (away.norm() < best.distance)
                    best = {away.norm(), away.dot(from.normal + to.normal), i,
                            from.along_px + share * length};
            }
    }
    std::vector<std::vector<EdgePixel>> out(pieces);
    for (int row = top; row <= bottom; ++row)
        for (int column = left; column <= right; ++column) {
            const Nearest& best =
                nearest[static_cast<std::size_t>(row - top) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column - left)];
            const double value = picture.at(column, row);
            if (best.distance > reach_px || !samples[best.sample].isClear || !std::isfinite(value))
                continue;
            const auto piece =
                static_cast<std::size_t>(best.along / outline.length_px * static_cast<double>(pieces));
            out[std::min(piece, pieces - 1)].push_back(
                {best.outwards < 0.0 ? -best.distance : best.distance, value});
        }
    return out;
}

struct EdgeProfile {
    double shift_px = 0.0, shiftVariance = 0.0; ///< the latter for pixels with a variance of 1
    double contrast_K = 0.0, misfit_K = 0.0;
    double blurSum = 0.0, blurWeight = 0.0;
    bool isFound = false;
};

EdgeProfile fitProfile(const std::vector<EdgePixel>& pixels, double curvature, double spread_px) {
    EdgeProfile out;
    const double flat_px = 2.0 * spread_px;
    double inside = 0.0, outside = 0.0;
    int inner = 0, outer = 0;
    for (const EdgePixel& pixel : pixels) {
        if (pixel.distance_px < -flat_px) {
            inside += pixel.value_K;
            ++inner;
        } else if (pixel.distance_px > flat_px) {
            outside += pixel.value_K;
            ++outer;
        }
    }
    if (static_cast<int>(pixels.size()) < kMinPixels || inner < kMinOnSide || outer < kMinOnSide)
        return out;
    const auto n = static_cast<Eigen::Index>(pixels.size());
    const double shrink = 0.5 * curvature * spread_px * spread_px;
    Eigen::Vector3d x(outside / outer, inside / inner - outside / outer, 0.0);
    Eigen::MatrixX3d J(n, 3);
    Eigen::VectorXd miss(n), byBlur(n);
    const auto linearise = [&] {
        for (Eigen::Index i = 0; i < n; ++i) {
            const EdgePixel& pixel = pixels[static_cast<std::size_t>(i)];
            const double z = (x[2] - shrink - pixel.distance_px) / spread_px;
            J.row(i) << 1.0, normalShare(z), x[1] * normalDensity(z) / spread_px;
            miss[i] = pixel.value_K - x[0] - x[1] * normalShare(z);
            byBlur[i] = -x[1] * normalDensity(z) * z / spread_px;
        }
    };
    for (int step = 0; step < 6; ++step) {
        linearise();
        const Eigen::Vector3d change = J.colPivHouseholderQr().solve(miss);
        x += change;
        x[2] = std::clamp(x[2], -kMaxShift_px, kMaxShift_px);
        if (std::abs(change[2]) < 1e-5)
            break;
    }
    linearise();
    const Eigen::Matrix3d information = J.transpose() * J;
    const Eigen::LDLT<Eigen::Matrix3d> solver(information);
    const Eigen::VectorXd own = byBlur - J * solver.solve(J.transpose() * byBlur); // what only blur explains
    out.shift_px = x[2];
    out.contrast_K = x[1];
    out.shiftVariance = solver.solve(Eigen::Vector3d::UnitZ())[2];
    out.misfit_K = std::sqrt(miss.squaredNorm() / static_cast<double>(n - 3));
    out.blurSum = own.dot(miss) / (x[1] * x[1]);
    out.blurWeight = own.squaredNorm() / (x[1] * x[1]);
    out.isFound = x.allFinite() && std::isfinite(out.shiftVariance) && out.shiftVariance > 0.0 &&
                  std::abs(x[2]) < kMaxShift_px;
    return out;
}

} // namespace

double LinearPicture::between(const Eigen::Vector2d& p) const {
    if (!(p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= width - 1.0 && p.y() <= height - 1.0))
        return std::numeric_limits<double>::quiet_NaN();
    const int column = std::min(static_cast<int>(p.x()), width - 2),
              row = std::min(static_cast<int>(p.y()), height - 2);
    const double u = p.x() - column, v = p.y() - row;
    return (1.0 - v) * ((1.0 - u) * at(column, row) + u * at(column + 1, row)) +
           v * ((1.0 - u) * at(column, row + 1) + u * at(column + 1, row + 1));
}

LinearPicture linearPicture(const ThermalPicture& picture) {
    const BandRadiance& band = thermalBand();
    const double scale = 1.0 / band.derivative(300.0);
    LinearPicture out{picture.width, picture.height, {}, 0.0};
    out.value_K.reserve(picture.T_K.size());
    for (const double T_K : picture.T_K)
        out.value_K.push_back(T_K >= kMinBand_K && T_K <= kMaxBand_K
                                  ? scale * band.radiance(T_K)
                                  : std::numeric_limits<double>::quiet_NaN());
    std::vector<double> differences;
    for (std::size_t k = 0; k + 1 < out.value_K.size(); ++k)
        if (const double d = std::abs(out.value_K[k + 1] - out.value_K[k]); std::isfinite(d))
            differences.push_back(d);
    if (!differences.empty()) {
        const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
        std::ranges::nth_element(differences, middle);
        out.noise_K = 1.4826 * *middle / std::numbers::sqrt2;
    }
    return out;
}

double edgeReach_px(double blur_px) {
    return std::max(3.0, 3.5 * blur_px);
}

FoundEdges findEdges(const LinearPicture& picture, const std::vector<ShownOutline>& outlines, double blur_px,
                     double minContrast_K) {
    constexpr double kPixelVariance = 1.0 / 12.0;
    const double spread_px = std::sqrt(blur_px * blur_px + kPixelVariance), reach_px = edgeReach_px(blur_px);
    // Numbers of a sensor have steps, below which no noise shows.
    const double noise_K = std::max(picture.noise_K, 1e-3);
    FoundEdges out;
    for (std::size_t object = 0; object < outlines.size(); ++object) {
        const ShownOutline& outline = outlines[object];
        if (std::ranges::none_of(outline.samples, &OutlineSample::isClear))
            continue;
        const std::size_t n = outline.samples.size();
        const auto pieces =
            static_cast<std::size_t>(std::max(4.0, std::floor(outline.length_px / kPiece_px)));
        const auto pixels = pixelsOfPieces(picture, outline, pieces, reach_px);
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            // The sample nearest to the middle of the piece.
            const double middle =
                outline.length_px * (static_cast<double>(piece) + 0.5) / static_cast<double>(pieces);
            const auto next = std::ranges::lower_bound(outline.samples, middle, {}, &OutlineSample::along_px);
            const OutlineSample& sample =
                outline.samples[static_cast<std::size_t>(next - outline.samples.begin()) % n];
            if (!sample.isClear)
                continue;
            ++out.clear;
            const EdgeProfile found = fitProfile(pixels[piece], sample.curvature_px, spread_px);
            if (std::abs(found.contrast_K) < std::max(minContrast_K, 5.0 * noise_K))
                continue;
            ++out.contrast;
            if (!found.isFound || found.misfit_K > kMaxMisfit * std::abs(found.contrast_K) + 3.0 * noise_K)
                continue;
            out.blurSum_px += found.blurSum;
            out.blurWeight += found.blurWeight;
            out.edges.push_back({object, static_cast<int>(piece), sample.p_E, sample.shown_px, sample.normal,
                                 found.shift_px, noise_K * std::sqrt(found.shiftVariance), found.contrast_K});
        }
    }
    return out;
}

} // namespace bask
