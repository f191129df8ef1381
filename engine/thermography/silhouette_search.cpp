#include "engine/thermography/silhouette_search.h"

#include "engine/calibration/contour_fit.h"
#include "engine/calibration/projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bask {
namespace {

constexpr double kBeside_px = 2.0; // from the outline to what is sampled inside and outside

/// 0 where two values are alike, 1 where they differ by far more than the contrast that is looked for.
double difference(double a, double b, double contrast_K) {
    const double squared = (a - b) * (a - b), scale = 1.5 * contrast_K;
    return squared / (squared + scale * scale);
}

double middleOf(std::vector<double>& values) {
    if (values.empty())
        return std::numeric_limits<double>::quiet_NaN();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Some points of one object's outline in one view, as the camera at the start pose has them.
struct GridOutline {
    const LinearPicture* picture = nullptr;
    std::vector<Eigen::Vector3d> p_C;
    std::vector<Eigen::Vector2d> normals;
};

double nearestValue(const LinearPicture& picture, const Eigen::Vector2d& p) {
    const double column = std::round(p.x()), row = std::round(p.y());
    if (!(column >= 0.0 && row >= 0.0 && column < picture.width && row < picture.height))
        return std::numeric_limits<double>::quiet_NaN();
    return picture.at(static_cast<int>(column), static_cast<int>(row));
}

/// The sum over all points of how well they fit, each 0 to 1, if the camera sees everything turned by `R`.
double scoreOf(const std::vector<GridOutline>& outlines, const Lens& lens, const Eigen::Matrix3d& R,
               double roll_rad, double contrast_K) {
    const Eigen::Rotation2Dd roll(roll_rad);
    double score = 0.0;
    std::vector<double> inside, outside, sorted;
    for (const GridOutline& outline : outlines) {
        inside.clear();
        outside.clear();
        for (std::size_t k = 0; k < outline.p_C.size(); ++k) {
            const Eigen::Vector3d p_C = R * outline.p_C[k];
            if (p_C.z() <= 0.0)
                continue;
            const Eigen::Vector2d shown = shownAt(lens, p_C),
                                  beside = roll * (kBeside_px * outline.normals[k]);
            const double in = nearestValue(*outline.picture, shown - beside);
            const double out = nearestValue(*outline.picture, shown + beside);
            if (std::isnan(in) || std::isnan(out))
                continue;
            inside.push_back(in);
            outside.push_back(out);
        }
        sorted = inside;
        const double level = middleOf(sorted);
        for (std::size_t k = 0; k < inside.size(); ++k)
            score +=
                difference(outside[k], level, contrast_K) * (1.0 - difference(inside[k], level, contrast_K));
    }
    return score;
}

std::vector<GridOutline> gridOutlines(const SilhouetteOutlines& outlines, std::span<const LinearView> views,
                                      const Pose& X_RC) {
    constexpr std::size_t kPoints = 24, kMaxViews = 8;
    std::vector<GridOutline> out;
    const std::size_t stride = (views.size() + kMaxViews - 1) / kMaxViews;
    for (std::size_t v = 0; v < views.size(); v += stride)
        for (const ShownOutline& shown : outlines.shown(views[v].X_RE, X_RC)) {
            GridOutline one{&views[v].picture, {}, {}};
            for (std::size_t k = 0; k < shown.samples.size(); k += shown.samples.size() / kPoints) {
                one.p_C.push_back(X_RC.inverse() * views[v].X_RE * shown.samples[k].p_E);
                one.normals.push_back(shown.samples[k].normal);
            }
            if (!one.p_C.empty())
                out.push_back(std::move(one));
        }
    return out;
}

struct GridTurn {
    int x = 0, y = 0, roll = 0;
    double score = 0.0;
};

/// The best turn, then the best of those that are not beside a better one.
std::vector<GridTurn> bestTurns(std::vector<GridTurn> turns, std::size_t max) {
    constexpr int kApart = 3;
    std::ranges::sort(turns, std::greater{}, &GridTurn::score);
    std::vector<GridTurn> out;
    for (const GridTurn& turn : turns) {
        const auto isBeside = [&](const GridTurn& better) {
            return std::abs(turn.x - better.x) < kApart && std::abs(turn.y - better.y) < kApart &&
                   std::abs(turn.roll - better.roll) < kApart;
        };
        if (std::ranges::none_of(out, isBeside))
            out.push_back(turn);
        if (out.size() == max)
            break;
    }
    return out;
}

double meanDepth_m(const std::vector<GridOutline>& outlines) {
    double sum = 0.0, points = 0.0;
    for (const GridOutline& outline : outlines)
        for (const Eigen::Vector3d& p_C : outline.p_C) {
            sum += p_C.z();
            points += 1.0;
        }
    return sum / points;
}

/// Where along the normal of a sample the picture has the edge of an object of this level.
std::optional<double> halfLevel(const LinearPicture& picture, const OutlineSample& sample, double level,
                                double reach_px, double contrast_K) {
    constexpr double kStep_px = 0.5, kMinFit = 0.3;
    const auto valueAt = [&](double s) { return picture.between(sample.shown_px + s * sample.normal); };
    double best = kMinFit, at = 0.0;
    bool isFound = false;
    for (double s = -reach_px; s <= reach_px; s += kStep_px) {
        const double in = 0.5 * (valueAt(s - 1.0) + valueAt(s - kBeside_px));
        const double out = 0.5 * (valueAt(s + 1.0) + valueAt(s + kBeside_px));
        const double fit = difference(out, level, contrast_K) * (1.0 - difference(in, level, contrast_K)) *
                           (1.0 - 0.3 * s * s / (reach_px * reach_px));
        if (fit > best) { // not of NaN
            best = fit;
            at = s;
            isFound = true;
        }
    }
    if (!isFound)
        return std::nullopt;
    const double half = 0.5 * (level + valueAt(at + kBeside_px));
    for (double s = at - kBeside_px; s < at + kBeside_px; s += kStep_px) {
        const double a = valueAt(s) - half, b = valueAt(s + kStep_px) - half;
        if ((a < 0.0) != (b < 0.0))
            return s + kStep_px * a / (a - b);
    }
    return std::nullopt;
}

std::vector<ContourSight> roughSights(const SilhouetteOutlines& outlines, std::span<const LinearView> views,
                                      const Pose& X_RC, double reach_px, double contrast_K) {
    constexpr double kApart_px = 2.0;
    std::vector<ContourSight> sights;
    for (const LinearView& view : views) {
        ContourSight sight{view.X_RE, {}};
        for (const ShownOutline& outline : outlines.shown(view.X_RE, X_RC)) {
            std::vector<double> inside;
            for (const OutlineSample& sample : outline.samples)
                if (const double value = view.picture.between(sample.shown_px - kBeside_px * sample.normal);
                    std::isfinite(value))
                    inside.push_back(value);
            const double level = middleOf(inside);
            double next_px = 0.0;
            for (const OutlineSample& sample : outline.samples) {
                if (sample.along_px < next_px)
                    continue;
                next_px = sample.along_px + kApart_px;
                if (const auto s = halfLevel(view.picture, sample, level, reach_px, contrast_K))
                    sight.points.push_back(
                        {sample.p_E, sample.shown_px + *s * sample.normal, sample.normal, 0.5});
            }
        }
        sights.push_back(std::move(sight));
    }
    return sights;
}

} // namespace

Pose roughlyFitted(const SilhouetteOutlines& outlines, std::span<const LinearView> views, const Pose& start,
                   const StartUncertainty& uncertainty, double reach_px, double minContrast_K) {
    constexpr int kSteps = 4;
    constexpr double kMinReach_px = 2.5;
    Vector6d prior;
    prior << Eigen::Vector3d::Constant(1.0 / (uncertainty.position_m * uncertainty.position_m)),
        Eigen::Vector3d::Constant(1.0 / (uncertainty.angle_rad * uncertainty.angle_rad));
    Pose X_RC = start;
    for (int halving = 0; halving < 3; ++halving, reach_px = std::max(0.5 * reach_px, kMinReach_px))
        for (int step = 0; step < kSteps; ++step) {
            const auto sights = roughSights(outlines, views, X_RC, reach_px, minContrast_K);
            const auto fitted =
                fitContours(sights, outlines.camera(), X_RC, reach_px, Matrix6d(prior.asDiagonal()));
            if (!fitted)
                return X_RC;
            X_RC = *fitted;
        }
    return X_RC;
}

std::vector<Pose> likelyPoses(const SilhouetteOutlines& outlines, std::span<const LinearView> views,
                              const Pose& start, const StartUncertainty& uncertainty, double minContrast_K,
                              const ShareDone& done) {
    constexpr double kStep_px = 2.0, kRollStep_rad = 0.04;
    constexpr std::size_t kMax = 4;
    const std::vector<GridOutline> grid = gridOutlines(outlines, views, start);
    if (grid.empty())
        return {};
    const Lens lens(outlines.camera());
    const double max_rad = uncertainty.angle_rad + uncertainty.position_m / meanDepth_m(grid);
    const double step_rad = kStep_px / lens.fx;
    // By more than the picture's width no object that was in it stays there.
    const int max =
        static_cast<int>(std::ceil(std::min(max_rad / step_rad, outlines.camera().width / kStep_px)));
    const int maxRoll = static_cast<int>(std::ceil(uncertainty.angle_rad / kRollStep_rad));
    const auto turnOf = [&](const GridTurn& turn) {
        return (Eigen::AngleAxisd(turn.x * step_rad, Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(turn.y * step_rad, Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(turn.roll * kRollStep_rad, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    };
    std::vector<GridTurn> turns;
    ShareCount share(done, (2.0 * maxRoll + 1.0) * (2.0 * max + 1.0));
    for (int roll = -maxRoll; roll <= maxRoll; ++roll)
        for (int x = -max; x <= max; ++x, share.add())
            for (int y = -max; y <= max; ++y) {
                GridTurn turn{x, y, roll, 0.0};
                turn.score = scoreOf(grid, lens, turnOf(turn), roll * kRollStep_rad, minContrast_K);
                turns.push_back(turn);
            }
    std::vector<Pose> out;
    for (const GridTurn& turn : bestTurns(std::move(turns), kMax)) {
        Pose X_RC = start;
        X_RC.linear() = start.linear() * turnOf(turn).transpose();
        out.push_back(
            roughlyFitted(outlines, views, X_RC, uncertainty, std::max(4.0, 0.05 * lens.fx), minContrast_K));
    }
    return out;
}

} // namespace bask
