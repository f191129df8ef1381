// What a simulated camera shows is measured by the real vision path: corners, poses, calibration.

#include "engine/simulation/simulated_camera.h"

#include "engine/base/message_code.h"
#include "engine/calibration/marker_pose.h"
#include "tests/engine/calibration/rig_scene.h"

#include <atomic>
#include <thread>

namespace bask {
namespace {

SceneMoment momentAt(double time_s, const Pose& X_RE = Pose(Eigen::Translation3d(0, 0, 0.2)),
                     const Pose& X_RS = Pose::Identity()) {
    return {time_s, X_RE, X_RS};
}

/// R's axes are the camera's: parts stand where they are seen.
SimulatedCameraConfig configOf(const test::RigScene& scene) {
    SimulatedCameraConfig config;
    config.camera = scene.camera;
    config.X_RC = Pose::Identity();
    config.markers = scene.layout;
    config.isWallLimited = false;
    return config;
}

SimulatedCameraConfig sharp(SimulatedCameraConfig config) {
    config.noise_grey = config.blur_px = config.lightFall = 0.0;
    return config;
}

/// Four markers round the usual source, three on the end-effector's top.
SimulatedCameraConfig usualRig() {
    SimulatedCameraConfig config;
    config.isWallLimited = false;
    config.markers.dictionary = {"4X4_50"};
    int id = 0;
    for (const auto& [x, y] : {std::pair(-0.12, 0.12), {0.12, 0.12}, {0.12, -0.12}, {-0.12, -0.12}})
        config.markers.markers.push_back({Part::Source, id++, 0.05, test::shifted(x, y)});
    for (const auto& [x, y] : {std::pair(-0.06, 0.04), {0.06, 0.04}, {0.0, -0.05}})
        config.markers.markers.push_back({Part::EndEffector, 6 + id++, 0.05, test::shifted(x, y, 0.03)});
    config.objects = {{Disk{0.03}, test::shifted(-0.06, 0.0)}, {Disk{0.03}, test::shifted(0.06, 0.0)}};
    return config;
}

/// The frame of a moment, without waiting for the delay.
std::shared_ptr<const CameraFrame> frameAt(SimulatedCamera& camera, double delay_s,
                                           const SceneMoment& moment) {
    camera.observe(moment);
    SceneMoment later = moment;
    later.time_s += delay_s;
    camera.observe(later);
    const auto frame = camera.newest();
    return frame ? *frame : nullptr;
}

std::vector<int> idsIn(const GreyPicture& picture, const MarkerDictionary& dictionary) {
    std::vector<int> ids;
    for (const FoundMarker& marker : findMarkers(picture, dictionary))
        ids.push_back(marker.id);
    std::ranges::sort(ids);
    return ids;
}

bool isWithin(const CameraModel& camera, const FoundMarker& marker) {
    constexpr double kMargin_px = 15.0; // of a card
    return std::ranges::all_of(marker.corners_px, [&](const Eigen::Vector2d& p) {
        return p.x() > kMargin_px && p.y() > kMargin_px && p.x() < camera.width - kMargin_px &&
               p.y() < camera.height - kMargin_px;
    });
}

struct CornerErrors {
    double squares = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double growth = 0.0; ///< away from the marker's middle
    int count = 0, missing = 0;

