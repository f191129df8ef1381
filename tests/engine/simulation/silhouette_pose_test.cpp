// The pose of a thermal camera by the silhouettes of held objects, in pictures of the simulated camera.

#include "engine/thermography/silhouette_pose.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/calibration/projection.h"
#include "engine/simulation/simulated_camera.h"
#include "engine/simulation/simulated_thermal_camera.h"
#include "engine/thermography/usual_thermal_camera.h"
#include "tests/support/told_shares.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace bask {
namespace {

constexpr double kRoom_K = 298.15;

class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}
    double between(double a, double b) { return std::uniform_real_distribution(a, b)(m_engine); }
    int whole(int a, int b) { return std::uniform_int_distribution(a, b)(m_engine); }
    double normal() { return m_normal(m_engine); }
    /// Of length up to `max`.
    Eigen::Vector3d upTo(double max) {
        const Eigen::Vector3d direction(normal(), normal(), normal());
        return between(0.0, max) * direction.normalized();
    }

private:
    std::mt19937_64 m_engine;
    std::normal_distribution<double> m_normal;
};

/// What a rig's pictures are made of, with the true pose of its camera.
struct Rig {
    SimulatedThermalCameraConfig config;
    std::vector<Pose> robot; ///< X_RE of each picture
    std::vector<double> objects_K;
    double source_K = 400.0;
    Pose start = Pose::Identity(); ///< what is told of X_RC

    SilhouetteScene scene() const {
        SilhouetteScene out;
        for (const auto& object : config.objects)
            out.objects.push_back({object.shape, object.X_EO});
        for (const auto& plate : config.source)
            out.fixed.push_back({plate.shape, plate.X_SP});
        return out;
    }
};

const ThermalProfile& profileOf(const std::string& name) {
    const auto& all = shippedThermalProfiles();
    return *std::ranges::find(all, name, &ThermalProfile::name);
}

Contour polygonOf(std::vector<Eigen::Vector2d> points) {
    return centred(*makeContour(std::move(points)));
}

/// Three objects side by side over a source, which a camera above looks down on.
Rig randomRig(std::uint64_t seed) {
    Random random(seed);
    Rig rig;
    SimulatedThermalCameraConfig& config = rig.config;
    config.profile = profileOf(random.whole(0, 1) == 0 ? "lepton-3.5" : "p2-pro");
    config.camera = usualThermalLens(config.profile);
    const double lens = random.between(0.9, 1.3);
    config.camera.fx *= lens;
    config.camera.fy *= lens * random.between(0.99, 1.01);
    config.camera.cx += random.between(-3.0, 3.0);
    config.camera.cy += random.between(-3.0, 3.0);
    config.camera.distortion = {random.between(-0.25, 0.05), random.between(-0.05, 0.1), 0.0, 0.0, 0.0};
    config.X_RC = lookingAt({random.between(-0.3, 0.3), random.between(-0.3, 0.3), random.between(0.7, 1.0)},
                            {random.between(-0.03, 0.03), random.between(-0.03, 0.03), 0.15});
    config.environment_K = kRoom_K;
    config.source = {{Disk{random.between(0.05, 0.09)}, Pose::Identity(), 0.25}};
    rig.source_K = random.between(300.0, 450.0);
    const double r = random.between(0.025, 0.035);
    const std::vector<Shape> shapes{
        Disk{r},
        polygonOf({{-1.3 * r, -0.8 * r}, {1.3 * r, -0.8 * r}, {1.3 * r, 0.8 * r}, {-1.3 * r, 0.8 * r}}),
        polygonOf({{-r, -r}, {1.4 * r, -0.9 * r}, {0.2 * r, 1.5 * r}})};
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const Eigen::Vector3d at(0.09 * (static_cast<double>(k) - 1.0), random.between(-0.03, 0.03),
                                 random.between(-0.01, 0.01));
        config.objects.push_back(
            {shapes[k], poseFromRotationVector(at, {0.0, 0.0, random.between(-3.0, 3.0)})});
        rig.objects_K.push_back(kRoom_K + random.between(5.0, 30.0));
    }
    const auto isSeen = [&](const Pose& X_RE) {
        return std::ranges::all_of(config.objects, [&](const auto& object) {
            return isInPicture(config.camera, config.X_RC.inverse() * X_RE * object.X_EO.translation());
        });
    };
    const int poses = random.whole(4, 8);
    while (static_cast<int>(rig.robot.size()) < poses) {
        const Pose X_RE = poseFromRotationVector(
            {random.between(-0.08, 0.08), random.between(-0.08, 0.08), random.between(0.05, 0.3)},
            {random.between(-0.25, 0.25), random.between(-0.25, 0.25), random.between(-0.4, 0.4)});
        if (isSeen(X_RE))
            rig.robot.push_back(X_RE);
    }
    config.errors.seed = seed;
    const Eigen::Vector3d moved = random.upTo(0.05), turned = random.upTo(radFromDeg(5.0));
    Vector6d off;
    off << moved, turned;
    rig.start = displaced(config.X_RC, off);
    return rig;
}

