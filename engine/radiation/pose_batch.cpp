#include "engine/radiation/pose_batch.h"

#include "engine/radiation/disk_strip.h"
#include "engine/radiation/outline_table.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace bask {
namespace {

constexpr double kBatchSafety = 2.0 * kRuleSafety; // object and source share the error

/// Fewer poses are as fast one by one.
bool areFewerThanThree(unsigned bits) {
    const unsigned butOne = bits & (bits - 1);
    return (butOne & (butOne - 1)) == 0;
}

/// Of a rule for parallel disks that are not near the source's outline: to that F is exact whatever the
/// tolerance, at the price of hardly more points.
constexpr double kParallelError = 1e-12;
constexpr int kParallelStep = 4, kMaxParallelPoints = 128; // half of the points are an even number

/// Cosines of half a circle's points, (k + 1/2) 2 pi / n: the other half has the same. One rule after
/// another, the one of n points from n (n - kParallelStep) / (4 kParallelStep) on.
const double* cosinesOf(int points) {
    static const auto kCosines = [] {
        std::vector<double> made;
        for (int n = kParallelStep; n <= kMaxParallelPoints; n += kParallelStep)
            for (int k = 0; k < n / 2; ++k)
                made.push_back(std::cos((2 * k + 1) * std::numbers::pi / n));
        return made;
    }();
    return &kCosines[static_cast<std::size_t>(points * (points - kParallelStep) / (4 * kParallelStep))];
}

} // namespace

PoseBatch::PoseBatch(const RadiatingContour& source, const RadiatingContour& object, double tolerance)
    : m_source(source), m_object(object), m_radius(m_source.impl().disk->radius_m) {
    const double perimeters = m_source.impl().perimeter * m_object.impl().perimeter;
    const double perCirculation = 1.0 / (2.0 * std::numbers::pi * m_object.area_m2());
    m_floor = 32.0 * std::numeric_limits<double>::epsilon() * perimeters * perCirculation;
    m_bound = kBatchSafety * perimeters * perCirculation;
    m_allowed = std::max(kRuleShare * tolerance, m_floor);
    m_exponent = std::log(m_bound / m_allowed);
}

std::optional<PoseBatch> PoseBatch::of(const RadiatingSource& source, const RadiatingContour& object,
                                       double tolerance) {
    const SourceTerm& only = source.terms().front();
    if (!source.isEven() || !only.X_SP.matrix().isIdentity(0.0) || only.contour.impl().disk == nullptr ||
        !only.contour.impl().holes.empty() || object.impl().isPolygon || !object.impl().holes.empty() ||
        !(tolerance > 0.0))
        return std::nullopt;
    return PoseBatch(only.contour, object, tolerance);
}

double PoseBatch::leastHeight_m() const {
    return kInFront * (m_radius + m_object.impl().reach);
}

Pose PoseBatch::Poses::pose(std::size_t k) const {
    Pose X = Pose::Identity();
    const std::size_t turn = isOneRotation ? 0 : k;
    for (int i = 0; i < 3; ++i) {
        X.translation()[i] = p[i][k];
        for (int j = 0; j < 3; ++j)
            X.linear()(i, j) = R[i][j][turn];
    }
    return X;
}

void PoseBatch::Poses::copyRotation(std::size_t from, std::size_t to) {
    for (auto& row : R)
        for (auto& entry : row)
            entry[to] = entry[from];
}

void PoseBatch::Poses::copy(std::size_t from, std::size_t to) {
    for (auto& row : p)
        row[to] = row[from];
    if (!isOneRotation)
        copyRotation(from, to);
}

/// Returns the poses at which both faces are wholly in front of the other's plane, as bits, and writes how
/// high the object's lowest point is over the source's plane (m).
unsigned PoseBatch::seen(const Poses& poses, double (&overSource)[kPoses]) const {
    const double reach = m_object.impl().reach;
    const double least = leastHeight_m();
    double overObject[kPoses]; // lowest point of the source over the object's plane
    const double(&x)[kPoses] = poses.p[0];
    const double(&y)[kPoses] = poses.p[1];
    const double(&z)[kPoses] = poses.p[2];
    const auto R = [&](int i, int j, int turn) { return poses.R[i][j][turn]; };
    const auto below = [&](int turn) { // of the source's and the object's centre
        return std::pair(m_radius * std::sqrt(R(0, 2, turn) * R(0, 2, turn) + R(1, 2, turn) * R(1, 2, turn)),
                         reach * std::sqrt(R(2, 0, turn) * R(2, 0, turn) + R(2, 1, turn) * R(2, 1, turn)));
    };
    const auto heights = [&](int k, int turn, const std::pair<double, double>& low) {
        overObject[k] = R(0, 2, turn) * x[k] + R(1, 2, turn) * y[k] + R(2, 2, turn) * z[k] - low.first;
        overSource[k] = z[k] - low.second;
    };
    if (poses.isOneRotation) {
        const auto low = below(0);
        for (int k = 0; k < kPoses; ++k)
            heights(k, 0, low);
    } else {
        for (int k = 0; k < kPoses; ++k)
            heights(k, k, below(k));
    }
    unsigned bits = 0;
    for (int k = 0; k < kPoses; ++k) { // comparisons that numbers which are not finite do not pass
        const bool isSeen = overObject[k] > least && overSource[k] > least &&
                            x[k] * x[k] + y[k] * y[k] + z[k] * z[k] < kFarthestStrip_m * kFarthestStrip_m;
        bits |= static_cast<unsigned>(isSeen) << k;
    }
    return bits;
}

