#pragma once
// The loops over an outline. The file of each processor includes this once and defines BASK_KERNEL_WIDTH
// (bytes of a vector).

#include "engine/radiation/kernels/terms.h"

namespace bask::kernels {
namespace {

BASK_INLINE Sums sumsOf(const Term& term) {
    return {laneSum(term.value),
            {laneSum(term.f1), laneSum(term.f2), laneSum(term.f3), laneSum(term.t1), laneSum(term.t2),
             laneSum(term.t3)}};
}

template <bool kMoments>
BASK_INLINE Term diskTerm(double radius2, const double (&o)[3], const double (&k)[3],
                          const Outline& outline) {
    Term term;
    for (int i = 0; i < outline.count; i += kLanes)
        addWholeDisk<kMoments>(radius2, o, k, load(outline.x + i), load(outline.y + i), load(outline.dx + i),
                               load(outline.dy + i), term);
    return term;
}

double wholeDiskValue(double radius2, double o1, double o2, double o3, double k1, double k2, double k3,
                      const Outline& outline) {
    return laneSum(diskTerm<false>(radius2, {o1, o2, o3}, {k1, k2, k3}, outline).value);
}

Sums wholeDiskSums(double radius2, double o1, double o2, double o3, double k1, double k2, double k3,
                   const Outline& outline) {
    return sumsOf(diskTerm<true>(radius2, {o1, o2, o3}, {k1, k2, k3}, outline));
}

/// The sums of the poses from number `from` on.
template <bool kMoments>
Term poseTerm(double radius2, const DiskPoses& poses, int from, const Outline& outline) {
    const Lanes o[3] = {load(poses.o[0] + from), load(poses.o[1] + from), load(poses.o[2] + from)};
    const Lanes k[3] = {load(poses.k[0] + from), load(poses.k[1] + from), load(poses.k[2] + from)};
    Term term;
    for (int i = 0; i < outline.count; ++i)
        addWholeDisk<kMoments>(radius2, o, k, outline.x[i], outline.y[i], outline.dx[i], outline.dy[i], term);
    return term;
}

void diskPoseValues(double radius2, const DiskPoses& poses, const Outline& outline, double* values) {
    for (int from = 0; from < kPoses; from += kLanes)
        store(values + from, poseTerm<false>(radius2, poses, from, outline).value);
}

void diskPoseSums(double radius2, const DiskPoses& poses, const Outline& outline, double (*sums)[kPoses]) {
    for (int from = 0; from < kPoses; from += kLanes) {
        const Term term = poseTerm<true>(radius2, poses, from, outline);
        const Lanes all[7] = {term.value, term.f1, term.f2, term.f3, term.t1, term.t2, term.t3};
        for (int row = 0; row < 7; ++row)
            store(sums[row] + from, all[row]);
    }
}

double parallelDiskStrips(double radius, double objectRadius, double least, const double* xs,
                          const double* ys, const double* zs, double* aways) {
    Lanes narrowest = Lanes{} + 1e300;
    for (int from = 0; from < kPoses; from += kLanes) {
        const Lanes x = load(xs + from), y = load(ys + from), z = load(zs + from);
        const Lanes away2 = x * x + y * y;
        store(aways + from, laneSqrt(away2));
        const Lanes twice2 = (4.0 * objectRadius * objectRadius) * away2; // (2 m)^2
        const Lanes real = away2 + z * z + (objectRadius * objectRadius - radius * radius);
        const Lanes imag = (2.0 * radius) * z;
        const Lanes root1 = laneAbs(real * real - imag * imag - twice2);
        const Lanes root2 = laneAbs(2.0 * real * imag);
        const Lanes root = laneMax(laneMax(root1, root2), 0.7071 * (root1 + root2));
        const Lanes cosh = (real * real + imag * imag + root) / (twice2 + 1e-300);
        narrowest = select((z > least) & (cosh < narrowest), cosh, narrowest);
    }
    return laneMin(narrowest);
}

/// The closed form of addWholeDisk where the planes are parallel: the outline is the same on both sides of
/// the line of centres, so that half of it will do. An even number of cosines; `sums` has one row, or four
/// with kMoments.
template <bool kMoments>
void addParallelDisks(double radius2, double objectRadius, const double* aways, const double* heights,
                      const double* cosines, int count, double (*sums)[kPoses]) {
    for (int from = 0; from < kPoses; from += kLanes) {
        const Lanes away = load(aways + from);
        const Lanes height = load(heights + from);
        const Lanes z2 = height * height;
        const Lanes middle = away * away + objectRadius * objectRadius + z2;
        const Lanes swing = (2.0 * objectRadius) * away;
        const Lanes rim = (4.0 * radius2) * z2 + 1e-300;
        const auto rootAt = [&](Lanes square) {
            const Lanes t = square - radius2;
            return laneSqrt(t * t + rim);
        };
        Lanes value{}, along{}, normal{}, across{};
        if constexpr (!kMoments) {
            for (int i = 0; i < count; i += 2) { // two steps share a division
                const Lanes square1 = middle + swing * cosines[i], square2 = middle + swing * cosines[i + 1];
                const Lanes sum1 = square1 + radius2 + rootAt(square1);
                const Lanes sum2 = square2 + radius2 + rootAt(square2);
                const Lanes step1 = objectRadius + away * cosines[i];
                const Lanes step2 = objectRadius + away * cosines[i + 1];
                value += (step1 * sum2 + step2 * sum1) / (sum1 * sum2);
            }
        } else {
            for (int i = 0; i < count; ++i) {
                const Lanes square = middle + swing * cosines[i];
                const Lanes t = square - radius2;
                const Lanes s = rootAt(square);
                const Lanes a = square + radius2;
                const Lanes step = objectRadius + away * cosines[i];
                const Lanes both = 1.0 / (s * (a + s));
                const Lanes u = s * both;
                const Lanes v = (a + s) * both;
                const Lanes gz = -2.0 * height * both;
                const Lanes h = 2.0 * u * (1.0 - (square - z2) * (s + t) * both - z2 * v);
                const Lanes lift = gz * step;
                value += step * u;
                along += cosines[i] * (h - gz * height);
                normal += lift;
                across -= (objectRadius * cosines[i]) * lift;
            }
        }
        store(sums[0] + from, value);
        if constexpr (kMoments) {
            store(sums[1] + from, along);
            store(sums[2] + from, normal);
            store(sums[3] + from, across);
        }
    }
}

double segmentValue(const Segment& segment, const Outline& outline) {
    Term term;
    for (int i = 0; i < outline.count; i += kLanes)
        addSegment<false>(segment, load(outline.x + i), load(outline.y + i), load(outline.dx + i),
                          load(outline.dy + i), term, false);
    return laneSum(term.value);
}

Sums segmentSums(const Segment& segment, const Outline& outline, bool onCut) {
    Term term;
    for (int i = 0; i < outline.count; i += kLanes)
        addSegment<true>(segment, load(outline.x + i), load(outline.y + i), load(outline.dx + i),
                         load(outline.dy + i), term, onCut);
    return sumsOf(term);
}

template <bool kMoments>
void addLoop(const Loop& loop, const Placement& at, const Outline& outline, int i, bool onCut, Term& term) {
    const Lanes x = load(outline.x + i);
    const Lanes y = load(outline.y + i);
    const Lanes dx = load(outline.dx + i);
    const Lanes dy = load(outline.dy + i);
    const Lanes l1 = at.axes[0][0] * x + at.axes[0][1] * y;
    const Lanes l2 = at.axes[1][0] * x + at.axes[1][1] * y;
    const Lanes l3 = at.axes[2][0] * x + at.axes[2][1] * y;
    const Lanes p1 = at.origin[0] + l1;
    const Lanes p2 = at.origin[1] + l2;
    const Lanes z = at.origin[2] + l3;
    const Lanes z2 = z * z + 1e-300;
    NodeSums sum;
    const Outline& nodes = loop.nodes;
    for (int k = 0; k < nodes.count; ++k)
        addNode<kMoments>(p1, p2, z2, nodes.x[k], nodes.y[k], nodes.dx[k], nodes.dy[k], sum);
    Lanes b1 = -z * sum.across2;
    Lanes b2 = z * sum.across1;
    for (int k = 0; k < loop.edgeCount; ++k)
        addEdge<kMoments>(loop.edges[k], p1, p2, z, sum.g1, sum.g2, b1, b2, sum.b3, false);
    for (int k = 0; k < loop.cutEdgeCount; ++k)
        addEdge<kMoments>(loop.cutEdges[k], p1, p2, z, sum.g1, sum.g2, b1, b2, sum.b3, onCut);
    const Lanes d1 = at.axes[0][0] * dx + at.axes[0][1] * dy;
    const Lanes d2 = at.axes[1][0] * dx + at.axes[1][1] * dy;
    term.value += sum.g1 * d1 + sum.g2 * d2;
    if constexpr (kMoments) {
        const Lanes d3 = at.axes[2][0] * dx + at.axes[2][1] * dy;
        addMoments(term, l1, l2, l3, d1, d2, d3, b1, b2, sum.b3);
    }
}

double loopValue(const Loop& loop, const Placement& at, const Outline& outline) {
    Term term;
    for (int i = 0; i < outline.count; i += kLanes)
        addLoop<false>(loop, at, outline, i, false, term);
    return laneSum(term.value);
}

Sums loopSums(const Loop& loop, const Placement& at, const Outline& outline, bool onCut) {
    Term term;
    for (int i = 0; i < outline.count; i += kLanes)
        addLoop<true>(loop, at, outline, i, onCut, term);
    return sumsOf(term);
}

void seriesPoints(const Series& series, const double* cosines, const double* sines, int count,
                  SeriesPoints& points) {
    for (int i = 0; i < count; i += kLanes) {
        const SeriesSums sum = seriesSums(series, load(cosines + i), load(sines + i));
        store(points.x + i, sum.x);
        store(points.y + i, sum.y);
        store(points.dx + i, sum.dx);
        store(points.dy + i, sum.dy);
    }
}

void straightFields(double* const* rows, int count) {
    for (int i = 0; i < count; i += kLanes)
        straightField(rows, i);
}

void arcFields(double* const* rows, int count) {
    for (int i = 0; i < count; i += kLanes)
        arcField(rows, i);
}

constexpr Kernels kernelsNamed(const char* name) {
    return {name,
            wholeDiskValue,
            wholeDiskSums,
            diskPoseValues,
            diskPoseSums,
            parallelDiskStrips,
            addParallelDisks<false>,
            addParallelDisks<true>,
            segmentValue,
            segmentSums,
            loopValue,
            loopSums,
            seriesPoints,
            straightFields,
            arcFields};
}

} // namespace
} // namespace bask::kernels