std::vector<SilhouetteView> viewsOf(const Rig& rig) {
    SimulatedThermalCamera camera(rig.config);
    std::vector<SilhouetteView> views;
    for (std::size_t k = 0; k < rig.robot.size(); ++k) {
        ThermalMoment moment;
        moment.X_RE = rig.robot[k];
        moment.source_K.assign(rig.config.source.size(), rig.source_K);
        for (const double T_K : rig.objects_K)
            moment.objects.push_back({T_K, {0.9, {}, kRoom_K}, {0.9, {}, kRoom_K}});
        moment.time_s = 1.0 + 2.0 * static_cast<double>(k);
        camera.observe(moment);
        moment.time_s += 1.0; // the first is old enough then
        camera.observe(moment);
        views.push_back({camera.newest().value()->frame.picture, rig.robot[k]});
    }
    return views;
}

Result<SilhouettePose> found(const Rig& rig, const ShareDone& done = {}) {
    return silhouettePose(rig.config.camera, viewsOf(rig), rig.scene(), rig.start, {}, done);
}

/// Largest distance between where an object is and where the found pose has it.
double errorAtObjects_m(const Rig& rig, const Pose& X_RC) {
    double worst = 0.0;
    for (const Pose& X_RE : rig.robot)
        for (const auto& object : rig.config.objects) {
            const Eigen::Vector3d p_R = X_RE * object.X_EO.translation();
            worst = std::max(worst, (rig.config.X_RC.inverse() * p_R - X_RC.inverse() * p_R).norm());
        }
    return worst;
}

double mahalanobis(const SilhouettePose& pose, const Pose& truth) {
    const Vector6d d = displacementBetween(pose.X_RC, truth);
    return d.dot(pose.covariance.ldlt().solve(d));
}

// Of six degrees of freedom: the median of chi-square is 5.35, its 99.73 % (3 sigma) 20.1.
TEST(SilhouettePose, IsWhereItsCovarianceSaysInRandomScenes) {
    constexpr std::uint64_t kScenes = 32;
    std::vector<double> distances, errors_m, stated_m;
    for (std::uint64_t seed = 1; seed <= kScenes; ++seed) {
        const Rig rig = randomRig(seed);
        test::ToldShares shares;
        const auto pose = found(rig, shares.told());
        ASSERT_TRUE(pose) << "scene " << seed << ": " << describe(pose.error());
        shares.expectAWhole(10);
        distances.push_back(mahalanobis(*pose, rig.config.X_RC));
        errors_m.push_back(errorAtObjects_m(rig, pose->X_RC));
        stated_m.push_back(pose->atObjects.position_m);
        EXPECT_LT(distances.back(), 20.1) << "scene " << seed;
        EXPECT_LT(errors_m.back(), 1e-3) << "scene " << seed;
        EXPECT_EQ(judged(*pose).verdict, Verdict::Good) << "scene " << seed;
        EXPECT_LT(pose->rms_px, 0.05);
        EXPECT_NEAR(pose->blur_px, rig.config.errors.blur_px, 0.06);
    }
    std::ranges::sort(distances);
    std::ranges::sort(errors_m);
    std::ranges::sort(stated_m);
    RecordProperty("median_chi_square", std::to_string(distances[kScenes / 2]));
    RecordProperty("largest_chi_square", std::to_string(distances.back()));
    RecordProperty("median_error_mm", std::to_string(1e3 * errors_m[kScenes / 2]));
    RecordProperty("largest_error_mm", std::to_string(1e3 * errors_m.back()));
    RecordProperty("median_two_sigma_mm", std::to_string(1e3 * stated_m[kScenes / 2]));
    EXPECT_GT(distances[kScenes / 2], 2.5);
    EXPECT_LT(distances[kScenes / 2], 7.0);
}

