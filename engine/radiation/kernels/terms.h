#pragma once
// The contribution of points of the object's outline to the integrals of MODEL section 2, for each kind of
// source, in vectors (lanes.h).
//
// All of them give a potential G with the same circulation around the object as W. Integrating W = oint ln|r|
// ds, r = p - s, by parts over the closed contour of the source gives
//     G(p) = - oint r (r . ds)/r^2,
// which needs one division where W needs a logarithm. The parts of a closed contour (arc and chord, edges)
// may be summed, but not used separately. B = oint r x ds / r^2.

#include "engine/radiation/kernels/kernels.h"
#include "engine/radiation/kernels/lanes.h"

namespace bask::kernels {

/// Value (G.dp), force dp x B and torque lever x (dp x B).
struct Term {
    Lanes value{};
    Lanes f1{}, f2{}, f3{};
    Lanes t1{}, t2{}, t3{};
};

/// Force and torque of a step (d) with a lever (l) in a field (b), all in the same axes.
BASK_INLINE void addMoments(Term& sum, Lanes l1, Lanes l2, Lanes l3, Lanes d1, Lanes d2, Lanes d3, Lanes b1,
                            Lanes b2, Lanes b3) {
    const Lanes f1 = d2 * b3 - d3 * b2;
    const Lanes f2 = d3 * b1 - d1 * b3;
    const Lanes f3 = d1 * b2 - d2 * b1;
    sum.f1 += f1;
    sum.f2 += f2;
    sum.f3 += f3;
    sum.t1 += l2 * f3 - l3 * f2;
    sum.t2 += l3 * f1 - l1 * f3;
    sum.t3 += l1 * f2 - l2 * f1;
}

/// Closed form W = -2 pi r^2/(a + S) k x p; sums are over -2 pi r^2, moments in **O axes**, where
/// B = -g_z p + (B_z + z g_z) k.
/// Lanes are points at one pose (OfPose = double, OfPoint = Lanes) or poses of one point (the other way
/// round).
template <bool kMoments, class OfPose, class OfPoint>
BASK_INLINE void addWholeDisk(double r2, const OfPose (&o)[3], const OfPose (&k)[3], OfPoint x, OfPoint y,
                              OfPoint dx, OfPoint dy, Term& sum) {
    const OfPose o3 = o[2], k1 = k[0], k2 = k[1], k3 = k[2];
    const Lanes p1 = o[0] + x;
    const Lanes p2 = o[1] + y;
    const Lanes square = p1 * p1 + p2 * p2 + o3 * o3;
    const Lanes z = k1 * p1 + k2 * p2 + k3 * o3;
    const Lanes a = square + r2;
    const Lanes t = square - r2;
    const Lanes s = laneSqrt(t * t + (4.0 * r2) * (z * z) + 1e-300); // a point on the rim itself stays finite
    const Lanes step = (k2 * o3) * dx - (k1 * o3) * dy + k3 * (p1 * dy - p2 * dx);
    if constexpr (!kMoments) {
        sum.value += step / (a + s);
    } else {
        const Lanes both = 1.0 / (s * (a + s));
        const Lanes u = s * both;
        const Lanes v = (a + s) * both;
        sum.value += step * u;
        const Lanes gz = -2.0 * z * both;
        const Lanes h = 2.0 * u * (1.0 - (square - z * z) * (s + t) * both - z * z * v);
        const Lanes b3 = h * k3 - gz * o3;
        const Lanes f1 = dy * b3;
        const Lanes f2 = -dx * b3;
        const Lanes f3 = dx * (h * k2 - gz * p2) - dy * (h * k1 - gz * p1);
        sum.f1 += f1;
        sum.f2 += f2;
        sum.f3 += f3;
        sum.t1 += y * f3;
        sum.t2 -= x * f3;
        sum.t3 += x * f2 - y * f1;
    }
}

/// Moments are in segment axes; the value is divided by the radius. `onChordLine`: the point is on the
/// chord's own line, and the caller adds that part of B.
template <bool kMoments>
BASK_INLINE void addSegment(const Segment& g, Lanes x, Lanes y, Lanes dx, Lanes dy, Term& sum,
                            bool onChordLine) {
    const Lanes l1 = g.turn[0][0] * x + g.turn[0][1] * y;
    const Lanes l2 = g.turn[1][0] * x + g.turn[1][1] * y;
    const Lanes l3 = g.turn[2][0] * x + g.turn[2][1] * y;
    const Lanes d1 = g.turn[0][0] * dx + g.turn[0][1] * dy;
    const Lanes d2 = g.turn[1][0] * dx + g.turn[1][1] * dy;
    const Lanes p1 = g.origin[0] + g.inverseRadius * l1;
    const Lanes p2 = g.origin[1] + g.inverseRadius * l2;
    const Lanes z = g.origin[2] + g.inverseRadius * l3;
    const double cb = g.cosBeta, sb = g.sinBeta;
    const double turn = 2.0 * g.beta, sinTurn = 2.0 * sb * cb, cosTurn = cb * cb - sb * sb;

    // psi is the angle from p's azimuth, D = a - b cos(psi) the squared distance; 0 and 1 the arc's ends
    // theta = -beta and +beta.
    const Lanes off = p1 + 1e-140; // on the disk's axis the azimuth is zero
    const Lanes rho2 = off * off + p2 * p2;
    const Lanes rho = laneSqrt(rho2);
    const Lanes perRho = 1.0 / rho;
    const Lanes c = off * perRho;
    const Lanes s = p2 * perRho;
    const Lanes z2 = z * z;
    const Lanes a = rho2 + z2 + 1.0;
    const Lanes t = rho2 + z2 - 1.0;
    const Lanes root = laneSqrt(t * t + 4.0 * z2 + 1e-300);
    const Lanes perSum = 1.0 / (a + root);
    const Lanes kappa = 2.0 * rho * perSum;
    const Lanes dCos = 2.0 * sb * s; // cos(psi1) - cos(psi0)
    const Lanes dSin = 2.0 * sb * c;
    const Lanes across = p1 - cb;
    const Lanes near0 = p2 + sb;
    const Lanes near1 = p2 - sb;
    const Lanes square = across * across + z2 + 1e-300;
    const Lanes end0 = square + near0 * near0;
    const Lanes end1 = square + near1 * near1;
    const Lanes b = 2.0 * rho;
    const LogRatio ratio = logRatio(end0, end1, -b * dCos);
    const Lanes half = select(ratio.comparable, -dCos * ratio.inverse * ratio.p, 0.25 * ratio.log * perRho);
    const Lanes logs = b * half; // ln(D1/D0)/2, half = that over b
    const Lanes numerator = dSin - kappa * sinTurn;
    const Lanes denominator = 1.0 - 2.0 * cb * c * kappa + kappa * kappa * cosTurn;
    const Lanes swing = laneAtan2(kappa * numerator, denominator);
    const Lanes perKappa = swing * (0.5 * perRho) * (a + root);

    // Distance from the chord within the object's plane, and the angle that the chord subtends.
    const Lanes away = laneMax(g.sinTilt * z - g.normal3 * across, Lanes{});
    const Lanes angle = laneAtan2(away * (2.0 * sb), away * away + near0 * near1);

    const Lanes radial = -a * half - 0.5 * dCos;
    const Lanes around = -0.5 * (kappa * turn - 2.0 * root * perSum * perKappa + dSin);
    const Lanes g1 = cb * logs + radial * c - around * s;
    const Lanes g2 = p2 * logs + radial * s + around * c + (2.0 * sb - away * angle);
    sum.value += g1 * d1 + g2 * d2;
    if constexpr (kMoments) {
        const Lanes d3 = g.turn[2][0] * dx + g.turn[2][1] * dy;
        const Lanes perRoot = 1.0 / root;
        const Lanes inverse = (turn + 2.0 * swing) * perRoot;
        const Lanes cosine = (kappa * turn + 2.0 * a * perSum * perKappa) * perRoot;
        const Lanes bRho = -z * cosine;
        const Lanes bPhi = -2.0 * z * half;
        const Lanes seen = onChordLine ? Lanes{} : angle;
        addMoments(sum, l1, l2, l3, d1, d2, d3, bRho * c - bPhi * s + seen * g.sinTilt, bRho * s + bPhi * c,
                   rho * cosine - inverse + seen * g.normal3);
    }
}

/// A node of a smooth source contour in S: point and weighted step. `z` is the object point's height.
struct NodeSums {
    Lanes g1{}, g2{};
    Lanes b3{}, across1{}, across2{};
};

template <bool kMoments>
BASK_INLINE void addNode(Lanes p1, Lanes p2, Lanes z2, double s1, double s2, double ds1, double ds2,
                         NodeSums& sum) {
    const Lanes r1 = p1 - s1;
    const Lanes r2 = p2 - s2;
    const Lanes inverse = 1.0 / (r1 * r1 + r2 * r2 + z2);
    const Lanes q = (r1 * ds1 + r2 * ds2) * inverse;
    sum.g1 -= r1 * q;
    sum.g2 -= r2 * q;
    if constexpr (kMoments) {
        sum.b3 += (r1 * ds2 - r2 * ds1) * inverse;
        sum.across1 += ds1 * inverse;
        sum.across2 += ds2 * inverse;
    }
}

/// `skipField`: the object's point is on the edge's own line, and the caller adds that part of B.
template <bool kMoments>
BASK_INLINE void addEdge(const Edge& e, Lanes p1, Lanes p2, Lanes z, Lanes& g1, Lanes& g2, Lanes& b1,
                         Lanes& b2, Lanes& b3, bool skipField) {
    const Lanes r1 = p1 - e.a1;
    const Lanes r2 = p2 - e.a2;
    const Lanes from = r1 * e.t1 + r2 * e.t2;
    const Lanes to = from - e.length;
    const Lanes aside = r2 * e.t1 - r1 * e.t2;
    const Lanes h2 = aside * aside + z * z + 1e-290;
    const Lanes h = laneSqrt(h2);
    const Lanes angle = laneAtan2(h * e.length, h2 + from * to);
    const Lanes fromSquared = from * from + h2;
    const Lanes toSquared = to * to + h2;
    const Lanes logs = 0.5 * logRatio(fromSquared, toSquared, (to - from) * (to + from)).log;
    const Lanes along = h * angle - e.length;
    g1 += e.t1 * along - (e.t2 * aside) * logs;
    g2 += e.t2 * along + (e.t1 * aside) * logs;
    if constexpr (kMoments) {
        const Lanes seen = skipField ? Lanes{} : angle / h;
        b1 -= (e.t2 * z) * seen;
        b2 += (e.t1 * z) * seen;
        b3 -= aside * seen;
    }
}

struct SeriesSums {
    Lanes x{}, y{}, dx{}, dy{};
};

/// Horner's scheme in both directions of j, the derivative beside the value.
BASK_INLINE SeriesSums seriesSums(const Series& series, Lanes c, Lanes s) {
    Lanes up1{}, up2{}, upSlope1{}, upSlope2{};
    Lanes down1{}, down2{}, downSlope1{}, downSlope2{};
    const double* const middle = series.coefficients + 2 * series.harmonics;
    for (int j = series.harmonics; j >= 1; --j) {
        const double* const plus = middle + 2 * j;
        const double* const minus = middle - 2 * j;
        const Lanes u1 = up1 + plus[0], u2 = up2 + plus[1];
        up1 = u1 * c - u2 * s;
        up2 = u1 * s + u2 * c;
        const Lanes us1 = upSlope1 + j * plus[0], us2 = upSlope2 + j * plus[1];
        upSlope1 = us1 * c - us2 * s;
        upSlope2 = us1 * s + us2 * c;
        const Lanes d1 = down1 + minus[0], d2 = down2 + minus[1];
        down1 = d1 * c + d2 * s;
        down2 = d2 * c - d1 * s;
        const Lanes ds1 = downSlope1 - j * minus[0], ds2 = downSlope2 - j * minus[1];
        downSlope1 = ds1 * c + ds2 * s;
        downSlope2 = ds2 * c - ds1 * s;
    }
    return {middle[0] + up1 + down1, middle[1] + up2 + down2, -(upSlope2 + downSlope2),
            upSlope1 + downSlope1};
}

/// Lambert's angle of a straight line as a vector; none for a line through the point.
BASK_INLINE void straightField(double* const* rows, int i) {
    const Lanes a1 = load(rows[0] + i), a2 = load(rows[1] + i), a3 = load(rows[2] + i);
    const Lanes b1 = load(rows[3] + i), b2 = load(rows[4] + i), b3 = load(rows[5] + i);
    const Lanes c1 = a2 * b3 - a3 * b2;
    const Lanes c2 = a3 * b1 - a1 * b3;
    const Lanes c3 = a1 * b2 - a2 * b1;
    const Lanes length = laneSqrt(c1 * c1 + c2 * c2 + c3 * c3);
    const Lanes dot = a1 * b1 + a2 * b2 + a3 * b3;
    const auto aside = length > 1e-15 * laneAbs(dot); // else its direction would be rounding
    const Lanes scale = select(aside, laneAtan2(length, dot) / length, Lanes{});
    store(rows[0] + i, scale * c1);
    store(rows[1] + i, scale * c2);
    store(rows[2] + i, scale * c3);
}

/// As in addSegment, about the point's azimuth.
BASK_INLINE void arcField(double* const* rows, int i) {
    constexpr double kTurn = 6.28318530717958647692;
    const Lanes radius = load(rows[0] + i), x = load(rows[1] + i), y = load(rows[2] + i),
                z = load(rows[3] + i);
    const Lanes from1 = load(rows[4] + i), from2 = load(rows[5] + i);
    const Lanes to1 = load(rows[6] + i), to2 = load(rows[7] + i);
    const Lanes off = x + 1e-140; // on the circle's axis the azimuth is zero
    const Lanes rho = laneSqrt(off * off + y * y);
    const Lanes perRho = 1.0 / rho;
    const Lanes c = off * perRho;
    const Lanes s = y * perRho;
    const Lanes z2 = z * z;
    const Lanes a = rho * rho + z2 + radius * radius;
    const Lanes b = 2.0 * radius * rho;
    const Lanes inner = radius - rho, outer = radius + rho;
    const Lanes root = laneSqrt((inner * inner + z2) * (outer * outer + z2));
    const Lanes perSum = 1.0 / (a + root);
    const Lanes perRoot = 1.0 / root;
    const Lanes kappa = b * perSum;
    Lanes turn = laneAtan2(from1 * to2 - from2 * to1, from1 * to1 + from2 * to2);
    // Not where rounding makes a whole turn a little more.
    turn = select((load(rows[8] + i) > 0.5) & (turn < 1.0), turn + kTurn, turn);
    const Lanes cos0 = from1 * c + from2 * s, sin0 = from2 * c - from1 * s;
    const Lanes cos1 = to1 * c + to2 * s, sin1 = to2 * c - to1 * s;
    const Lanes numerator = sin1 - sin0 + kappa * (sin0 * cos1 - cos0 * sin1);
    const Lanes denominator = (1.0 - kappa * cos0) * (1.0 - kappa * cos1) + kappa * kappa * (sin0 * sin1);
    const Lanes swing = laneAtan2(kappa * numerator, denominator) / b;
    const Lanes near1 = x - radius * from1, near2 = y - radius * from2;
    const Lanes far1 = x - radius * to1, far2 = y - radius * to2;
    const LogRatio ratio =
        logRatio(near1 * near1 + near2 * near2 + z2, far1 * far1 + far2 * far2 + z2, b * (cos0 - cos1));
    const Lanes sine = select(ratio.comparable, 2.0 * (cos0 - cos1) * ratio.inverse * ratio.p, ratio.log / b);
    const Lanes cosine = (turn * kappa + 2.0 * a * swing) * perRoot;
    const Lanes one = (turn + 2.0 * b * swing) * perRoot;
    const Lanes along = z * radius * cosine;
    const Lanes across = z * radius * sine;
    store(rows[0] + i, c * along - s * across);
    store(rows[1] + i, s * along + c * across);
    store(rows[2] + i, radius * radius * one - rho * radius * cosine);
}

} // namespace bask::kernels
