#include "engine/thermography/silhouette_pose.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/contour_fit.h"
#include "engine/calibration/projection.h"
#include "engine/calibration/relative_pose.h"
#include "engine/calibration/rigid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bask {
namespace {

constexpr int kMinPointsOfView = 8;
constexpr double kMinFoundShare = 0.5, kMinContrastShare = 0.3, kMaxRms_px = 1.0;
/// Standard deviation of what all edges are off outwards, and averaging does not remove: the lens's spot is
/// no normal distribution.
constexpr double kLastingEdge_px = 0.01;
// A second pose fits as well up to this: no lens's model is better known.
constexpr double kAlike = 1.2, kAlike_px = 0.05;
constexpr double kMinSpot_px = 0.2, kMaxSpot_px = 2.0;

/// An edge in one view, with its miss from the outline.
struct UsedEdge {
    std::size_t view = 0;
    OutlineEdge edge;
    ContourPoint point;
    double miss_px = 0.0;
};

/// What the pictures show of the outlines at one pose.
struct Sighting {
    std::vector<UsedEdge> edges;
    int clear = 0, contrast = 0;
    double blurSum_px = 0.0, blurWeight = 0.0;

    double foundShare() const { return clear > 0 ? static_cast<double>(edges.size()) / clear : 0.0; }
};

struct Work {
    const CameraModel& camera;
    const SilhouetteOutlines& outlines;
    std::span<const LinearView> views;
    const SilhouetteOptions& options;
};

Sighting sightingAt(const Work& work, const Pose& X_RC, double blur_px) {
    Sighting out;
    const double reach_px = edgeReach_px(blur_px) + 1.5;
    for (std::size_t v = 0; v < work.views.size(); ++v) {
        const LinearView& view = work.views[v];
        const FoundEdges found = findEdges(view.picture, work.outlines.clear(view.X_RE, X_RC, reach_px),
                                           blur_px, work.options.minContrast_K);
        out.clear += found.clear;
        out.contrast += found.contrast;
        out.blurSum_px += found.blurSum_px;
        out.blurWeight += found.blurWeight;
        for (const OutlineEdge& edge : found.edges)
            out.edges.push_back(
                {v,
                 edge,
                 {edge.p_E, edge.shown_px + edge.shift_px * edge.normal, edge.normal, edge.deviation_px},
                 edge.shift_px});
    }
    return out;
}

std::vector<ContourSight> sightsOf(const Work& work, const Sighting& sighting, double scatter_px) {
    std::vector<ContourSight> sights;
    for (const LinearView& view : work.views)
        sights.push_back({view.X_RE, {}});
    for (const UsedEdge& used : sighting.edges) {
        ContourPoint point = used.point;
        point.deviation_px = std::hypot(point.deviation_px, scatter_px);
        sights[used.view].points.push_back(point);
    }
    return sights;
}

void setMisses(const Work& work, Sighting& sighting, const Pose& X_RC) {
    for (UsedEdge& used : sighting.edges)
        used.miss_px = contourMiss(used.point, work.views[used.view].X_RE, work.camera, X_RC);
}

/// The scatter beyond the noise that makes the weighted squares as many as their degrees of freedom (Paule
/// and Mandel 1982): what pixels, outlines and surroundings are not as the model has them.
double scatterOf(const Sighting& sighting) {
    const double freedom = std::max(1.0, static_cast<double>(sighting.edges.size()) - 6.0);
    const auto squares = [&](double scatter_px) {
        double sum = 0.0;
        for (const UsedEdge& used : sighting.edges) {
            const double z = used.miss_px / std::hypot(used.edge.deviation_px, scatter_px);
            sum += z * z;
        }
        return sum;
    };
    if (squares(0.0) <= freedom)
        return 0.0;
    double low = 0.0, high = kMaxRms_px;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (squares(middle) > freedom ? low : high) = middle;
    }
    return high;
}

void leaveOutFar(Sighting& sighting, double scatter_px) {
    constexpr double kFar = 4.0; // deviations
    std::erase_if(sighting.edges, [&](const UsedEdge& used) {
        return std::abs(used.miss_px) > kFar * std::hypot(used.edge.deviation_px, scatter_px);
    });
}

/// A pose with the edges that it rests on.
struct Refined {
    Pose X_RC = Pose::Identity();
    Sighting sighting;
    double scatter_px = 0.0, blur_px = 0.0;
    bool isConverged = false;

    double rms_px() const {
        double sum = 0.0;
        for (const UsedEdge& used : sighting.edges)
            sum += used.miss_px * used.miss_px;
        return std::sqrt(sum / std::max<double>(1.0, static_cast<double>(sighting.edges.size())));
    }
};