// Each reported pose of the robot is off by 0.3 mm and 0.03 degrees for each axis.
TEST(SilhouettePose, CountsTheRobotsOwnErrors) {
    constexpr std::uint64_t kScenes = 12;
    std::vector<double> distances, robot_m;
    for (std::uint64_t seed = 101; seed < 101 + kScenes; ++seed) {
        const Rig rig = randomRig(seed);
        std::vector<SilhouetteView> views = viewsOf(rig);
        Random random(seed);
        for (SilhouetteView& view : views) {
            Vector6d off;
            for (int i = 0; i < 6; ++i)
                off[i] = random.normal() * (i < 3 ? 3e-4 : radFromDeg(0.03));
            view.X_RE = displaced(view.X_RE, off);
        }
        const auto pose = silhouettePose(rig.config.camera, views, rig.scene(), rig.start);
        ASSERT_TRUE(pose) << "scene " << seed << ": " << describe(pose.error());
        distances.push_back(mahalanobis(*pose, rig.config.X_RC));
        robot_m.push_back(pose->robot_m);
        EXPECT_LT(distances.back(), 25.0) << "scene " << seed;
        EXPECT_LT(errorAtObjects_m(rig, pose->X_RC), 2e-3) << "scene " << seed;
    }
    std::ranges::sort(distances);
    std::ranges::sort(robot_m);
    RecordProperty("median_chi_square", std::to_string(distances[kScenes / 2]));
    RecordProperty("largest_chi_square", std::to_string(distances.back()));
    RecordProperty("median_robot_mm", std::to_string(1e3 * robot_m[kScenes / 2]));
    EXPECT_LT(distances[kScenes / 2], 9.0);
    EXPECT_NEAR(robot_m[kScenes / 2], 3e-4, 1.5e-4);
}

TEST(SilhouettePose, WorksWithDeadPixels) {
    const Rig rig = randomRig(2);
    std::vector<SilhouetteView> views = viewsOf(rig);
    Random random(1);
    for (SilhouetteView& view : views)
        for (double& T_K : view.picture.T_K)
            if (random.between(0.0, 1.0) < 0.01)
                T_K = random.whole(0, 1) == 0 ? std::numeric_limits<double>::quiet_NaN()
                                              : std::numeric_limits<double>::infinity();
    const auto pose = silhouettePose(rig.config.camera, views, rig.scene(), rig.start);
    ASSERT_TRUE(pose) << describe(pose.error());
    EXPECT_LT(errorAtObjects_m(rig, pose->X_RC), 2e-4);
}

TEST(SilhouettePose, TellsHowManyPointsItUsedWhere) {
    const Rig rig = randomRig(3);
    const auto pose = found(rig);
    ASSERT_TRUE(pose);
    ASSERT_EQ(pose->points.size(), rig.robot.size());
    int sum = 0;
    for (const std::vector<int>& ofView : pose->points) {
        ASSERT_EQ(ofView.size(), rig.config.objects.size());
        for (const int points : ofView)
            sum += points;
    }
    EXPECT_GT(pose->effectivePoints, 50.0);
    EXPECT_LE(pose->effectivePoints, sum + 1e-9);
    EXPECT_GT(pose->foundShare, 0.8);
    EXPECT_LE(pose->across_m, pose->atObjects.position_m);
}

TEST(SilhouettePose, WarnsOfPosesThatTellLittle) {
    Rig rig = randomRig(4);
    for (std::size_t k = 0; k < rig.robot.size(); ++k)
        rig.robot[k] =
            poseFromRotationVector({0.02 * static_cast<double>(k) - 0.04, 0.0, 0.15}, {0.0, 0.0, 0.0});
    rig.config.X_RC = lookingAt({0.0, 0.0, 0.9}, {0.0, 0.0, 0.15});
    rig.start = rig.config.X_RC;
    const auto codes = [&] {
        std::vector<MessageCode> out;
        const auto pose = found(rig);
        EXPECT_TRUE(pose) << describe(pose.error());
        if (pose)
            for (const Message& remark : pose->remarks)
                out.push_back(remark.code);
        return out;
    };
    EXPECT_EQ(codes(), (std::vector{MessageCode::SilhouettePosesInLine, MessageCode::SilhouetteDepthAlike}));
    rig.robot.resize(3);
    EXPECT_EQ(codes().front(), MessageCode::SilhouettePosesFew);
}