void PoseBatch::compute(const Poses& poses, int count, bool withGradient, Factors& factors) const {
    double overSource[kPoses];
    const unsigned bits = seen(poses, overSource) & ((1U << count) - 1U);
    factors.computed = 0;
    if (areFewerThanThree(bits))
        return;
    const bool isParallel = poses.isOneRotation && poses.R[0][2][0] == 0.0 && poses.R[1][2][0] == 0.0;
    if (!isParallel || m_object.impl().disk == nullptr || !parallel(poses, withGradient, factors)) {
        double away[kPoses], lowest[kPoses]; // from the source's outline, all at once
        for (int k = 0; k < kPoses; ++k) {
            const double x = poses.p[0][k], y = poses.p[1][k], z = poses.p[2][k];
            const double aside = std::sqrt(x * x + y * y) - m_radius;
            away[k] = std::sqrt(aside * aside + z * z);
            lowest[k] = std::max(away[k] - m_object.impl().reach, overSource[k]);
        }
        double fromOutline = INFINITY, nearest = INFINITY;
        for (int k = 0; k < kPoses; ++k)
            if ((bits >> k & 1U) != 0U) {
                fromOutline = std::min(fromOutline, away[k]);
                nearest = std::min(nearest, lowest[k]);
            }
        const auto [rule, exponent] = m_object.impl().foreseen(fromOutline, nearest, m_exponent);
        if (!rule)
            return;
        factors.error = std::min(m_floor + m_bound * std::exp(-exponent), 1.0);
        kernels::Outline points = rule->table.view();
        points.count = rule->points; // without those that fill it up
        tilted(poses, points, withGradient, factors);
    }
    factors.computed = bits;
}

/// Returns false where that would take too many points.
bool PoseBatch::parallel(const Poses& poses, bool withGradient, Factors& factors) const {
    const double radius = m_object.impl().disk->radius_m;
    const kernels::Kernels& kernel = kernels::kernels();
    const double(&z)[kPoses] = poses.p[2];
    double fromAxis[kPoses];
    const double narrowest =
        kernel.parallelDiskStrips(m_radius, radius, leastHeight_m(), poses.p[0], poses.p[1], z, fromAxis);
    const double exact = std::max(std::min(m_allowed, kParallelError), m_floor);
    DiskRule<kParallelStep> rule(wideStripExp(narrowest), m_bound, exact, kMaxParallelPoints);
    if (rule.points > kMaxParallelPoints) // near the source's outline
        rule = {stripExp(narrowest), m_bound, m_allowed, kMaxParallelPoints};
    if (rule.points > kMaxParallelPoints)
        return false;
    factors.error = std::min(m_floor + m_bound / rule.gain, 1.0);
    const double perSum = 4.0 * m_radius * m_radius / (radius * rule.points);
    double sums[4][kPoses];
    (withGradient ? kernel.parallelDiskSums : kernel.parallelDiskValues)(
        m_radius * m_radius, radius, fromAxis, z, cosinesOf(rule.points), rule.points / 2, sums);
    for (int k = 0; k < kPoses; ++k)
        factors.values[k] = std::clamp(perSum * sums[0][k], 0.0, 1.0) + 0.0;
    if (!withGradient)
        return true;
    for (int k = 0; k < kPoses; ++k) {
        const double away = fromAxis[k];
        const double c = away > 0.0 ? poses.p[0][k] / away : 1.0, s = away > 0.0 ? poses.p[1][k] / away : 0.0;
        factors.gradients[0][k] = perSum * c * sums[1][k];
        factors.gradients[1][k] = perSum * s * sums[1][k];
        factors.gradients[2][k] = perSum * sums[2][k];
        factors.gradients[3][k] = -perSum * s * sums[3][k];
        factors.gradients[4][k] = perSum * c * sums[3][k];
        factors.gradients[5][k] = 0.0;
    }
    return true;
}

void PoseBatch::tilted(const Poses& poses, const kernels::Outline& points, bool withGradient,
                       Factors& factors) const {
    kernels::DiskPoses disk;
    const auto R = [&](int i, int j, int k) { return poses.R[i][j][poses.isOneRotation ? 0 : k]; };
    for (int j = 0; j < 3; ++j)
        for (int k = 0; k < kPoses; ++k) {
            disk.o[j][k] =
                R(0, j, k) * poses.p[0][k] + R(1, j, k) * poses.p[1][k] + R(2, j, k) * poses.p[2][k];
            disk.k[j][k] = R(2, j, k);
        }
    // Circulation = -2 pi R2 sum; F = -circulation / (2 pi A).
    const double perSum = m_radius * m_radius / m_object.area_m2();
    double sums[7][kPoses];
    if (withGradient)
        kernels::kernels().diskPoseSums(m_radius * m_radius, disk, points, sums);
    else
        kernels::kernels().diskPoseValues(m_radius * m_radius, disk, points, sums[0]);
    for (int k = 0; k < kPoses; ++k)
        factors.values[k] = std::clamp(perSum * sums[0][k], 0.0, 1.0) + 0.0;
    if (!withGradient)
        return;
    for (int i = 0; i < 3; ++i) // from O axes to S axes
        for (int k = 0; k < kPoses; ++k) {
            factors.gradients[i][k] =
                perSum * (R(i, 0, k) * sums[1][k] + R(i, 1, k) * sums[2][k] + R(i, 2, k) * sums[3][k]);
            factors.gradients[3 + i][k] =
                perSum * (R(i, 0, k) * sums[4][k] + R(i, 1, k) * sums[5][k] + R(i, 2, k) * sums[6][k]);
        }
}

} // namespace bask
