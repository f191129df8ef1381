// What a view factor may cost at the worst: sources of as many harmonics as a fit may have, cut by the plane
// of an object anywhere from near contact to far.

#include "tests/engine/radiation/face_pairs.h"
#include "tests/support/sanitized.h"
#include "tests/support/thread_time.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace bask {
namespace {

using test::Draw;
using test::FacePair;
using test::poseAt;

// A circle with waves whose amplitudes fall with the power `decay` of the harmonic; their speeds add up to
// `share` of the circle's.
FourierContour roughOutline(Draw& draw, int harmonics, double radius_m, double decay, double share) {
    std::vector<std::complex<double>> c(static_cast<std::size_t>(2 * harmonics + 1));
    const auto middle = c.begin() + harmonics;
    double speed = 0.0;
    for (int j = -harmonics; j <= harmonics; ++j) {
        if (j == 0 || j == 1)
            continue;
        const double size = std::pow(std::abs(static_cast<double>(j)), -decay) * draw.between(0.3, 1.0);
        middle[j] = std::polar(size, draw.between(-test::kPi, test::kPi));
        speed += std::abs(j) * size;
    }
    for (auto& one : c)
        one *= radius_m * share / speed;
    middle[1] = radius_m;
    return FourierContour(c);
}

FacePair roughPair(Draw& draw, int harmonics, double decay, double share, int kind, int variety) {
    const double r = 0.1;
    const double size = r * std::exp(draw.between(std::log(0.1), std::log(3.0)));
    FacePair pair{roughOutline(draw, harmonics, r, decay, share), Disk{size}, Pose::Identity(), size};
    if (kind == 1)
        pair.object = roughOutline(draw, variety % 2 == 0 ? 5 : harmonics, size, decay, share);
    else if (kind == 2)
        pair.object = test::drawShape(draw, 2, size);
    const double lean = draw.between(0.05, 2.2);
    const double reach = size * std::abs(std::sin(lean));
    const double height = variety % 4 == 3 ? reach * draw.between(-0.9, 0.9) // dips into the source's plane
                                           : reach + r * std::pow(10.0, draw.between(-4.0, 0.5));
    const auto turned = [&] { return poseAt(0, 0, 0, 0, 0, draw.between(-test::kPi, test::kPi)); };
    pair.X_SO = turned() * poseAt(r * draw.between(0.0, 1.6), 0, height);
    if (variety % 3 == 0)
        pair.X_SO = pair.X_SO * turned();
    pair.X_SO = pair.X_SO * poseAt(0, 0, 0, 0, lean, 0) * turned();
    return pair;
}

// Catches: the source's points computed anew for every stretch of the object, which took 0.1 s and more; and
// an estimate that pays for speed.
TEST(ViewFactorCost, theWorstOfManyHarmonicsTakesATwentiethOfASecond) {
    Draw draw(301);
    int cut = 0, compared = 0;
    double worst_s = 0.0;
    for (const int harmonics : {39, 40})
        for (const double decay : {0.5, 1.5, 3.0})
            for (const double share : {0.5, 1.0, 2.0})
                for (int kind = 0; kind < test::kKinds; ++kind)
                    for (int i = 0; i < 10; ++i) {
                        SCOPED_TRACE(testing::Message()
                                     << harmonics << " harmonics, decay " << decay << ", share " << share
                                     << ", kind " << kind << ' ' << i);
                        const FacePair pair = roughPair(draw, harmonics, decay, share, kind, i);
                        if (shapeArea(pair.source) <= 0.0 || shapeArea(pair.object) <= 0.0)
                            continue;
                        const RadiatingContour source(pair.source), object(pair.object);
                        double least_s = 1e300; // of a few: the caches are cold, the machine may be shared
                        ViewFactor f;
                        for (int k = 0; k < 4 && (k == 0 || least_s > 0.02); ++k) {
                            const double before_s = test::threadTime_s();
                            f = viewFactor(source, object, pair.X_SO);
                            least_s = std::min(least_s, test::threadTime_s() - before_s);
                        }
                        worst_s = std::max(worst_s, least_s);
                        cut += f.visibility == Visibility::Partial;
                        EXPECT_LE(f.errorEstimate, 1e-9);
                        if (i > 1)
                            continue;
                        const ViewFactor sharp = viewFactor(source, object, pair.X_SO, test::kSharp);
                        EXPECT_LE(std::abs(f.value - sharp.value), f.errorEstimate + sharp.errorEstimate);
                        compared += f.visibility == Visibility::Partial;
                    }
    EXPECT_GT(cut, 270);
    EXPECT_GT(compared, 50);
    RecordProperty("worst_ms", std::to_string(1e3 * worst_s));
    EXPECT_LT(worst_s, test::kIsSanitized ? 2.0 : 0.05);
}

} // namespace
} // namespace bask
