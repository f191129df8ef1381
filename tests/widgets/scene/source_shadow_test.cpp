#include "widgets/scene/source_shadow.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

Experiment twoDisks() {
    Experiment experiment;
    experiment.source.shape = Disk{0.1};
    experiment.source.pose << 0.3, -0.2, 0.1, 0.2, -0.1, 0.5;
    experiment.objects.resize(2);
    experiment.objects[0].shape = Disk{0.015};
    experiment.objects[1].shape = Disk{0.02};
    experiment.objects[1].mounting[kZ] = -0.04;
    return experiment;
}

/// The end-effector's pose at a place over the source, parallel to it.
Vector6d over(const Experiment& experiment, double x_m, double z_m) {
    return coordinatesFromPose(poseFromCoordinates(experiment.source.pose) *
                               Pose(Eigen::Translation3d(x_m, 0.0, z_m)));
}

// Catches: a shadow of another size, elsewhere than on the source's plane, or in its axes instead of the
// robot's.
TEST(SourceShadow, IsTheDiskThatTheCentreDoesNotSee) {
    const Experiment experiment = twoDisks();
    const Pose X_SR = poseFromCoordinates(experiment.source.pose).inverse();
    const auto lines = shadowLines(experiment, 0, over(experiment, 0.0, 0.1));
    ASSERT_EQ(lines.size(), 480u);
    for (const Eigen::Vector3d& p : lines)
        EXPECT_NEAR(((X_SR * p) - Eigen::Vector3d::Zero()).norm(), 0.05, 1e-9)
            << "10 cm over 4 cm times 2 cm";
    EXPECT_NEAR((X_SR * lines[0]).z(), 0.0, 1e-12);
}

// Catches: a shadow thrown upwards, beside the source, or whole where a part of it is on the source.
TEST(SourceShadow, OnlyWhatIsInTheLightAndOnTheSourceIsDrawn) {
    const Experiment experiment = twoDisks();
    EXPECT_TRUE(shadowLines(experiment, 1, over(experiment, 0.0, 0.1)).empty()) << "it hides the other one";
    EXPECT_TRUE(shadowLines(experiment, 0, over(experiment, 0.3, 0.1)).empty()) << "beside the source";
    EXPECT_TRUE(shadowLines(experiment, 0, over(experiment, 0.0, 0.03)).empty()) << "behind the source";
    const auto part = shadowLines(experiment, 0, over(experiment, 0.1, 0.1));
    EXPECT_GT(part.size(), 100u);
    EXPECT_LT(part.size(), 380u);
}

} // namespace
} // namespace bask