/// Fits the pose and the blur to the edges, which are looked for anew at each pose.
Refined refined(const Work& work, const Pose& start, double blur_px, int maxSteps) {
    constexpr double kStill_px = 2e-3, kRobust = 2.0, kMaxBlurStep_px = 0.2;
    Refined out;
    out.X_RC = start;
    out.blur_px = blur_px;
    out.scatter_px = 0.2;
    for (int step = 0; step < maxSteps && !out.isConverged; ++step) {
        out.sighting = sightingAt(work, out.X_RC, out.blur_px);
        if (out.sighting.edges.size() < 12)
            return out;
        const auto fitted =
            fitContours(sightsOf(work, out.sighting, out.scatter_px), work.camera, out.X_RC, kRobust);
        if (!fitted)
            return out;
        out.X_RC = *fitted;
        double moved_px = 0.0;
        const Sighting before = out.sighting;
        setMisses(work, out.sighting, out.X_RC);
        for (std::size_t k = 0; k < before.edges.size(); ++k)
            moved_px = std::max(moved_px, std::abs(before.edges[k].miss_px - out.sighting.edges[k].miss_px));
        Sighting near = out.sighting;
        leaveOutFar(near, out.scatter_px);
        out.scatter_px = scatterOf(near);
        const double spread = std::sqrt(out.blur_px * out.blur_px + 1.0 / 12.0);
        const double change = std::clamp(out.sighting.blurSum_px / std::max(out.sighting.blurWeight, 1e-9),
                                         -kMaxBlurStep_px, kMaxBlurStep_px);
        const double better = std::max(0.0, spread + change);
        out.blur_px =
            std::clamp(std::sqrt(std::max(0.0, better * better - 1.0 / 12.0)), kMinSpot_px, kMaxSpot_px);
        out.isConverged = moved_px < kStill_px;
    }
    return out;
}

/// Weighted sums over a view's edges, by the displacement of X_CE.
struct ViewSums {
    Matrix6d information = Matrix6d::Zero();
    Vector6d gradient = Vector6d::Zero();
    Vector6d outwards = Vector6d::Zero(); ///< the gradient if all edges were off outwards by 1 px
};

std::vector<ViewSums> sumsOf(const Work& work, const Refined& fit) {
    std::vector<ViewSums> sums(work.views.size());
    for (const UsedEdge& used : fit.sighting.edges) {
        const double variance =
            used.edge.deviation_px * used.edge.deviation_px + fit.scatter_px * fit.scatter_px;
        const ContourJacobian J =
            contourJacobian(used.point, work.camera, fit.X_RC.inverse() * work.views[used.view].X_RE);
        sums[used.view].information += J.byPart * J.byPart.transpose() / variance;
        sums[used.view].gradient += J.byPart * J.miss_px / variance;
        sums[used.view].outwards += J.byPart / variance;
    }
    return sums;
}

/// By how much the variance of a mean over pieces is larger than for independent ones: neighbours have errors
/// in common. With Bartlett's weights; at least 1.
double correlationOf(const Refined& fit) {
    constexpr int kLags = 4;
    double factor = 1.0, squares = 0.0;
    const auto& edges = fit.sighting.edges;
    const auto normed = [&](const UsedEdge& used) {
        return used.miss_px / std::hypot(used.edge.deviation_px, fit.scatter_px);
    };
    for (const UsedEdge& used : edges)
        squares += normed(used) * normed(used);
    const double mean = squares / std::max<double>(1.0, static_cast<double>(edges.size()));
    for (int lag = 1; lag <= kLags; ++lag) {
        double sum = 0.0;
        int pairs = 0;
        for (std::size_t a = 0; a < edges.size(); ++a)
            for (std::size_t b = a + 1; b < std::min(edges.size(), a + 1 + kLags); ++b)
                if (edges[a].view == edges[b].view && edges[a].edge.object == edges[b].edge.object &&
                    edges[b].edge.piece - edges[a].edge.piece == lag) {
                    sum += normed(edges[a]) * normed(edges[b]);
                    ++pairs;
                }
        if (pairs > 20 && mean > 0.0)
            factor += 2.0 * (1.0 - lag / (kLags + 1.0)) * sum / pairs / mean;
    }
    return std::max(1.0, factor);
}

