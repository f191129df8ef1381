// What holds for view factors whatever the shapes and the pose: every test goes over all nine pairs of kinds.

#include "engine/radiation/point_factor.h"
#include "tests/engine/radiation/area_reference.h"
#include "tests/engine/radiation/face_pairs.h"

#include <gtest/gtest.h>

#include <map>

namespace bask {
namespace {

using test::Draw;
using test::FacePair;
using test::kPi;
using test::kSharp;
using test::poseAt;

ViewFactor factorOf(const FacePair& pair, const ViewFactorOptions& options = kSharp) {
    return viewFactor(RadiatingContour(pair.source), RadiatingContour(pair.object), pair.X_SO, options);
}

/// Calls `check` with `count` pairs of every two kinds.
template <class F> void forPairs(unsigned seed, int count, const F& check) {
    Draw draw(seed);
    for (int source = 0; source < test::kKinds; ++source)
        for (int object = 0; object < test::kKinds; ++object)
            for (int i = 0; i < count; ++i) {
                SCOPED_TRACE(testing::Message() << test::kKindNames[object] << " over "
                                                << test::kKindNames[source] << ", pose " << i);
                check(test::drawPair(draw, source, object, i), draw, i);
            }
}

// An estimate that says too much excuses nothing.
double sure(const ViewFactor& f) {
    return std::min(f.errorEstimate, 1e-9);
}

Pose nudged(const Pose& X_SO, int k, double step) {
    Pose X = X_SO;
    if (k < 3)
        X.translation()[k] += step;
    else
        X.linear() = Eigen::AngleAxisd(step, Eigen::Vector3d::Unit(k - 3)).toRotationMatrix() * X.linear();
    return X;
}

// Catches: a value outside [0, 1], an estimate that flatters, a tolerance passed over, by any kind of rule
// (tabulated, panels, tried out), with and without moments.
TEST(ViewFactorProperties, toleranceHoldsAndTheEstimateIsHonest) {
    std::map<Visibility, int> seen;
    forPairs(101, 80, [&](const FacePair& pair, Draw&, int) {
        const ViewFactor sharp = factorOf(pair);
        ++seen[sharp.visibility];
        EXPECT_LE(sharp.errorEstimate, 1e-10);
        for (const double tolerance : {1e-4, 1e-6, 1e-9}) {
            const ViewFactor f = factorOf(pair, {.tolerance = tolerance});
            ASSERT_TRUE(std::isfinite(f.value) && f.gradient.allFinite() && std::isfinite(f.errorEstimate));
            EXPECT_GE(f.value, 0.0);
            EXPECT_LE(f.value, 1.0);
            EXPECT_EQ(f.visibility, sharp.visibility);
            const double error = std::abs(f.value - sharp.value);
            EXPECT_LE(error, f.errorEstimate + sharp.errorEstimate) << tolerance;
            EXPECT_LE(error, tolerance + sharp.errorEstimate) << tolerance;
            EXPECT_LE(f.errorEstimate, 2.0 * tolerance + 1e-10);
            const double value = viewFactorValue(RadiatingContour(pair.source), RadiatingContour(pair.object),
                                                 pair.X_SO, tolerance);
            EXPECT_NEAR(value, sharp.value, tolerance + sharp.errorEstimate);
        }
    });
    EXPECT_GT(seen[Visibility::Full], 100);
    EXPECT_GT(seen[Visibility::Partial], 200);
    EXPECT_GT(seen[Visibility::Hidden], 50);
}

// Catches: anything wrong alike in all evaluations of the engine: sign, frame, cut, pieces. The reference
// says itself where it is good: three counts of nodes agree.
TEST(ViewFactorProperties, agreesWithLambertsLawOverBothVisibleAreas) {
    std::map<Visibility, int> compared;
    forPairs(102, 12, [&](const FacePair& pair, Draw&, int) {
        const ViewFactor f = factorOf(pair);
        if (f.visibility == Visibility::Hidden)
            return;
        const auto reference = [&](int nodes) {
            return test::areaViewFactor(pair.source, pair.object, pair.X_SO, nodes);
        };
        const double coarse = reference(5), finer = reference(7);
        if (std::abs(coarse - finer) > 1e-5)
            return; // too close together for it
        const double fine = reference(10), error = std::abs(fine - finer);
        if (error > 0.2 * std::abs(coarse - finer) + 1e-13)
            return;
        ++compared[f.visibility];
        EXPECT_NEAR(f.value, fine, error + 1e-12);
    });
    EXPECT_GT(compared[Visibility::Full], 12);
    EXPECT_GT(compared[Visibility::Partial], 12);
}

// Catches: either cut treated otherwise than the other, or a pair of kinds otherwise than the pair turned
// round: the two go different ways through the engine.
TEST(ViewFactorProperties, isReciprocal) {
    std::map<Visibility, int> seen;
    forPairs(103, 50, [&](const FacePair& pair, Draw&, int) {
        const FacePair back = test::exchanged(pair);
        const ViewFactor there = factorOf(pair), here = factorOf(back);
        const double a2 = shapeArea(pair.object), a1 = shapeArea(pair.source);
        EXPECT_NEAR(a2 * there.value, a1 * here.value,
                    a2 * sure(there) + a1 * sure(here) + 1e-13 * std::min(a1, a2));
        EXPECT_EQ(there.visibility, here.visibility);
        ++seen[there.visibility];
    });
    EXPECT_GT(seen[Visibility::Partial], 100);
}

// Two parts of a polygon that is star-shaped about a point near its origin, parted there.
std::pair<Contour, Contour> partsOf(const Contour& whole, std::size_t from, std::size_t to) {
    Contour first{{Eigen::Vector2d::Zero()}}, second{{Eigen::Vector2d::Zero()}};
    const auto& p = whole.points_m;
    for (std::size_t i = from; i <= to; ++i)
        first.points_m.push_back(p[i]);
    for (std::size_t i = to; i <= from + p.size(); ++i)
        second.points_m.push_back(p[i % p.size()]);
    return {first, second};
}

// Catches: an edge, a cut or a chord counted twice or not at all: parts of the source, and parts of the
// object by area, make the whole.
TEST(ViewFactorProperties, partsAddUpToTheWhole) {
    Draw draw(104);
    int partial = 0;
    for (int kind = 0; kind < test::kKinds; ++kind)
        for (int i = 0; i < 50; ++i) {
            SCOPED_TRACE(testing::Message() << test::kKindNames[kind] << ", pose " << i);
            FacePair pair = test::drawPair(draw, 2, kind, i);
            const Contour whole = i % 2 == 0 ? test::star(0.1, 5, 0.35) : draw.polygon(0.1, 8);
            const auto [first, second] = partsOf(whole, 1, 5);
            const auto source = [&](const Contour& contour) {
                return factorOf({contour, pair.object, pair.X_SO});
            };
            const ViewFactor f = source(whole), a = source(first), b = source(second);
            const double estimates = sure(f) + sure(a) + sure(b);
            EXPECT_NEAR(f.value, a.value + b.value, estimates + 1e-13);
            EXPECT_LE((f.gradient - a.gradient - b.gradient).norm(),
                      1e-6 * (1.0 + f.gradient.norm() + a.gradient.norm()));
            partial += f.visibility == Visibility::Partial;

            pair = test::drawPair(draw, kind, 2, i);
            const double size = shapeRadius(pair.object);
            const Contour object = std::get<Contour>(test::scaled(whole, size / 0.1));
            const auto [one, two] = partsOf(object, 1, 5);
            const auto part = [&](const Contour& contour) {
                const ViewFactor g = factorOf({pair.source, contour, pair.X_SO});
                return std::pair(contourArea(contour) * g.value, contourArea(contour) * sure(g));
            };
            const auto all = part(object), left = part(one), right = part(two);
            EXPECT_NEAR(all.first, left.first + right.first,
                        all.second + left.second + right.second + 1e-13 * contourArea(object));
        }
    EXPECT_GT(partial, 40);
}

// Catches: an outline taken for one about its own origin, an axis preferred to another, a lever from the
// wrong point.
TEST(ViewFactorProperties, isUnchangedByACommonMotion) {
    forPairs(105, 20, [&](const FacePair& pair, Draw& draw, int) {
        const ViewFactor f = factorOf(pair);
        const double angle = draw.between(-kPi, kPi);
        const double scale = 1.0 + f.gradient.norm();
        const auto motion = [&](const Shape& shape) {
            const double far = std::holds_alternative<Disk>(shape) ? 0.0 : 2.0 * shapeRadius(shape);
            return std::complex(draw.between(-far, far), draw.between(-far, far));
        };
        std::complex<double> shift = motion(pair.source);
        Pose turn = poseAt(shift.real(), shift.imag(), 0, 0, 0, angle);
        const ViewFactor a =
            factorOf({test::movedInPlane(pair.source, shift, angle), pair.object, turn * pair.X_SO});
        EXPECT_NEAR(a.value, f.value, sure(a) + sure(f));
        Vector6d expected;
        expected << turn.linear() * f.gradient.head<3>(), turn.linear() * f.gradient.tail<3>();
        EXPECT_LE((a.gradient - expected).norm(), 1e-7 * scale);
        EXPECT_EQ(a.visibility, f.visibility);

        shift = motion(pair.object);
        turn = poseAt(shift.real(), shift.imag(), 0, 0, 0, angle);
        const Pose X = pair.X_SO * turn.inverse();
        const ViewFactor b = factorOf({pair.source, test::movedInPlane(pair.object, shift, angle), X});
        EXPECT_NEAR(b.value, f.value, sure(b) + sure(f));
        EXPECT_LE((gradientAbout(b.gradient, X.translation(), pair.X_SO.translation()) - f.gradient).norm(),
                  1e-7 * scale);
        EXPECT_EQ(b.visibility, f.visibility);
    });
}

// Catches: a length that is not in proportion (an absolute threshold): a nanometre and a thousand kilometres.
TEST(ViewFactorProperties, dependsOnNoUnitOfLength) {
    forPairs(106, 12, [&](const FacePair& pair, Draw&, int) {
        const ViewFactor f = factorOf(pair);
        for (const double factor : {1e-8, 1e-3, 1e4, 1e7}) {
            FacePair other{test::scaled(pair.source, factor), test::scaled(pair.object, factor), pair.X_SO};
            other.X_SO.translation() *= factor;
            const ViewFactor g = factorOf(other);
            EXPECT_NEAR(g.value, f.value, sure(g) + sure(f)) << factor;
            EXPECT_EQ(g.visibility, f.visibility) << factor;
            Vector6d back = g.gradient;
            back.head<3>() *= factor;
            EXPECT_LE((back - f.gradient).norm(), 1e-7 * (1.0 + f.gradient.norm())) << factor;
        }
    });
}

// Catches: an error of the field's curl, of the lever or of the frozen cut for any kind of source. Where two
// steps of the fourth-order difference disagree (a corner passes the cut) nothing can be said; nor where one
// face runs through the other, which no plate can.
TEST(ViewFactorProperties, gradientIsTheDerivativeOfTheValue) {
    int checked = 0, partial = 0, unsaid = 0;
    forPairs(107, 20, [&](const FacePair& pair, Draw&, int) {
        const ViewFactor f = factorOf(pair);
        if (f.value < 1e-4 || test::runThroughEachOther(pair))
            return;
        const RadiatingContour source(pair.source), object(pair.object);
        const double reach = shapeRadius(pair.object);
        for (int k = 0; k < 6; ++k) {
            const auto difference = [&](double h) {
                const auto at = [&](double step) {
                    return viewFactor(source, object, nudged(pair.X_SO, k, step), kSharp).value;
                };
                return (8.0 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12.0 * h);
            };
            const double h = 1e-3 * (k < 3 ? pair.size_m : pair.size_m / std::max(reach, pair.size_m));
            const double wide = difference(h), narrow = difference(0.5 * h);
            const double unsure = std::abs(wide - narrow);
            const double roundoff = 4.0 * (f.errorEstimate + 1e-15) / h;
            if (unsure > 1e-4 * (std::abs(narrow) + 0.01 * f.gradient.norm()) + roundoff) {
                ++unsaid;
                continue;
            }
            ++checked;
            partial += f.visibility == Visibility::Partial;
            EXPECT_NEAR(f.gradient[k], narrow, unsure + roundoff + 1e-9 * f.gradient.norm()) << k;
        }
    });
    EXPECT_GT(checked, 400);
    EXPECT_GT(partial, 200);
    EXPECT_LT(unsaid, checked / 20);
}

// Catches: a jump of value or gradient where a cut begins to bite, a piece falls off or the last of a face
// disappears. Along random ways the places where the visibility changes are found by halving. Where the faces
// touch each other the gradient grows with the root of the way, elsewhere more slowly.
TEST(ViewFactorProperties, isContinuousThroughEveryChangeOfVisibility) {
    std::map<std::pair<Visibility, Visibility>, int> changes;
    forPairs(108, 20, [&](const FacePair& pair, Draw& draw, int) {
        const RadiatingContour source(pair.source), object(pair.object);
        const Eigen::Vector3d shift = draw.vector(2.0 * std::max(shapeRadius(pair.object), 0.1));
        const Eigen::Vector3d turn = draw.vector(1.5);
        const auto at = [&](double t, double tolerance) {
            const Pose X = Eigen::Translation3d(t * shift) * pair.X_SO *
                           poseFromRotationVector(Eigen::Vector3d::Zero(), t * turn);
            return viewFactor(source, object, X, {.tolerance = tolerance});
        };
        const auto visibility = [&](double t) { return at(t, 1e-2).visibility; };
        constexpr int kSteps = 20;
        for (int i = 0; i < kSteps; ++i) {
            double a = static_cast<double>(i) / kSteps, b = static_cast<double>(i + 1) / kSteps;
            const Visibility first = visibility(a);
            if (first == visibility(b))
                continue;
            while (b - a > 1e-11) {
                const double middle = 0.5 * (a + b);
                (visibility(middle) == first ? a : b) = middle;
            }
            const ViewFactor before = at(a, 1e-9), after = at(b, 1e-9);
            ++changes[std::minmax(before.visibility, after.visibility)];
            const double between = (b - a) * before.gradient.norm() * (shift.norm() + turn.norm());
            EXPECT_NEAR(before.value, after.value, sure(before) + sure(after) + between);
            EXPECT_LE((before.gradient - after.gradient).norm(), 1e-3 * (1.0 + before.gradient.norm()));
        }
    });
    EXPECT_GT((changes[{Visibility::Full, Visibility::Partial}]), 25);
    EXPECT_GT((changes[{Visibility::Partial, Visibility::Hidden}]), 25);
}

// Catches: a factor of area or a facing sign that only shows against the other solver. The object's outline
// is about its centroid, so what is left goes with its size squared.
TEST(ViewFactorProperties, aSmallObjectHasThePointFactor) {
    Draw draw(109);
    int seen = 0;
    for (int source = 0; source < test::kKinds; ++source)
        for (int kind = 0; kind < test::kKinds; ++kind)
            for (int i = 0; i < 15; ++i) {
                SCOPED_TRACE(testing::Message()
                             << test::kKindNames[kind] << " over " << test::kKindNames[source] << ' ' << i);
                const Shape shape = test::drawShape(draw, source, 0.1);
                Shape object = test::drawShape(draw, kind, 1.0);
                if (const auto* polygon = std::get_if<Contour>(&object))
                    object = centred(*polygon);
                else if (const auto* fourier = std::get_if<FourierContour>(&object))
                    object = test::movedInPlane(object, -fourier->centroid(), 0.0);
                Pose X_SO = poseFromRotationVector(draw.vector(0.15), draw.vector(1.5));
                X_SO.translation().z() = draw.between(0.04, 0.2);
                const double point = pointFactor(shape, X_SO.translation(), -X_SO.linear().col(2));
                for (const double size : {1e-3, 1e-4, 1e-5}) {
                    const ViewFactor f = factorOf({shape, test::scaled(object, size), X_SO});
                    EXPECT_NEAR(f.value, point,
                                2.0 * std::pow(size / X_SO.translation().z(), 2) + 2e-12 + f.errorEstimate)
                        << size;
                }
                seen += point > 0.01;
            }
    EXPECT_GT(seen, 50);
}

// Catches: digits lost where the two faces are far apart: A1 cos cos / (pi d^2), relatively.
TEST(ViewFactorProperties, farApartIsTheProductOfTheCosines) {
    Draw draw(110);
    for (int source = 0; source < test::kKinds; ++source)
        for (int kind = 0; kind < test::kKinds; ++kind)
            for (const double distance : {10.0, 100.0, 1000.0}) {
                SCOPED_TRACE(testing::Message() << test::kKindNames[kind] << " over "
                                                << test::kKindNames[source] << ' ' << distance);
                Shape face = test::drawShape(draw, source, 0.1);
                Shape object = test::drawShape(draw, kind, 0.1);
                const Eigen::Vector3d direction = Eigen::Vector3d(0.3, -0.4, 1.0).normalized();
                Pose X_SO = poseAt(0, 0, 0, 0.4, 0.2, 0.7);
                X_SO.translation() = distance * direction;
                const double expected = shapeArea(face) * direction.z() *
                                        X_SO.linear().col(2).dot(direction) / (kPi * distance * distance);
                const ViewFactor f = factorOf({face, object, X_SO});
                // The outlines' centroids are within 0.02 m of the origin.
                EXPECT_NEAR(f.value, expected, expected * 0.3 / distance + f.errorEstimate);
                EXPECT_LE(f.errorEstimate, 1e-11);
                EXPECT_NEAR(f.gradient.head<3>().dot(direction), -2.0 * expected / distance,
                            expected * 1.0 / (distance * distance) + 1e-12 / distance);
            }
}

} // namespace
} // namespace bask
