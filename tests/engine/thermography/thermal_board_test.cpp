// Boards in pictures of few pixels, where warm may be bright or dark.

#include "engine/thermography/thermal_board.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/calibration_samples.h"

#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kFactor = 3;
const Board kBoard = parseBoard("chessboard:9x6:0.025").value();

/// A photograph of a board as a camera of a third of its pixels would see it, warm where it is bright or
/// where it is dark.
ThermalPicture warmed(const GreyPicture& photo, bool isBrightWarm) {
    const auto at = [&](int column, int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(photo.width) +
               static_cast<std::size_t>(column);
    };
    ThermalPicture picture{photo.width / kFactor, photo.height / kFactor, {}};
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            double sum = 0.0;
            for (int dy = 0; dy < kFactor; ++dy)
                for (int dx = 0; dx < kFactor; ++dx)
                    sum += photo.values[at(x * kFactor + dx, y * kFactor + dy)];
            const double grey = sum / (255.0 * kFactor * kFactor);
            picture.T_K.push_back(300.0 + 8.0 * (isBrightWarm ? grey : 1.0 - grey));
        }
    return picture;
}

} // namespace

// Catches: a board that is lost in a small picture or in the sense of its contrast, and corners half a pixel
// off by the enlargement.
TEST(ThermalBoard, IsFoundInEitherContrastWhereTheLargePictureHasIt) {
    int found = 0, of = 0;
    for (const std::string& path : test::chessboardViews()) {
        const GreyPicture photo = test::greyOf(path);
        const auto large = findBoard(photo, kBoard, path);
        ASSERT_TRUE(large);
        for (const bool isBrightWarm : {true, false}) {
            ++of;
            const ThermalBoard board =
                findThermalBoard(greyPicture(warmed(photo, isBrightWarm)), kBoard, path);
            if (!board.view)
                continue;
            ++found;
            EXPECT_EQ(board.seen, kBoard);
            double sum2 = 0.0;
            // A chessboard is the same turned by half a turn: take the nearer end.
            const auto& corners = board.view->corners_px;
            const auto inSmall = [&](std::size_t k) {
                return Eigen::Vector2d((large->corners_px[k].array() + 0.5) / kFactor - 0.5);
            };
            const bool isTurned =
                (corners.front() - inSmall(0)).norm() > (corners.back() - inSmall(0)).norm();
            for (std::size_t k = 0; k < corners.size(); ++k)
                sum2 += (corners[isTurned ? corners.size() - 1 - k : k] - inSmall(k)).squaredNorm();
            EXPECT_LT(std::sqrt(sum2 / static_cast<double>(corners.size())), 0.15) << path << isBrightWarm;
        }
    }
    EXPECT_GE(found, of - 2) << "of " << of;
}

TEST(ThermalBoard, IsNotFoundWhereThereIsNone) {
    ThermalPicture picture{160, 120, std::vector<double>(160 * 120, 300.0)};
    for (std::size_t k = 0; k < picture.T_K.size(); ++k)
        picture.T_K[k] += 0.05 * std::sin(12.9898 * static_cast<double>(k)); // as noise
    const ThermalBoard board = findThermalBoard(greyPicture(picture), kBoard, "the camera");
    ASSERT_FALSE(board.view);
    EXPECT_EQ(board.view.error().code(), MessageCode::BoardNotSeen);
}

// Catches: a glowing spot or a dead pixel that takes the contrast from everything else.
TEST(GreyPictureOfATemperature, HasItsContrastWhereMostPixelsAre) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    ThermalPicture picture{20, 20, std::vector<double>(400, 300.0)};
    for (std::size_t k = 200; k < 400; ++k)
        picture.T_K[k] = 305.0;
    picture.T_K[0] = kInfinity;
    picture.T_K[1] = -kInfinity;
    picture.T_K[2] = std::nan("");
    picture.T_K[3] = 900.0;
    const GreyPicture grey = greyPicture(picture);
    EXPECT_EQ(grey.values[10], 0);
    EXPECT_EQ(grey.values[300], 255);
    EXPECT_EQ(grey.values[0], 255);
    EXPECT_EQ(grey.values[1], 0);
    EXPECT_EQ(grey.values[2], 128);
    EXPECT_EQ(grey.values[3], 255);
    picture.T_K.assign(400, kInfinity);
    EXPECT_EQ(greyPicture(picture).values[7], 255);
}

} // namespace bask