/// Sets pose, covariance and the robot's own errors.
void setCovariance(const Work& work, const Refined& fit, SilhouettePose& out) {
    const double correlation = correlationOf(fit);
    out.X_RC = fit.X_RC;
    out.effectivePoints = static_cast<double>(fit.sighting.edges.size()) / correlation;
    const std::vector<ViewSums> sums = sumsOf(work, fit);
    // No robot is off by so much; it keeps finite what one picture does not tell, as the turn of a disk.
    Vector6d prior;
    prior << Eigen::Vector3d::Constant(1.0 / (0.05 * 0.05)), Eigen::Vector3d::Constant(1.0 / (0.1 * 0.1));
    Matrix6d information = Matrix6d::Zero();
    Vector6d outwards = Vector6d::Zero();
    std::vector<RigidSight> sights;
    double explained = 0.0;
    for (std::size_t v = 0; v < sums.size(); ++v) {
        if (sums[v].information.isZero())
            continue;
        RigidSight sight;
        const Matrix6d byCamera = betweenJacobian(fit.X_RC, work.views[v].X_RE).byA;
        // Of X_CE in the axes of C, as its own displacement is.
        sight.noise = (sums[v].information + Matrix6d(prior.asDiagonal())).inverse();
        sight.moved = sight.noise * sums[v].gradient;
        sight.byUnknowns = byCamera;
        information += byCamera.transpose() * sums[v].information * byCamera;
        outwards += byCamera.transpose() * sums[v].outwards;
        explained += sums[v].gradient.dot(sight.moved);
        sight.noise *= correlation;
        sights.push_back(sight);
    }
    const Vector6d lasting = kLastingEdge_px * information.ldlt().solve(outwards);
    const Matrix6d ofLasting = lasting * lasting.transpose();
    out.covariance = correlation * information.inverse() + ofLasting;
    const double freedom = 6.0 * static_cast<double>(sights.size()) - 6.0;
    if (sights.size() < 3 || explained <= correlation * freedom)
        return;
    const RigidFit moved = fitRigid(sights);
    out.X_RC = displaced(fit.X_RC, moved.unknowns.head<6>());
    out.covariance = moved.covariance + ofLasting;
    out.robot_m = moved.position_m;
    out.robot_rad = moved.angle_rad;
}

void setSpread(const Work& work, const SilhouetteScene& scene, SilhouettePose& out) {
    for (const LinearView& view : work.views)
        for (const MountedPlate& object : scene.objects) {
            const Eigen::Vector3d arm = view.X_RE * object.X_EO.translation() - out.X_RC.translation();
            const Matrix6d carried = carriedBy(arm);
            const Matrix6d at = carried * out.covariance * carried.transpose();
            const PoseSpread spread = spreadOf(at);
            out.atObjects.position_m = std::max(out.atObjects.position_m, spread.position_m);
            out.atObjects.angle_rad = std::max(out.atObjects.angle_rad, spread.angle_rad);
            const Eigen::Vector3d sight = arm.normalized();
            const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - sight * sight.transpose();
            Matrix6d seen = at;
            seen.topLeftCorner<3, 3>() = across * at.topLeftCorner<3, 3>() * across;
            out.across_m = std::max(out.across_m, spreadOf(seen).position_m);
        }
}

void setRemarks(const Work& work, const SilhouetteScene& scene, SilhouettePose& out) {
    constexpr std::size_t kAdvisedViews = 4;
    constexpr double kMinWidth_m = 0.01, kMinDepth = 0.1;
    if (work.views.size() < kAdvisedViews)
        out.remarks.push_back({MessageCode::SilhouettePosesFew,
                               {std::to_string(work.views.size()), std::to_string(kAdvisedViews)}});
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const LinearView& view : work.views)
        middle += view.X_RE.translation() / static_cast<double>(work.views.size());
    Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
    double nearest_m = HUGE_VAL, farthest_m = 0.0;
    for (const LinearView& view : work.views) {
        const Eigen::Vector3d off = view.X_RE.translation() - middle;
        scatter += off * off.transpose() / static_cast<double>(work.views.size());
        for (const MountedPlate& object : scene.objects) {
            const double depth_m = (out.X_RC.inverse() * view.X_RE * object.X_EO.translation()).z();
            nearest_m = std::min(nearest_m, depth_m);
            farthest_m = std::max(farthest_m, depth_m);
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter, Eigen::EigenvaluesOnly);
    const double width_m = 2.0 * std::sqrt(std::max(0.0, solver.eigenvalues()[1]));
    if (width_m < kMinWidth_m)
        out.remarks.push_back({MessageCode::SilhouettePosesInLine, {formatNumber(1e3 * width_m, 2)}});
    const double range = (farthest_m - nearest_m) / farthest_m;
    if (range < kMinDepth)
        out.remarks.push_back({MessageCode::SilhouetteDepthAlike, {formatNumber(100.0 * range, 2)}});
}

