#pragma once
// The baseline of one view factor, disk over disk: the field of a whole disk
// (engine/radiation/kernels/terms.h) summed at 32 points of the object's outline, whatever the error. Nothing
// is chosen or checked, and nothing of Bask is called.

namespace bask {

/// F and, where it is asked for, its derivatives by translation and rotation, in O axes (1/m, 1/rad).
struct FixedDisk {
    double value = 0.0;
    double gradient[6] = {};
};

/// An object of radius r (m) over a source of radius R (m): o = O's origin less the source's centre, k = the
/// source's normal, both in O axes. Compiled for the newest of AVX-512, AVX2 and the platform's baseline that
/// this processor runs.
double fixedDiskValue(double R, double r, const double (&o)[3], const double (&k)[3]);
FixedDisk fixedDiskGradient(double R, double r, const double (&o)[3], const double (&k)[3]);

} // namespace bask
