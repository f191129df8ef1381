#include "engine/radiation/pose_batch.h"

#include "engine/radiation/outline_table.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

namespace bask {
namespace {

constexpr double kBatchSafety = 2.0 * kRuleSafety; // object and source share the error
constexpr int kWorthIt = 3;                        // poses; fewer are as fast one by one

/// Cosines of half a circle's points, (k + 1/2) 2 pi / n: the other half has the same.
template <int kPoints> std::array<double, kPoints / 2> halfCircle() {
    std::array<double, kPoints / 2> cosines;
    for (int k = 0; k < kPoints / 2; ++k)
        cosines[static_cast<std::size_t>(k)] = std::cos((2 * k + 1) * std::numbers::pi / kPoints);
    return cosines;
}

std::span<const double> cosinesOf(int points) {
    static const auto k8 = halfCircle<8>();
    static const auto k16 = halfCircle<16>();
    static const auto k24 = halfCircle<24>();
    static const auto k32 = halfCircle<32>();
    static const auto k48 = halfCircle<48>();
    static const auto k64 = halfCircle<64>();
    switch (points) {
    case 8:
        return k8;
    case 16:
        return k16;
    case 24:
        return k24;
    case 32:
        return k32;
    case 48:
        return k48;
    case 64:
        return k64;
    default:
        return {};
    }
}

} // namespace

PoseBatch::PoseBatch(const RadiatingContour& source, const RadiatingContour& object, double tolerance)
    : m_source(source), m_object(object), m_radius(m_source.impl().disk->radius_m) {
    const double perimeters = m_source.impl().perimeter * m_object.impl().perimeter;
    const double perCirculation = 1.0 / (2.0 * std::numbers::pi * m_object.area_m2());
    m_floor = 32.0 * std::numeric_limits<double>::epsilon() * perimeters * perCirculation;
    m_bound = kBatchSafety * perimeters * perCirculation;
    m_exponent = std::log(m_bound / std::max(kRuleShare * tolerance, m_floor));
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

/// Of the object's centre from the source's axis and outline, and of its outline from the source's (m).
struct PoseBatch::Distances {
    double fromAxis[kPoses], fromOutline[kPoses], nearest[kPoses];
};

/// Returns the poses at which both faces are wholly in front of the other's plane, as bits.
unsigned PoseBatch::seen(const Poses& poses, Distances& distances) const {
    const double reach = m_object.impl().reach;
    const double least = kInFront * (m_radius + reach);
    double overObject[kPoses], overSource[kPoses]; // lowest point of the one face over the other's plane
    const double(&x)[kPoses] = poses.p[0];
    const double(&y)[kPoses] = poses.p[1];
    const double(&z)[kPoses] = poses.p[2];
    const auto heights = [&](int k, int turn) {
        const auto R = [&](int i, int j) { return poses.R[i][j][turn]; };
        const double sourceSlope = std::sqrt(R(0, 2) * R(0, 2) + R(1, 2) * R(1, 2));
        const double slope = std::sqrt(R(2, 0) * R(2, 0) + R(2, 1) * R(2, 1));
        overObject[k] = R(0, 2) * x[k] + R(1, 2) * y[k] + R(2, 2) * z[k] - m_radius * sourceSlope;
        overSource[k] = z[k] - reach * slope;
    };
    if (poses.isOneRotation)
        for (int k = 0; k < kPoses; ++k)
            heights(k, 0);
    else
        for (int k = 0; k < kPoses; ++k)
            heights(k, k);
    for (int k = 0; k < kPoses; ++k) {
        distances.fromAxis[k] = std::sqrt(x[k] * x[k] + y[k] * y[k]);
        const double aside = distances.fromAxis[k] - m_radius;
        distances.fromOutline[k] = std::sqrt(aside * aside + z[k] * z[k]);
        distances.nearest[k] = std::max(distances.fromOutline[k] - reach, overSource[k]);
    }
    unsigned bits = 0;
    for (int k = 0; k < kPoses; ++k) { // comparisons that numbers which are not finite do not pass
        const bool isSeen = overObject[k] > least && overSource[k] > least && distances.fromOutline[k] < 1e50;
        bits |= static_cast<unsigned>(isSeen) << k;
    }
    return bits;
}

void PoseBatch::compute(const Poses& poses, int count, bool withGradient, Factors& factors) const {
    Distances distances;
    const unsigned bits = seen(poses, distances) & ((1U << count) - 1U);
    double fromOutline = INFINITY, nearest = INFINITY;
    for (int k = 0; k < kPoses; ++k)
        if ((bits >> k & 1U) != 0U) {
            fromOutline = std::min(fromOutline, distances.fromOutline[k]);
            nearest = std::min(nearest, distances.nearest[k]);
        }
    const auto [rule, exponent] = std::popcount(bits) >= kWorthIt
                                      ? m_object.impl().foreseen(fromOutline, nearest, m_exponent)
                                      : ForeseenRule();
    factors.computed = rule ? bits : 0;
    if (!rule)
        return;
    factors.error = std::min(m_floor + m_bound * std::exp(-exponent), 1.0);
    const bool isParallel = poses.isOneRotation && poses.R[0][2][0] == 0.0 && poses.R[1][2][0] == 0.0;
    if (isParallel && m_object.impl().disk != nullptr && !cosinesOf(rule->points).empty()) {
        parallel(poses, distances, rule->points, withGradient, factors);
    } else {
        kernels::Outline points = rule->table.view();
        points.count = rule->points; // without those that fill it up
        tilted(poses, points, withGradient, factors);
    }
    for (double& value : factors.values)
        value = std::clamp(value, 0.0, 1.0) + 0.0;
}

void PoseBatch::parallel(const Poses& poses, const Distances& distances, int points, bool withGradient,
                         Factors& factors) const {
    const double radius = m_object.impl().disk->radius_m;
    const double perSum = 4.0 * m_radius * m_radius / (radius * points);
    const std::span<const double> cosines = cosinesOf(points);
    const auto count = static_cast<int>(cosines.size());
    const kernels::Kernels& kernel = kernels::kernels();
    double sums[4][kPoses];
    (withGradient ? kernel.parallelDiskSums : kernel.parallelDiskValues)(
        m_radius * m_radius, radius, distances.fromAxis, poses.p[2], cosines.data(), count, sums);
    for (int k = 0; k < kPoses; ++k)
        factors.values[k] = perSum * sums[0][k];
    if (!withGradient)
        return;
    for (int k = 0; k < kPoses; ++k) {
        const double away = distances.fromAxis[k];
        const double c = away > 0.0 ? poses.p[0][k] / away : 1.0, s = away > 0.0 ? poses.p[1][k] / away : 0.0;
        factors.gradients[0][k] = perSum * c * sums[1][k];
        factors.gradients[1][k] = perSum * s * sums[1][k];
        factors.gradients[2][k] = perSum * sums[2][k];
        factors.gradients[3][k] = -perSum * s * sums[3][k];
        factors.gradients[4][k] = perSum * c * sums[3][k];
        factors.gradients[5][k] = 0.0;
    }
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
        factors.values[k] = perSum * sums[0][k];
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
