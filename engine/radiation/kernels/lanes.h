#pragma once
// Elementary functions on a vector of doubles of the width for which the including file is compiled. Only for
// the kernel files: they include no standard header and everything is inlined, so that the linker cannot
// share code compiled for a newer processor with the rest of the program.

namespace bask::kernels {

#define BASK_INLINE [[gnu::always_inline]] static inline

using Lanes = double __attribute__((vector_size(BASK_KERNEL_WIDTH)));
using LaneBits = unsigned long long __attribute__((vector_size(BASK_KERNEL_WIDTH)));
using LaneMask = decltype(Lanes{} > Lanes{});

constexpr int kLanes = BASK_KERNEL_WIDTH / 8;

BASK_INLINE Lanes load(const double* from) {
    Lanes result;
    __builtin_memcpy(&result, from, sizeof result);
    return result;
}
BASK_INLINE void store(double* to, Lanes x) {
    __builtin_memcpy(to, &x, sizeof x);
}
BASK_INLINE Lanes laneSqrt(Lanes x) {
    Lanes result;
    for (int i = 0; i < kLanes; ++i)
        result[i] = __builtin_sqrt(x[i]);
    return result;
}
BASK_INLINE double laneSum(Lanes x) {
    double part[kLanes];
    for (int i = 0; i < kLanes; ++i)
        part[i] = x[i];
    for (int half = kLanes / 2; half > 0; half /= 2) // in pairs: a third of the steps
        for (int i = 0; i < half; ++i)
            part[i] += part[i + half];
    return part[0];
}
BASK_INLINE double laneMin(Lanes x) {
    double part[kLanes];
    for (int i = 0; i < kLanes; ++i)
        part[i] = x[i];
    for (int half = kLanes / 2; half > 0; half /= 2)
        for (int i = 0; i < half; ++i)
            part[i] = part[i + half] < part[i] ? part[i + half] : part[i];
    return part[0];
}
BASK_INLINE Lanes select(LaneMask which, Lanes yes, Lanes no) {
    return which ? yes : no;
}
BASK_INLINE LaneBits selectBits(LaneMask which, LaneBits yes, LaneBits no) {
    return which ? yes : no;
}
BASK_INLINE LaneBits bitsOf(Lanes x) {
    return (LaneBits)x;
}
BASK_INLINE Lanes fromBits(LaneBits bits) {
    return (Lanes)bits;
}

BASK_INLINE Lanes laneAbs(Lanes x) {
    return select(x < 0.0, -x, x);
}
BASK_INLINE Lanes laneMax(Lanes a, Lanes b) {
    return select(a > b, a, b);
}

/// Returns atan2(y, x) to two or three units in the last place; atan2(0, 0) = 0. Reduction and polynomial are
/// those of Sun's fdlibm, without branches.
BASK_INLINE Lanes laneAtan2(Lanes y, Lanes x) {
    constexpr double kPi = 3.14159265358979323846;
    const Lanes ax = laneAbs(x);
    const Lanes ay = laneAbs(y);
    const auto steep = ay > ax;
    const Lanes max = select(steep, ay, ax) + 1e-305;
    const Lanes min = select(steep, ax, ay);
    const auto wide = min > 0.41421356237309503 * max;
    const Lanes a = select(wide, min - max, min) / select(wide, min + max, max);
    const Lanes z = a * a;
    const Lanes w = z * z;
    const Lanes even =
        z * (3.33333333333329318027e-01 +
             w * (1.42857142725034663711e-01 +
                  w * (9.09088713343650656196e-02 +
                       w * (6.66107313738753120669e-02 +
                            w * (4.97687799461593236017e-02 + w * 1.62858201153657823623e-02)))));
    const Lanes odd = w * (-1.99999999998764832476e-01 +
                           w * (-1.11111104054623557880e-01 +
                                w * (-7.69187620504482999495e-02 +
                                     w * (-5.83357013379057348645e-02 + w * -3.65315727442169155270e-02))));
    Lanes angle = a - a * (even + odd);
    angle = select(wide, angle + 0.25 * kPi, angle);
    angle = select(steep, 0.5 * kPi - angle, angle);
    angle = select(x < 0.0, kPi - angle, angle);
    return select(y < 0.0, -angle, angle);
}

/// ln(b/a) of positive normal numbers, where the difference b - a is given because it is more accurate than
/// the two numbers: the logarithm is 2 q p where `comparable` is set, q = difference/(a + b).
struct LogRatio {
    Lanes log;
    Lanes p;             ///< atanh(q)/q
    Lanes inverse;       ///< 1/(a + b) where comparable
    LaneMask comparable; ///< b/a between about 1/sqrt(2) and sqrt(2)
};

BASK_INLINE LogRatio logRatio(Lanes a, Lanes b, Lanes difference) {
    constexpr unsigned long long kExponent = 0x7ff0000000000000ull;
    constexpr unsigned long long kOne = 0x0010000000000000ull; // one step of the exponent
    // The power of two between them, still in the position of the exponent; wraps around below zero.
    LaneBits shift = (bitsOf(b) & kExponent) - (bitsOf(a) & kExponent);
    Lanes scaled = fromBits(bitsOf(b) - shift);
    const auto high = scaled > 1.41421356237309505 * a;
    const auto low = scaled < 0.70710678118654752 * a;
    scaled = select(high, 0.5 * scaled, select(low, 2.0 * scaled, scaled));
    shift = selectBits(high, shift + kOne, selectBits(low, shift - kOne, shift));
    const Lanes power = fromBits(((shift >> 52) & 0xfffull) + 0x4330000000000000ull) - 4503599627370496.0;
    const Lanes exponent = select(power > 2048.0, power - 4096.0, power); // from twelve bits with a sign
    const auto comparable = exponent == 0.0;
    const Lanes inverse = 1.0 / (scaled + a);
    const Lanes q = select(comparable, difference, scaled - a) * inverse;
    const Lanes z = q * q;
    const Lanes w = z * z;
    const Lanes r =
        z * (6.666666666666735130e-01 +
             w * (2.857142874366239149e-01 + w * (1.818357216161805012e-01 + w * 1.479819860511658591e-01))) +
        w * (3.999999999940941908e-01 + w * (2.222219843214978396e-01 + w * 1.531383769920937332e-01));
    const Lanes p = 1.0 + 0.5 * r;
    return {exponent * 0.69314718055994530942 + 2.0 * q * p, p, inverse, comparable};
}

} // namespace bask::kernels