/// A flat scene that is seen from afar looks the same with its tilt towards the camera mirrored. Returns that
/// pose, if it is near enough to be meant.
std::optional<Pose> mirroredPose(const Work& work, const SilhouetteScene& scene, const Refined& fit) {
    constexpr double kMinTurn_rad = 0.05;
    Eigen::Vector3d middle = Eigen::Vector3d::Zero(), normal = middle;
    for (const UsedEdge& used : fit.sighting.edges) {
        const Pose X_CE = fit.X_RC.inverse() * work.views[used.view].X_RE;
        middle += X_CE * used.edge.p_E / static_cast<double>(fit.sighting.edges.size());
        Eigen::Vector3d n = X_CE.linear() * scene.objects[used.edge.object].X_EO.linear().col(2);
        normal += n.z() < 0.0 ? n : Eigen::Vector3d(-n);
    }
    const Eigen::Vector3d towards = -middle.normalized();
    const Eigen::Vector3d axis = towards.cross(normal.normalized());
    const double turn_rad = 2.0 * std::asin(std::min(1.0, axis.norm()));
    if (turn_rad < kMinTurn_rad || turn_rad > 2.0 * work.options.start.angle_rad)
        return std::nullopt;
    // The scene turned about its middle is the camera turned the other way.
    const Pose turned = Eigen::Translation3d(middle) * Eigen::AngleAxisd(turn_rad, axis.normalized()) *
                        Eigen::Translation3d(-middle);
    return fit.X_RC * turned;
}

/// Error if there is no pose of the camera that the pictures support.
std::optional<Error> reasonAgainst(const Work& work, const Refined& fit) {
    const Sighting& seen = fit.sighting;
    if (seen.clear == 0)
        return Error{MessageCode::SilhouetteOutside, ""};
    if (seen.contrast < kMinContrastShare * seen.clear)
        return Error{MessageCode::SilhouetteNoContrast, "", {differenceArg(work.options.minContrast_K, 2)}};
    if (!fit.isConverged || seen.foundShare() < kMinFoundShare || !(fit.rms_px() < kMaxRms_px))
        return Error{MessageCode::SilhouetteContradicts, "", {formatNumber(100.0 * seen.foundShare(), 2)}};
    return std::nullopt;
}

bool isAnyInPicture(const Work& work, const Pose& X_RC) {
    const Lens lens(work.camera);
    return std::ranges::any_of(work.views, [&](const LinearView& view) {
        return std::ranges::any_of(work.outlines.shown(view.X_RE, X_RC), [&](const ShownOutline& outline) {
            return std::ranges::any_of(outline.samples, [&](const OutlineSample& sample) {
                return isInPicture(work.camera, X_RC.inverse() * view.X_RE * sample.p_E);
            });
        });
    });
}

Result<std::vector<LinearView>> linearViews(const CameraModel& camera,
                                            std::span<const SilhouetteView> views) {
    std::vector<LinearView> out;
    for (std::size_t v = 0; v < views.size(); ++v) {
        const ThermalPicture& picture = views[v].picture;
        const std::string where = "picture " + std::to_string(v + 1);
        if (const auto same = checkSize(camera, picture.width, picture.height); !same)
            return Error{same.error().code(), where, same.error().message.args};
        if (isConstant(picture))
            return Error{MessageCode::ThermalPictureConstant, where};
        out.push_back({linearPicture(picture), views[v].X_RE});
    }
    return out;
}

void checkArguments(const CameraModel& camera, std::span<const SilhouetteView> views,
                    const SilhouetteScene& scene, const Pose& start, const SilhouetteOptions& options) {
    if (!(camera.width > 0 && camera.height > 0 && camera.fx > 0.0 && camera.fy > 0.0))
        throw std::invalid_argument("silhouettePose: a camera has a size and focal lengths");
    if (scene.objects.empty())
        throw std::invalid_argument("silhouettePose: at least one object");
    const auto isFinite = [](const Pose& X) { return X.matrix().allFinite(); };
    if (!isFinite(start) || !std::ranges::all_of(views, isFinite, &SilhouetteView::X_RE))
        throw std::invalid_argument("silhouettePose: poses are finite");
    if (!(options.blur_px >= kMinSpot_px && options.blur_px <= kMaxSpot_px && options.minContrast_K > 0.0 &&
          options.start.position_m > 0.0 && options.start.angle_rad > 0.0 && options.minViews > 0))
        throw std::invalid_argument("silhouettePose: options out of range");
}

} // namespace