TEST(SilhouettePose, RefusesTooFewPoses) {
    Rig rig = randomRig(5);
    rig.robot.resize(1);
    const auto pose = found(rig);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code(), MessageCode::SilhouetteViewsFew);
}

TEST(SilhouettePose, RefusesPicturesWithoutSilhouettes) {
    Rig rig = randomRig(6);
    rig.objects_K.assign(3, kRoom_K); // as is the source
    rig.source_K = kRoom_K;
    const auto pose = found(rig);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code(), MessageCode::SilhouetteNoContrast) << describe(pose.error());
}

TEST(SilhouettePose, RefusesAStartThatSeesNoObject) {
    Rig rig = randomRig(7);
    rig.start = lookingAt({1.0, 0.0, 0.5}, {2.0, 0.0, 0.5});
    const auto pose = found(rig);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code(), MessageCode::SilhouetteOutside);
}

TEST(SilhouettePose, RefusesPicturesOfAnotherCamera) {
    const Rig rig = randomRig(8);
    std::vector<SilhouetteView> views = viewsOf(rig);
    views[1].picture = {80, 60, std::vector<double>(4800, 300.0)};
    const auto other = silhouettePose(rig.config.camera, views, rig.scene(), rig.start);
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code(), MessageCode::CameraSizeOther);
    EXPECT_EQ(other.error().where, "picture 2");
    views[1] = views[0];
    std::ranges::fill(views[1].picture.T_K, 300.0);
    const auto shut = silhouettePose(rig.config.camera, views, rig.scene(), rig.start);
    ASSERT_FALSE(shut);
    EXPECT_EQ(shut.error().code(), MessageCode::ThermalPictureConstant);
}

TEST(SilhouettePose, RefusesAMirroredScene) {
    const Rig rig = randomRig(9);
    SilhouetteScene scene = rig.scene();
    for (MountedPlate& object : scene.objects) { // as seen in a mirror
        object.shape = mirrored(object.shape);
        object.X_EO = poseFromRotationVector(
            {-object.X_EO.translation().x(), object.X_EO.translation().y() + 0.02, 0.0}, {0.0, 0.0, 0.5});
    }
    const auto pose = silhouettePose(rig.config.camera, viewsOf(rig), scene, rig.start);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code(), MessageCode::SilhouetteContradicts) << describe(pose.error());
}

TEST(SilhouettePose, RefusesBrokenContracts) {
    const Rig rig = randomRig(10);
    const auto views = viewsOf(rig);
    SilhouetteScene none = rig.scene();
    none.objects.clear();
    EXPECT_THROW((void)silhouettePose(rig.config.camera, views, none, rig.start), std::invalid_argument);
    Pose broken = rig.start;
    broken.translation().x() = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW((void)silhouettePose(rig.config.camera, views, rig.scene(), broken), std::invalid_argument);
    CameraModel camera = rig.config.camera;
    camera.fx = 0.0;
    EXPECT_THROW((void)silhouettePose(camera, views, rig.scene(), rig.start), std::invalid_argument);
}

// A disk that moves in its own plane, from so far away that the picture is nearly a parallel projection: the
// camera looks down from one side, or as much from the other.
TEST(SilhouettePose, RefusesTwoPosesThatLookAlike) {
    constexpr double kTilt_rad = 0.2, kFar_m = 8.0;
    Rig rig = randomRig(11);
    SimulatedThermalCameraConfig& config = rig.config;
    config.camera = usualThermalLens(config.profile);
    config.camera.fx = config.camera.fy = 12.0 * config.camera.fx;
    config.X_RC =
        lookingAt({kFar_m * std::sin(kTilt_rad), 0.0, kFar_m * std::cos(kTilt_rad)}, Eigen::Vector3d::Zero());
    config.source.clear();
    config.objects = {{Disk{0.03}, Pose::Identity()}};
    rig.objects_K = {310.0};
    rig.robot.clear();
    for (int k = 0; k < 4; ++k)
        rig.robot.push_back(poseFromRotationVector({0.02 * k - 0.03, 0.03 * (k % 2), 0.0}, {0.0, 0.0, 0.0}));
    SilhouetteOptions options;
    options.start.angle_rad = 1.2 * kTilt_rad;
    const auto pose = silhouettePose(config.camera, viewsOf(rig), rig.scene(), config.X_RC, options);
    ASSERT_FALSE(pose);
    EXPECT_EQ(pose.error().code(), MessageCode::SilhouetteAmbiguous) << describe(pose.error());
}

} // namespace
} // namespace bask
