#pragma once
// The inner loops of the view factor: sums over the points of an outline, compiled for three kinds of
// processor; one is selected at the start.

namespace bask::kernels {

/// The number of points of an outline is a multiple of this, with zero steps at the end.
inline constexpr int kPadding = 8;

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

/// The segment of a disk in front of the object's plane, in axes e1 (in the source plane, towards the visible
/// side), e2 (along the chord), e3 (the disk's normal): arc |theta| < beta and the chord. Lengths are in
/// radii.
struct Segment {
    double inverseRadius = 1.0;
    double turn[3][2] = {}; ///< O's x and y axes
    double origin[3] = {};  ///< O's origin, radii
    double sinTilt = 0.0, normal3 = 0.0;
    double beta = 0.0, sinBeta = 0.0, cosBeta = 0.0;
};

/// A straight edge of a source contour from a in the direction t, in S.
struct Edge {
    double a1 = 0.0, a2 = 0.0, t1 = 0.0, t2 = 0.0, length = 0.0;
    bool operator==(const Edge&) const = default;
};

/// A closed source contour in S, where z of S is the source's normal: nodes of its smooth parts, straight
/// edges, and edges on the line where the two planes meet.
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

/// G.dp, and force and torque about O's origin; units and axes depend on the kind of source, see its terms.
struct Sums {
    double value = 0.0;
    double moments[6] = {};
};

/// A smooth outline as a Fourier series, x + iy = sum c_j e^(i j phi): c_j (m) for j from -harmonics to
/// harmonics, real and imaginary part in turn.
struct Series {
    const double* coefficients = nullptr;
    int harmonics = 0;
};

/// The most points that a series is asked for at a time.
inline constexpr int kMaxSeriesPoints = 16;

/// Points of a series (m) and their derivatives by phi (m per rad).
struct SeriesPoints {
    double x[kMaxSeriesPoints], y[kMaxSeriesPoints], dx[kMaxSeriesPoints], dy[kMaxSeriesPoints];
};

/// Eight poses of an object under a whole disk, as separate arrays: o = O's origin less the disk's centre, k
/// = the disk's normal, both in O axes.
inline constexpr int kPoses = 8;
struct DiskPoses {
    double o[3][kPoses], k[3][kPoses];
};

/// The functions for one kind of processor. "Value" functions do not compute the moments. `onCut`: all points
/// are on the line where the two planes meet, and the caller adds the field of the source's parts on that
/// line.
struct Kernels {
    const char* name;
    /// Of a WholeDisk in registers: to read its numbers from where they were just written in pairs would take
    /// as long as the sum.
    double (*wholeDiskValue)(double radius2, double o1, double o2, double o3, double k1, double k2, double k3,
                             const Outline&);
    Sums (*wholeDiskSums)(double radius2, double o1, double o2, double o3, double k1, double k2, double k3,
                          const Outline&);
    /// The same for eight poses at once, whose points are those of one outline; sums[0] are values, then
    /// moments.
    void (*diskPoseValues)(double radius2, const DiskPoses&, const Outline&, double* values);
    void (*diskPoseSums)(double radius2, const DiskPoses&, const Outline&, double (*sums)[kPoses]);
    /// For eight disks parallel to the source's, at x, y and z (m) from its centre: writes their distances
    /// from its axis and returns the smallest stripCosh() (disk_strip.h) of those higher than `least`.
    double (*parallelDiskStrips)(double radius, double objectRadius, double least, const double* x,
                                 const double* y, const double* z, double* away);
    /// For eight disks parallel to the source's, whose centres are `away` from its axis and `height` from its
    /// plane (m): sums[0] are sums of (r + away * cosine) / (a + S) over points at the given cosines, r being
    /// their radius.
    void (*parallelDiskValues)(double radius2, double objectRadius, const double* away, const double* height,
                               const double* cosines, int count, double (*sums)[kPoses]);
    /// The same with its derivatives, in axes along the line of centres, across it and along the normal:
    /// sums[0] are values, then the forces along and normal, and the torque about the axis across; the others
    /// are zero.
    void (*parallelDiskSums)(double radius2, double objectRadius, const double* away, const double* height,
                             const double* cosines, int count, double (*sums)[kPoses]);
    double (*segmentValue)(const Segment&, const Outline&);
    Sums (*segmentSums)(const Segment&, const Outline&, bool onCut);
    double (*loopValue)(const Loop&, const Placement&, const Outline&);
    Sums (*loopSums)(const Loop&, const Placement&, const Outline&, bool onCut);
    /// The points at phi of the given cosines and sines; `count` is a multiple of kPadding.
    void (*seriesPoints)(const Series&, const double* cosines, const double* sines, int count, SeriesPoints&);
    /// Integrals of r x dr / |r|^2 along straight lines; rows: the three coordinates of r at one end, then at
    /// the other. The first three rows receive them. Rows have room for a multiple of kPadding.
    void (*straightFields)(double* const* rows, int count);
    /// The same along arcs of circles, each in the circle's frame; rows: its radius, the three coordinates of
    /// the point, the unit vectors from which to which it runs, and 1 if by more than half a turn, else 0.
    void (*arcFields)(double* const* rows, int count);

    double diskValue(const WholeDisk& d, const Outline& outline) const {
        return wholeDiskValue(d.radius2, d.o[0], d.o[1], d.o[2], d.k[0], d.k[1], d.k[2], outline);
    }
    Sums diskSums(const WholeDisk& d, const Outline& outline) const {
        return wholeDiskSums(d.radius2, d.o[0], d.o[1], d.o[2], d.k[0], d.k[1], d.k[2], outline);
    }
};

extern const Kernels kBaselineKernels; ///< any processor of the platform
#if defined(__x86_64__)
extern const Kernels kAvx2Kernels;   ///< AVX2 and FMA
extern const Kernels kAvx512Kernels; ///< AVX-512 F, DQ, VL, BW
#endif

/// The functions that this processor can run, simplest first.
struct KernelList {
    const Kernels* sets[3] = {};
    int count = 0;
};
KernelList runnableKernels();

/// Returns the functions in use: the last of runnableKernels(), unless another one was selected.
const Kernels& kernels();
/// Selects functions, for tests and measurements; do not call it while another thread computes.
void useKernels(const Kernels& set);

} // namespace bask::kernels
