#include "engine/radiation/disk_field.h"

#include <algorithm>

// The loops below run in the widest vectors that the machine has; the sanitizers cannot follow the choice at
// start-up.
#if defined(__x86_64__) && defined(__gnu_linux__) && defined(__GNUC__) && !defined(__clang__) &&             \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define BASK_CLONES __attribute__((target_clones("arch=haswell", "default")))
#else
#define BASK_CLONES
#endif

namespace bask {

namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

struct Term {
    double circulation = 0, f1 = 0, f2 = 0, f3 = 0, t1 = 0, t2 = 0, t3 = 0, s = 0;
};

BASK_CLONES void addValues(double r2, const double* o, const double* k, const double* x, const double* y,
                           const double* dx, const double* dy, int n, double* out) {
    const double o1 = o[0], o2 = o[1], o3 = o[2], k1 = k[0], k2 = k[1], k3 = k[2];
    double circulation = 0.0;
    double least = 1e300;
#pragma omp simd reduction(+ : circulation) reduction(min : least)
    for (int i = 0; i < n; ++i) {
        Term term;
        wholeDiskTerm<false>(r2, o1, o2, o3, k1, k2, k3, x[i], y[i], dx[i], dy[i], term);
        circulation += term.circulation;
        least = term.s < least ? term.s : least;
    }
    out[0] = circulation;
    out[7] = least;
}

BASK_CLONES void addSums(double r2, const double* o, const double* k, const double* x, const double* y,
                         const double* dx, const double* dy, int n, double* out) {
    const double o1 = o[0], o2 = o[1], o3 = o[2], k1 = k[0], k2 = k[1], k3 = k[2];
    double c = 0.0, f1 = 0.0, f2 = 0.0, f3 = 0.0, t1 = 0.0, t2 = 0.0, t3 = 0.0;
    double least = 1e300;
#pragma omp simd reduction(+ : c, f1, f2, f3, t1, t2, t3) reduction(min : least)
    for (int i = 0; i < n; ++i) {
        Term term;
        wholeDiskTerm<true>(r2, o1, o2, o3, k1, k2, k3, x[i], y[i], dx[i], dy[i], term);
        c += term.circulation;
        f1 += term.f1;
        f2 += term.f2;
        f3 += term.f3;
        t1 += term.t1;
        t2 += term.t2;
        t3 += term.t3;
        least = term.s < least ? term.s : least;
    }
    const double sums[8] = {c, f1, f2, f3, t1, t2, t3, least};
    std::copy(sums, sums + 8, out);
}

// The product of the distances to the near and the far rim is s; the far one is at most |p| + r.
double rimDistance(const WholeDisk& disk, double leastProduct) {
    const double reach = disk.o.norm() + disk.radius;
    return leastProduct / (reach + std::sqrt(leastProduct) + disk.radius);
}

LoopSums scaled(const WholeDisk& disk, const double* sums) {
    const double factor = -kTwoPi * disk.radius * disk.radius;
    LoopSums result;
    result.circulation = factor * sums[0];
    for (std::size_t i = 0; i < 6; ++i)
        result.moments[i] = factor * sums[i + 1];
    result.distance_m = rimDistance(disk, sums[7]);
    return result;
}

} // namespace

LoopSums WholeDisk::at(const OutlinePoint& point) const {
    Term term;
    wholeDiskTerm<true>(radius * radius, o[0], o[1], o[2], k[0], k[1], k[2], point.x, point.y, point.dx,
                        point.dy, term);
    const double sums[8] = {term.circulation, term.f1, term.f2, term.f3, term.t1, term.t2, term.t3, term.s};
    return scaled(*this, sums);
}

LoopSums wholeDiskValue(const WholeDisk& disk, const OutlinePoints& points) {
    double sums[8] = {};
    addValues(disk.radius * disk.radius, disk.o.data(), disk.k.data(), points.x, points.y, points.dx,
              points.dy, points.count, sums);
    return scaled(disk, sums);
}

LoopSums wholeDiskSums(const WholeDisk& disk, const OutlinePoints& points) {
    double sums[8];
    addSums(disk.radius * disk.radius, disk.o.data(), disk.k.data(), points.x, points.y, points.dx, points.dy,
            points.count, sums);
    return scaled(disk, sums);
}

} // namespace bask