    double rms() const { return std::sqrt(squares / count); }
};

// Over scenes that are turned and moved anyhow; markers of 40 px and more.
CornerErrors cornerErrors(bool isSharp, int scenes) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    CornerErrors errors;
    for (int trial = 0; trial < scenes; ++trial) {
        test::RigScene scene;
        scene.layout.markers.pop_back(); // its card meets the others'
        const auto turn = [&] {
            return Eigen::Vector3d(0.45 * any(random), 0.45 * any(random), 3.0 * any(random));
        };
        scene.X_CS = test::facingCamera({-0.2 + 0.03 * any(random), 0.03 * any(random), 0.75}, turn());
        scene.X_CE = test::facingCamera({0.2, 0.05 * any(random), 0.5 + 0.1 * any(random)}, turn());
        const auto config = isSharp ? sharp(configOf(scene)) : configOf(scene);
        SimulatedCamera camera(config);
        const auto frame = frameAt(camera, config.delay_s, {1.0, scene.X_CE, scene.X_CS});
        const auto found = findMarkers(frame->picture, scene.layout.dictionary);
        for (const PlacedMarker& marker : scene.layout.markers) {
            FoundMarker truth{marker.id, {}};
            for (std::size_t k = 0; k < 4; ++k)
                truth.corners_px[k] =
                    test::shown(scene.camera, (marker.part == Part::Source ? scene.X_CS : scene.X_CE) *
                                                  marker.corners()[k]);
            if (truth.side_px() < 40.0 || !isWithin(scene.camera, truth))
                continue;
            const auto seen = std::ranges::find(found, marker.id, &FoundMarker::id);
            if (seen == found.end()) {
                ++errors.missing;
                continue;
            }
            const Eigen::Vector2d middle = 0.25 * (truth.corners_px[0] + truth.corners_px[1] +
                                                   truth.corners_px[2] + truth.corners_px[3]);
            for (std::size_t k = 0; k < 4; ++k) {
                const Eigen::Vector2d error = seen->corners_px[k] - truth.corners_px[k];
                errors.squares += error.squaredNorm();
                errors.sum += error;
                errors.growth += error.dot((truth.corners_px[k] - middle).normalized());
                ++errors.count;
            }
        }
    }
    return errors;
}

// Catches: pixel centres at halves, edges that are jagged or grown, distortion that is drawn in pieces too
// long, noise or blur out of proportion.
TEST(SimulatedCamera, CornersAreWhereTheLensShowsThem) {
    const CornerErrors clean = cornerErrors(true, 25), noisy = cornerErrors(false, 25);
    EXPECT_GT(clean.count, 400);
    EXPECT_EQ(clean.missing + noisy.missing, 0);
    EXPECT_LT(clean.rms(), 0.1);
    EXPECT_LT((clean.sum / clean.count).norm(), 0.02);
    EXPECT_LT(std::abs(clean.growth / clean.count), 0.05);
    EXPECT_LT(noisy.rms(), 0.3);
    EXPECT_LT((noisy.sum / noisy.count).norm(), 0.02);
}

// Catches: a scene that is not the one asked for, to the millimetre: 30 frames, four markers of 50 mm and
// three.
TEST(SimulatedCamera, PosesAreRecovered) {
    for (int k = 0; k < 4; ++k) {
        test::RigScene scene;
        scene.X_CS = scene.X_CS * poseFromRotationVector({0, 0, 0}, {0.0, 0.0, 0.4 * k});
        scene.X_CE = scene.X_CE * poseFromRotationVector({0, 0, 0}, {0.05 * k, 0.0, -0.3 * k});
        const SimulatedCameraConfig config = configOf(scene);
        SimulatedCamera camera(config);
        std::vector<MarkerFrame> frames;
        for (int i = 0; i < 30; ++i)
            frames.push_back(
                findMarkers(frameAt(camera, config.delay_s, {1.0 + i, scene.X_CE, scene.X_CS})->picture,
                            scene.layout.dictionary));
        const auto pose = relativePose(frames, scene.layout, Part::Source, Part::EndEffector, scene.camera);
        ASSERT_TRUE(pose) << describe(pose.error());
        const Vector6d d = displacementBetween(pose->X_AB, scene.X_SE());
        EXPECT_LT(d.head<3>().norm(), std::min(1e-3, pose->spread.position_m)) << k;
        EXPECT_LT(d.tail<3>().norm(), std::min(radFromDeg(0.3), pose->spread.angle_rad)) << k;
        EXPECT_EQ(judged(*pose).verdict, Verdict::Good) << k;
        EXPECT_TRUE(pose->a.remarks.empty() && pose->b.remarks.empty()) << k;
    }
}

// Catches: a marker whose own axes are drawn turned or mirrored, which several together would hide.
TEST(SimulatedCamera, EveryMarkerByItselfTellsItsPose) {
    const test::RigScene scene;
    const SimulatedCameraConfig config = configOf(scene);
    SimulatedCamera camera(config);
    const auto found = findMarkers(frameAt(camera, config.delay_s, {1.0, scene.X_CE, scene.X_CS})->picture,
                                   scene.layout.dictionary);
    ASSERT_EQ(found.size(), scene.layout.markers.size());
    for (const FoundMarker& marker : found) {
        const PlacedMarker& placed = *std::ranges::find(scene.layout.markers, marker.id, &PlacedMarker::id);
        const auto poses = markerPoses(marker.corners_px, placed.side_m, scene.camera);
        ASSERT_TRUE(poses) << marker.id;
        const Vector6d d = displacementBetween(
            poses->best.X_CM(), (placed.part == Part::Source ? scene.X_CS : scene.X_CE) * placed.X_PM);
        EXPECT_LT(d.head<3>().norm(), 1e-3) << marker.id;
        EXPECT_LT(degFromRad(d.tail<3>().norm()), 0.3) << marker.id;
    }
}

// Catches: a usual camera that does not see what it is meant to see: three of the source's
// markers and all of the end-effector's, wherever that is above it from 5 to 25 cm.
TEST(SimulatedCamera, TheUsualCameraSeesSourceAndEndEffectorAtOnce) {
    const SimulatedCameraConfig config = usualRig();
    SimulatedCamera camera(config);
    double time_s = 0.0;
    for (const double z : {0.05, 0.1, 0.15, 0.2, 0.25})
        for (const double x : {-0.08, 0.0, 0.08})
            for (const double y : {-0.08, 0.0, 0.08}) {
                const auto frame =
                    frameAt(camera, config.delay_s, momentAt(time_s += 1.0, test::shifted(x, y, z)));
                const std::vector<int> ids = idsIn(frame->picture, config.markers.dictionary);
                const auto ofSource = std::ranges::count_if(ids, [](int id) { return id < 10; });
                EXPECT_GE(ofSource, 3) << x << ' ' << y << ' ' << z << ": " << idsText(ids);
                EXPECT_EQ(ids.size() - static_cast<std::size_t>(ofSource), 3U) << x << ' ' << y << ' ' << z;
            }
}

// Catches: a frame older or newer than it says, steps instead of a motion, a delay that is not kept.
TEST(SimulatedCamera, AFrameShowsTheMomentThatItIsStampedWith) {
    SimulatedCameraConfig config = sharp(usualRig());
    config.delay_s = 0.05;
    SimulatedCamera camera(config), still(config);
    for (int k = 0; k <= 20; ++k)
        camera.observe(momentAt(0.1 * k, test::shifted(0.01 * k, 0.0, 0.2)));
    const auto moving = camera.newest();
    ASSERT_TRUE(moving);
    EXPECT_NEAR((*moving)->time_s, 1.95, 1e-9);
    const auto same = frameAt(still, config.delay_s, momentAt(1.95, test::shifted(0.195, 0.0, 0.2)));
    EXPECT_EQ((*moving)->picture.values, same->picture.values);
    const double age_s = SteadyClock().now_s() - (*moving)->caught_s;
    EXPECT_GE(age_s, config.delay_s);
    EXPECT_LT(age_s, 10.0);
}

// Catches: frames more often than the camera gives them, or none when its clock runs; a run that begins anew
// at zero and shows nothing.
TEST(SimulatedCamera, FramesComeAtTheirRate) {
    const SimulatedCameraConfig config = usualRig();
    SimulatedCamera camera(config);
    int frames = 0;
    std::shared_ptr<const CameraFrame> last;
    for (int k = 0; k < 100; ++k) { // a second
        camera.observe(momentAt(0.01 * k));
        const auto frame = camera.newest();
        ASSERT_TRUE(frame);
        if (*frame != last) {
            EXPECT_TRUE(!last || (*frame)->number > last->number);
            ++frames;
        }
        last = *frame;
        EXPECT_EQ(*camera.newest(), last) << "nothing newer";
    }
    EXPECT_GE(frames, 24); // every fourth of 100
    EXPECT_LE(frames, 30);
    camera.observe(momentAt(0.0));
    EXPECT_LT((*camera.newest())->time_s, 0.0);
    SimulatedCameraConfig limited = config;
    limited.isWallLimited = true;
    limited.frameRate_Hz = 1e-3;
    SimulatedCamera slow(limited);
    slow.observe(momentAt(0.0));
    const auto first = *slow.newest();
    slow.observe(momentAt(5000.0));
    EXPECT_EQ(*slow.newest(), first);
}

// Catches: noise that is the same in every frame or another in every run, or of another size.
TEST(SimulatedCamera, NoiseDiffersFromFrameToFrameAndIsTheSameInEveryRun) {
    const SimulatedCameraConfig config = usualRig();
    SimulatedCamera camera(config), again(config);
    const auto first = frameAt(camera, config.delay_s, momentAt(1.0)),
               second = frameAt(camera, config.delay_s, momentAt(2.0));
    EXPECT_EQ(first->picture.values, frameAt(again, config.delay_s, momentAt(1.0))->picture.values);
    double squares = 0.0;
    for (std::size_t k = 0; k < first->picture.values.size(); ++k)
        squares += std::pow(first->picture.values[k] - second->picture.values[k], 2);
    const double deviation = std::sqrt(squares / 2.0 / static_cast<double>(first->picture.values.size()));
    EXPECT_NEAR(deviation, config.noise_grey, 0.1);
}

// Catches: a hand, or a cable pulled out, that changes nothing, or for ever.
TEST(SimulatedCamera, CoveredAndUnpluggedShowNoMarkersUntilTheyAreOver) {
    const SimulatedCameraConfig config = usualRig();
    SimulatedCamera camera(config);
    EXPECT_EQ(camera.newest().error().code(), MessageCode::CameraLost);
    const auto ids = [&](double time_s) {
        return idsText(
            idsIn(frameAt(camera, config.delay_s, momentAt(time_s))->picture, config.markers.dictionary));
    };
    EXPECT_EQ(ids(1.0), "0, 1, 2, 3, 10, 11, 12");
    camera.setCovered(true);
    EXPECT_EQ(ids(2.0), "10, 11, 12");
    camera.setCovered(false);
    camera.setUnplugged(true);
    EXPECT_EQ(argTexts(camera.newest().error().message),
              (std::vector<std::string>{"simulated", "unplugged"}));
    camera.setUnplugged(false);
    EXPECT_EQ(ids(3.0), "0, 1, 2, 3, 10, 11, 12");
}

// Catches: a race or a deadlock between the engine that observes and the thread that renders.
TEST(SimulatedCamera, ObservingAndRenderingAreOfTwoThreads) {
    SimulatedCameraConfig config = usualRig();
    config.camera.width = 160;
    config.camera.height = 90;
    SimulatedCamera camera(config);
    camera.observe(momentAt(0.0));
    std::atomic<bool> isOver = false;
    std::thread engine([&] {
        for (int k = 1; k <= 2000; ++k) {
            camera.observe(momentAt(0.05 * k));
            camera.setCovered(k % 7 == 0);
            camera.setBoard(k % 5 == 0 ? std::optional(*parseBoard("chessboard:9x6:0.025")) : std::nullopt);
        }
        isOver = true;
    });
    std::uint64_t number = 0;
    while (!isOver) {
        const auto frame = camera.newest();
        ASSERT_TRUE(frame);
        EXPECT_GE((*frame)->number, number);
        number = (*frame)->number;
    }
    engine.join();
    EXPECT_NEAR((*camera.newest())->time_s, 100.0 - config.delay_s, 1e-9);
}

// Catches: a layout with an id that no dictionary has, or a camera without a size, taken up.
TEST(SimulatedCamera, RefusesWhatCannotBeDrawn) {
    SimulatedCameraConfig config = usualRig();
    config.markers.markers[0].id = 50;
    EXPECT_THROW(SimulatedCamera{config}, std::invalid_argument);
    config = usualRig();
    config.camera.width = 0;
    EXPECT_THROW(SimulatedCamera{config}, std::invalid_argument);
}

} // namespace
} // namespace bask
