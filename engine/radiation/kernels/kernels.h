#pragma once
// The inner loops of the view factor: sums over the points of an outline, made for three kinds of processor
// and chosen once at start.

namespace bask::kernels {

inline constexpr int kPadding = 8; ///< outlines have a multiple of so many points, with zero steps at the end

/// Points of an outline in O (m) with the weighted steps along it, as separate arrays of `count`, a multiple
/// of kPadding.
struct Outline {
    const double* x = nullptr;
    const double* y = nullptr;
    const double* dx = nullptr;
    const double* dy = nullptr;
    int count = 0;
};

/// The whole disk seen from O: o = O's origin less the disk's centre, k = the disk's normal, both in O axes.
struct WholeDisk {
    double radius2 = 0.0;
    double o[3] = {};
    double k[3] = {};
};

/// The segment of a disk that the object's plane leaves, in axes e1 (in the source plane, towards the
/// kept side), e2 (along the chord), e3 (the disk's normal): arc |theta| < beta and the chord. Lengths in
/// radii.
struct Segment {
    double inverseRadius = 1.0;
    double turn[3][2] = {}; ///< O's x and y axes
    double origin[3] = {};  ///< O's origin, radii
    double sinTilt = 0.0, normal3 = 0.0;
    double beta = 0.0, sinBeta = 0.0, cosBeta = 0.0;
};

/// Straight edge of a source contour from a in the direction t, in S.
struct Edge {
    double a1 = 0.0, a2 = 0.0, t1 = 0.0, t2 = 0.0, length = 0.0;
    bool operator==(const Edge&) const = default;
};

/// A closed source contour in S, S's z being the source's normal: nodes of its smooth parts, straight edges,
/// and edges on the line where the two planes meet.
struct Loop {
    Outline nodes;
    const Edge* edges = nullptr;
    int edgeCount = 0;
    const Edge* cutEdges = nullptr;
    int cutEdgeCount = 0;
};

/// O in S: the x and y axes of O and its origin (m).
struct Placement {
    double axes[3][2] = {};
    double origin[3] = {};
};

/// G.dp, and force and torque about O's origin; units and axes as the terms of each kind of source say.
struct Sums {
    double value = 0.0;
    double moments[6] = {};
};

/// One processor's set. "Value" leaves the moments out. `onCut`: all points lie on the line where the two
/// planes meet, and the field of what lies on that line is left to the caller.
struct Kernels {
    const char* name;
    double (*diskValue)(const WholeDisk&, const Outline&);
    Sums (*diskSums)(const WholeDisk&, const Outline&);
    double (*segmentValue)(const Segment&, const Outline&);
    Sums (*segmentSums)(const Segment&, const Outline&, bool onCut);
    double (*loopValue)(const Loop&, const Placement&, const Outline&);
    Sums (*loopSums)(const Loop&, const Placement&, const Outline&, bool onCut);
};

extern const Kernels kBaselineKernels; ///< any processor of the platform
#if defined(__x86_64__)
extern const Kernels kAvx2Kernels;   ///< AVX2 and FMA
extern const Kernels kAvx512Kernels; ///< AVX-512 F, DQ, VL, BW
#endif

/// Those that this processor can run, simplest first.
struct KernelList {
    const Kernels* sets[3] = {};
    int count = 0;
};
KernelList runnableKernels();

/// The set in use: the last of runnableKernels() unless another was chosen.
const Kernels& kernels();
/// For tests and measurements; not to be called while another thread computes.
void useKernels(const Kernels& set);

} // namespace bask::kernels