Result<SilhouettePose> silhouettePose(const CameraModel& camera, std::span<const SilhouetteView> views,
                                      const SilhouetteScene& scene, const Pose& start,
                                      const SilhouetteOptions& options, const ShareDone& done) {
    constexpr double kSearching = 0.5; // share of the time
    checkArguments(camera, views, scene, start, options);
    const auto fewViews = [&](std::size_t count) {
        return Error{
            MessageCode::SilhouetteViewsFew, "", {std::to_string(count), std::to_string(options.minViews)}};
    };
    if (views.size() < options.minViews)
        return fewViews(views.size());
    const auto linear = linearViews(camera, views);
    if (!linear)
        return linear.error();
    const SilhouetteOutlines outlines(camera, scene);
    const Work work{camera, outlines, *linear, options};
    if (!isAnyInPicture(work, start))
        return Error{MessageCode::SilhouetteOutside, ""};

    Refined best;
    const std::vector<Pose> likely = likelyPoses(outlines, *linear, start, options.start,
                                                 options.minContrast_K, partOf(done, 0.0, kSearching));
    ShareCount share(partOf(done, kSearching, 1.0), static_cast<double>(likely.size()) + 2.0);
    for (const Pose& rough : likely) {
        Refined one = refined(work, rough, options.blur_px, 3);
        if (one.sighting.clear > 0 &&
            (best.sighting.clear == 0 || one.sighting.foundShare() > best.sighting.foundShare()))
            best = std::move(one);
        share.add();
    }
    if (best.sighting.clear > 0)
        best = refined(work, best.X_RC, best.blur_px, 30);
    share.add();
    if (const auto error = reasonAgainst(work, best))
        return *error;
    if (const auto mirrored = mirroredPose(work, scene, best)) {
        Refined other = refined(work, *mirrored, best.blur_px, 30);
        const double apart_rad = displacementBetween(best.X_RC, other.X_RC).tail<3>().norm();
        if (!reasonAgainst(work, other) && apart_rad > radFromDeg(1.0)) {
            if (other.rms_px() < best.rms_px())
                std::swap(best, other);
            if (other.rms_px() < std::max(kAlike * best.rms_px(), kAlike_px))
                return Error{MessageCode::SilhouetteAmbiguous, "", {formatNumber(degFromRad(apart_rad), 2)}};
        }
    }

    share.add();

    SilhouettePose out;
    out.foundShare = best.sighting.foundShare();
    leaveOutFar(best.sighting, best.scatter_px);
    out.points.assign(views.size(), std::vector<int>(scene.objects.size(), 0));
    for (const UsedEdge& used : best.sighting.edges)
        ++out.points[used.view][used.edge.object];
    std::size_t usedViews = 0;
    for (std::size_t v = 0; v < views.size(); ++v) {
        int sum = 0;
        for (const int points : out.points[v])
            sum += points;
        usedViews += sum >= kMinPointsOfView ? 1 : 0;
        if (sum >= kMinPointsOfView)
            continue;
        std::erase_if(best.sighting.edges, [&](const UsedEdge& used) { return used.view == v; });
        std::ranges::fill(out.points[v], 0);
        out.remarks.push_back(
            {MessageCode::SilhouetteViewLeftOut,
             {std::to_string(v + 1), std::to_string(sum), std::to_string(kMinPointsOfView)}});
    }
    if (usedViews < options.minViews)
        return fewViews(usedViews);
    // Once more without what was left out and without a robust loss, which the covariance is for.
    constexpr double kNotRobust = 1e3;
    if (const auto fitted =
            fitContours(sightsOf(work, best.sighting, best.scatter_px), camera, best.X_RC, kNotRobust)) {
        best.X_RC = *fitted;
        setMisses(work, best.sighting, best.X_RC);
    }
    out.rms_px = best.rms_px();
    out.blur_px = best.blur_px;
    setCovariance(work, best, out);
    if (!out.covariance.allFinite() || !out.X_RC.matrix().allFinite())
        return Error{MessageCode::SilhouetteContradicts, "", {formatNumber(100.0 * out.foundShare, 2)}};
    setSpread(work, scene, out);
    setRemarks(work, scene, out);
    return out;
}

Judgement judged(const SilhouettePose& pose) {
    Judgement out;
    out.verdict = verdictOn(pose.atObjects);
    out.reason = {out.verdict == Verdict::Good ? MessageCode::SilhouetteGood
                                               : MessageCode::SilhouetteUncertain,
                  {formatNumber(1e3 * pose.atObjects.position_m, 2), formatNumber(1e3 * pose.across_m, 2)}};
    return out;
}

} // namespace bask
