#include "engine/radiation/lambert_batch.h"

#include "engine/radiation/kernels/kernels.h"
#include "engine/radiation/lambert_field.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace bask {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Calls `check` once for each kind of processor that this one can stand in for.
template <class Check> void forAllKernels(const Check& check) {
    const kernels::Kernels& before = kernels::kernels();
    const kernels::KernelList sets = kernels::runnableKernels();
    for (const kernels::Kernels* set : std::span(sets.sets, static_cast<std::size_t>(sets.count))) {
        SCOPED_TRACE(set->name);
        kernels::useKernels(*set);
        check();
    }
    kernels::useKernels(before);
}

class Random {
public:
    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(m_engine);
    }
    Vector3d vector() { return {uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0)}; }
    Vector2d direction() {
        const double angle = uniform(0.0, 2.0 * std::numbers::pi);
        return {std::cos(angle), std::sin(angle)};
    }

private:
    std::mt19937_64 m_engine{5};
};

void expectNear(const Vector3d& is, const Vector3d& should, double size) {
    EXPECT_LT((is - should).norm(), 1e-13 * (size + should.norm()));
}

// More lines than fit at a time, for several points. Catches: a line that counts for another point, and what
// pads the last vector.
TEST(LambertBatch, addsStraightLinesAsOneByOne) {
    forAllKernels([] {
        Random random;
        constexpr int kLines = 333;
        LambertBatch batch;
        std::vector<Vector3d> sums(LambertBatch::kPoints, Vector3d::Zero());
        for (int i = 0; i < kLines; ++i) {
            const int point = i % 7;
            const double factor = random.uniform(-1.0, 1.0);
            const Vector3d a = random.vector(), b = random.vector();
            batch.addStraight(point, factor, a, b);
            sums[static_cast<std::size_t>(point)] += factor * straightField(a, b);
        }
        batch.finish();
        for (int point = 0; point < LambertBatch::kPoints; ++point)
            expectNear(batch.field(point), sums[static_cast<std::size_t>(point)], 100.0);
    });
}

TEST(LambertBatch, isExactForLinesThatAreShortOrPassThePoint) {
    forAllKernels([] {
        Random random;
        for (int i = 0; i < 100; ++i) {
            const Vector3d a = random.vector();
            const Vector3d b = a + std::pow(10.0, random.uniform(-12.0, -1.0)) * random.vector();
            LambertBatch batch;
            batch.addStraight(0, 1.0, a, b);
            batch.addStraight(1, 1.0, a, -2.0 * a);
            batch.addStraight(2, 1.0, a, Vector3d::Zero());
            batch.finish();
            expectNear(batch.field(0), straightField(a, b), 0.01); // to the rounding of the product
            EXPECT_EQ(batch.field(1).norm(), 0.0);
            EXPECT_EQ(batch.field(2).norm(), 0.0);
        }
    });
}

// Near and far, from the axis, from the circle's plane, short and nearly whole.
TEST(LambertBatch, addsArcsAsOneByOne) {
    forAllKernels([] {
        Random random;
        for (int i = 0; i < 2000; ++i) {
            const double radius = random.uniform(0.1, 2.0);
            Vector3d p = std::pow(10.0, random.uniform(-2.0, 1.0)) * random.vector();
            if (i % 5 == 0)
                p.head<2>().setZero();
            const Eigen::Matrix3d axes = Eigen::Quaterniond(Eigen::Vector4d::Random().normalized()).matrix();
            const Vector2d from = random.direction();
            const double turn = std::pow(10.0, random.uniform(-6.0, 0.0)) * std::numbers::pi;
            const bool isLong = i % 2 == 0;
            const Vector2d to =
                Eigen::Rotation2Dd(isLong ? 2.0 * std::numbers::pi - turn : turn) * Vector2d(from);
            const ArcField arc(radius, p);
            LambertBatch batch;
            batch.addArc(0, -0.5, radius, p, from, to, isLong, axes);
            batch.addArc(1, 1.0, radius, p, from, from, true, axes);
            batch.finish();
            const double size = arc.whole().norm() + 1e-3; // parts of an arc cancel
            expectNear(batch.field(0), axes * (-0.5 * arc.between(from, to, isLong)), 10.0 * size);
            expectNear(batch.field(1), axes * arc.whole(), 10.0 * size);
        }
    });
}

} // namespace
} // namespace bask
