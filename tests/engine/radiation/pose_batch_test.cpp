// Eight poses at once against each by itself.

#include "engine/radiation/pose_batch.h"

#include "engine/base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>

namespace bask {
namespace {

using Poses = PoseBatch::Poses;
using Factors = PoseBatch::Factors;

std::vector<Pose> randomPoses(unsigned seed, double tilt_rad, int count) {
    std::mt19937 random(seed);
    const auto uniform = [&](double min, double max) {
        return std::uniform_real_distribution(min, max)(random);
    };
    std::vector<Pose> poses;
    for (int k = 0; k < count; ++k) {
        Vector6d q;
        q << uniform(-0.25, 0.25), uniform(-0.25, 0.25), uniform(0.01, 0.3), uniform(-tilt_rad, tilt_rad),
            uniform(-tilt_rad, tilt_rad), uniform(-3.0, 3.0);
        poses.push_back(poseFromCoordinates(q));
        if (k % 16 != 0 && k % 16 < 8) // every other row has one rotation
            poses.back().linear() = poses[static_cast<std::size_t>(k - k % 16)].linear();
    }
    return poses;
}

Poses rowOf(std::span<const Pose> eight) {
    Poses row;
    row.isOneRotation =
        std::ranges::all_of(eight, [&](const Pose& X) { return X.linear() == eight[0].linear(); });
    for (int k = 0; k < PoseBatch::kPoses; ++k)
        for (int i = 0; i < 3; ++i) {
            row.p[i][k] = eight[static_cast<std::size_t>(k)].translation()[i];
            for (int j = 0; j < 3; ++j)
                row.R[i][j][k] = eight[static_cast<std::size_t>(k)].linear()(i, j);
        }
    return row;
}

FourierContour blob() {
    using namespace std::complex_literals;
    return FourierContour({0.0002, 0.0005i, 0.001, 0.0, 0.015, 0.001i, 0.0008});
}

/// Returns how many poses were computed at once.
int compare(const RadiatingContour& source, const RadiatingContour& object, double tilt_rad,
            double tolerance) {
    const auto batch = PoseBatch::of(source, object, tolerance);
    EXPECT_TRUE(batch);
    int computed = 0;
    const auto poses = randomPoses(29, tilt_rad, 800);
    for (std::size_t at = 0; at < poses.size(); at += PoseBatch::kPoses) {
        const Poses row = rowOf(std::span(poses).subspan(at, PoseBatch::kPoses));
        Factors values, factors;
        batch->compute(row, PoseBatch::kPoses, false, values);
        batch->compute(row, PoseBatch::kPoses, true, factors);
        EXPECT_EQ(values.computed, factors.computed);
        for (std::size_t k = 0; k < PoseBatch::kPoses; ++k) {
            if ((values.computed >> k & 1U) == 0U)
                continue;
            ++computed;
            const ViewFactor exact = viewFactor(source, object, poses[at + k], {.tolerance = 1e-15});
            EXPECT_NEAR(values.values[k], exact.value, values.error + 1e-14);
            EXPECT_NEAR(factors.values[k], exact.value, factors.error + 1e-14);
            EXPECT_LE(values.error, tolerance * 1.01 + 1e-12);
            if (tolerance < 1e-12) {
                EXPECT_NEAR(values.values[k], exact.value, 1e-12);
                for (int i = 0; i < 6; ++i)
                    EXPECT_NEAR(factors.gradients[i][k], exact.gradient[i],
                                1e-9 + 1e-9 * exact.gradient.norm());
            }
        }
    }
    return computed;
}

// Catches: a rule with too few points for the nearest of the eight, a lane that gets another one's number, a
// wrong half of the circle, moments in other axes.
TEST(PoseBatchTest, GivesWhatEachPoseGivesByItself) {
    const kernels::Kernels& usual = kernels::kernels();
    const kernels::KernelList sets = kernels::runnableKernels();
    const RadiatingContour source(Disk{0.10});
    for (int set = 0; set < sets.count; ++set) {
        SCOPED_TRACE(sets.sets[set]->name);
        kernels::useKernels(*sets.sets[set]);
        for (const double tolerance : {1e-4, 1e-9, 1e-13}) {
            for (const RadiatingContour& object :
                 {RadiatingContour(Disk{0.015}), RadiatingContour(Disk{0.15}), RadiatingContour(blob())}) {
                EXPECT_GT(compare(source, object, 0.0, tolerance), 200) << tolerance;
                EXPECT_GT(compare(source, object, 0.3, tolerance), 20) << tolerance;
            }
        }
    }
    kernels::useKernels(usual);
}

// Catches: a strip of parallel disks that is wider than it is for the nearest of the eight.
TEST(PoseBatchTest, ParallelDisksAreExactWhateverTheTolerance) {
    const RadiatingContour source(Disk{0.10});
    const auto poses = randomPoses(31, 0.0, 1600);
    for (const RadiatingContour& object : {RadiatingContour(Disk{0.015}), RadiatingContour(Disk{0.15})}) {
        const auto batch = PoseBatch::of(source, object, 1e-4);
        ASSERT_TRUE(batch);
        int exact = 0;
        for (std::size_t at = 0; at < poses.size(); at += PoseBatch::kPoses) {
            Factors factors;
            batch->compute(rowOf(std::span(poses).subspan(at, PoseBatch::kPoses)), PoseBatch::kPoses, true,
                           factors);
            for (std::size_t k = 0; k < PoseBatch::kPoses && factors.error < 2e-12; ++k) {
                if ((factors.computed >> k & 1U) == 0U)
                    continue;
                ++exact;
                const ViewFactor alone = viewFactor(source, object, poses[at + k], {.tolerance = 1e-15});
                EXPECT_NEAR(factors.values[k], alone.value, 2e-14);
                for (int i = 0; i < 6; ++i)
                    EXPECT_NEAR(factors.gradients[i][k], alone.gradient[i],
                                1e-11 + 1e-11 * alone.gradient.norm());
            }
        }
        EXPECT_GT(exact, 100);
    }
}

TEST(PoseBatchTest, LeavesOutWhatIsCutHiddenOrNotThere) {
    const RadiatingContour source(Disk{0.10}), object(Disk{0.015});
    const auto batch = PoseBatch::of(source, object, 1e-9);
    ASSERT_TRUE(batch);
    const auto at = [](double z, double theta_x) {
        Vector6d q = Vector6d::Zero();
        q[kZ] = z;
        q[kThetaX] = theta_x;
        return poseFromCoordinates(q);
    };
    const std::vector<Pose> poses{at(0.1, 0.1), at(0.1, 1.3), at(-0.1, 0.0), at(0.1, 3.0),
                                  at(0.2, 0.0), at(NAN, 0.0), at(0.0, 0.0),  at(0.3, 0.0)};
    Factors factors;
    batch->compute(rowOf(poses), PoseBatch::kPoses, true, factors);
    EXPECT_EQ(factors.computed, 0b10010001U);
    batch->compute(rowOf(poses), 5, true, factors);
    EXPECT_EQ(factors.computed, 0U) << "two are as fast by themselves";
}

TEST(PoseBatchTest, IsForAWholeEvenDiskAndSmoothOutlinesOnly) {
    const RadiatingContour disk(Disk{0.1}), square(Contour{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
    EXPECT_TRUE(PoseBatch::of(disk, disk, 1e-9));
    EXPECT_FALSE(PoseBatch::of(square, disk, 1e-9));
    EXPECT_FALSE(PoseBatch::of(disk, square, 1e-9));
    EXPECT_FALSE(PoseBatch::of(disk, disk, 0.0));
    const RadiatingSource uneven({{disk, Pose::Identity()}}, {0.9});
    EXPECT_FALSE(PoseBatch::of(uneven, disk, 1e-9));
    Pose aside = Pose::Identity();
    aside.translation().x() = 0.1;
    EXPECT_FALSE(PoseBatch::of(RadiatingSource({{disk, aside}}, {1.0}), disk, 1e-9));
}

} // namespace
} // namespace bask
