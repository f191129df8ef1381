// Which silhouettes are found in a picture: several, with holes, by colour, turned by EXIF, and at the
// border.

#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"
#include "tests/engine/shape/picture_samples.h"

#include <cstring>

namespace bask {
namespace {

using Vec = Eigen::Vector2d;

bool inDisk(double x, double y, double cx, double cy, double r) {
    return std::hypot(x - cx, y - cy) < r;
}
cv::Vec3d grey(double value) {
    return cv::Vec3d::all(value);
}

Result<OutlineFile> read(const cv::Mat& image, const std::optional<PickedColour>& colour = {},
                         const char* ending = ".png") {
    ContourImportOptions options{.scale_px_per_mm = 1.0};
    options.colour = colour;
    return readOutlines(test::picture(image, ending), options);
}

double area_px(const FileOutline& outline) {
    return outline.area_m2() * 1e6;
}

// Catches: only the largest read, holes filled, an island in a hole lost or taken for a hole, dust read.
TEST(Silhouettes, SeveralWithHolesAndIslands) {
    const cv::Mat image = test::rendered({300, 200}, 4, [](double x, double y) {
        const bool ring = inDisk(x, y, 100, 100, 80) && !inDisk(x, y, 100, 100, 50);
        return grey(ring || inDisk(x, y, 105, 95, 25) || inDisk(x, y, 240, 60, 40) ||
                            inDisk(x, y, 240, 150, 3)
                        ? 0.2
                        : 0.9);
    });
    for (const cv::Mat& picture : {image, cv::Mat(cv::Scalar::all(255) - image)}) {
        const auto file = read(picture);
        ASSERT_TRUE(file) << describe(file.error());
        ASSERT_EQ(file->outlines.size(), 4U);
        const double radii[] = {80, 50, 40, 25};
        for (std::size_t k = 0; k < 4; ++k) {
            const double area = std::numbers::pi * radii[k] * radii[k];
            EXPECT_NEAR(area_px(file->outlines[k]), area, 5e-3 * area) << k;
            EXPECT_NEAR(file->outlines[k].perimeter_m() * 1e3, 2 * std::numbers::pi * radii[k],
                        0.01 * 2 * std::numbers::pi * radii[k]);
            EXPECT_EQ(file->outlines[k].hole, k == 1) << k;
            EXPECT_EQ(file->outlines[k].holeIn.has_value(), k == 1) << k;
        }
        const auto picked = pickOutline(*file, std::nullopt, "");
        ASSERT_TRUE(picked);
        ASSERT_EQ(picked->warnings.size(), 1U);
        ASSERT_EQ(picked->holes.size(), 1U);
        EXPECT_NEAR(contourArea(picked->holes[0]) * 1e6, std::numbers::pi * 50 * 50,
                    5e-3 * std::numbers::pi * 50 * 50);
        EXPECT_EQ(picked->warnings[0], (Message{MessageCode::OutlinesSeveral, {"3"}}));
        const auto island = pickOutline(*file, 3, "");
        ASSERT_TRUE(island);
        EXPECT_TRUE(island->warnings.empty()) << "it was asked for";
        EXPECT_TRUE(island->holes.empty());
        EXPECT_EQ(pickOutline(*file, 4, "").error().code(), MessageCode::OutlineUnknown);
    }
}

// Catches a cut silhouette among whole ones read as if it were whole.
TEST(Silhouettes, ThoseAtTheBorderAreCountedOff) {
    const auto at = [](double small) {
        return read(test::rendered({200, 120}, 3, [=](double x, double y) {
            return grey(inDisk(x, y, 80, 60, 40) || inDisk(x, y, 190, 60, small) ? 0.1 : 0.8);
        }));
    };
    const auto file = at(20);
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->outlines.size(), 1U);
    ASSERT_EQ(file->warnings.size(), 1U);
    EXPECT_EQ(file->warnings[0], (Message{MessageCode::SilhouettesAtBorder, {"1"}}));
    EXPECT_EQ(at(58).error().code(), MessageCode::SilhouetteAtBorder) << "the largest one is cut";
}

// A red disk on half dark blue, half light grey ground: brightness cannot tell it, its colour can.
cv::Mat colourful() {
    return test::rendered({240, 160}, 4, [](double x, double y) {
        if (inDisk(x, y, 120, 80, 50))
            return cv::Vec3d(0.15, 0.2, 0.8);
        return x < 120 ? cv::Vec3d(0.5, 0.25, 0.1) : grey(0.8);
    });
}

// Catches a colour compared in RGB's order, a tolerance left out, and a silhouette made of a colour not
// there.
TEST(Silhouettes, ByTheColourPicked) {
    const double area = std::numbers::pi * 50 * 50;
    const PickedColour red{{204, 51, 38}, {}};
    EXPECT_FALSE(read(colourful()));
    for (const auto& colour : {red, PickedColour{{190, 60, 50}, 40.0}})
        for (const bool is16 : {false, true}) {
            cv::Mat image = colourful();
            if (is16)
                image.convertTo(image, CV_16U, 257.0);
            const auto file = read(image, colour);
            ASSERT_TRUE(file) << describe(file.error());
            ASSERT_EQ(file->outlines.size(), 1U);
            EXPECT_NEAR(area_px(file->outlines[0]), area, 0.02 * area);
        }
    EXPECT_EQ(read(colourful(), PickedColour{{0, 255, 0}, {}}).error().code(), MessageCode::ColourUnclear);
    EXPECT_EQ(read(colourful(), PickedColour{{204, 51, 60}, 0.01}).error().code(), MessageCode::NoSilhouette)
        << "nothing is as exactly of that colour";
}

// Catches a colour that is lost in a ground of many colours, for which there is no split in two.
TEST(Silhouettes, ByTheColourPickedOnAMottledGround) {
    cv::Mat3b image(300, 300);
    cv::RNG random(3);
    for (int y = 0; y < 300; y += 20)
        for (int x = 0; x < 300; x += 20)
            image(cv::Rect(x, y, 20, 20))
                .setTo(cv::Scalar(random.uniform(0, 255), random.uniform(60, 255), random.uniform(0, 120)));
    cv::circle(image, {150, 150}, 50, cv::Scalar(38, 51, 204), cv::FILLED, cv::LINE_AA);
    const auto file = read(image, PickedColour{{204, 51, 38}, {}});
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_NEAR(area_px(file->outlines.at(0)), std::numbers::pi * 50 * 50, 0.03 * std::numbers::pi * 50 * 50);
}

// Catches a picked colour found where the picture is transparent.
TEST(Silhouettes, WhatIsTransparentHasNoColour) {
    cv::Mat image;
    cv::cvtColor(colourful(), image, cv::COLOR_BGR2BGRA);
    image.colRange(0, 120).setTo(cv::Scalar(38, 51, 204, 0));
    const auto file = read(image, PickedColour{{204, 51, 38}, {}});
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_NEAR(area_px(file->outlines.at(0)), 0.5 * std::numbers::pi * 50 * 50,
                0.03 * 0.5 * std::numbers::pi * 50 * 50);
}

// A JPEG with an EXIF block that says how the camera was held.
std::string withOrientation(std::string jpeg, char orientation) {
    const char block[] = "\xFF\xE1\x00\x22"
                         "Exif\0\0II*\0\x08\0\0\0"
                         "\x01\0\x12\x01\x03\0\x01\0\0\0"
                         "O\0\0\0\0\0\0\0";
    std::string exif(block, sizeof block - 1);
    exif[exif.rfind('O')] = orientation;
    return jpeg.substr(0, 2) + exif + jpeg.substr(2);
}

// Catches a photograph read as the sensor lay.
TEST(Silhouettes, ArePhotographsTurnedByExif) {
    const cv::Mat image = test::rendered({200, 120}, 3, [](double x, double y) {
        return grey(std::abs(x - 70) < 40 && std::abs(y - 60) < 20 ? 0.1 : 0.9);
    });
    const std::string jpeg = test::encoded(image, ".jpg");
    for (const auto& [orientation, width, height, x, y] :
         {std::tuple(1, 80.0, 40.0, 70.0, 60.0), std::tuple(6, 40.0, 80.0, 60.0, 130.0),
          std::tuple(3, 80.0, 40.0, 130.0, 60.0), std::tuple(8, 40.0, 80.0, 60.0, 70.0)}) {
        const auto contour =
            readContour(test::writeFile(".jpg", withOrientation(jpeg, static_cast<char>(orientation))),
                        {.scale_px_per_mm = 1.0});
        ASSERT_TRUE(contour) << orientation << describe(contour.error());
        Vec min = contour->points_m[0], max = min;
        for (const Vec& p : contour->points_m) {
            min = min.cwiseMin(p);
            max = max.cwiseMax(p);
        }
        EXPECT_NEAR((max - min).x() * 1e3, width, 0.8) << orientation;
        EXPECT_NEAR((max - min).y() * 1e3, height, 0.8) << orientation;
        EXPECT_NEAR(contourCentroid(*contour).x() * 1e3, x, 0.3) << orientation;
        EXPECT_NEAR(contourCentroid(*contour).y() * 1e3, y, 0.3) << orientation;
    }
}

// Catches pictures of texture given as hundreds of outlines.
TEST(Silhouettes, AreNotMoreThanAHundred) {
    const auto disks = [](int pitch) {
        return read(test::rendered({400, 400}, 2, [=](double x, double y) {
            const bool inFrame = x > 4 && y > 4 && x < 396 && y < 396;
            return grey(inFrame && inDisk(std::fmod(x - 4, pitch), std::fmod(y - 4, pitch), 0.5 * pitch,
                                          0.5 * pitch, 0.35 * pitch)
                            ? 0.1
                            : 0.9);
        }));
    };
    const auto few = disks(49), many = disks(28);
    ASSERT_TRUE(few) << describe(few.error());
    EXPECT_EQ(few->outlines.size(), 64U);
    EXPECT_EQ(many.error().code(), MessageCode::NoSilhouette);
}

} // namespace
} // namespace bask
