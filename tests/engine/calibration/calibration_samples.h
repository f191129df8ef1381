#pragma once
// Pictures, boards and cameras that several tests of engine/calibration share.

#include "engine/base/pose.h"
#include "engine/calibration/board.h"
#include "engine/calibration/camera_model.h"
#include "engine/shape/contour_import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace bask::test {

inline std::string markersPath(const std::string& name) {
    return BASK_TEST_DATA "/markers/" + name;
}
inline std::string viewPath(const std::string& name) {
    return BASK_TEST_DATA "/calibration/" + name;
}
inline std::vector<std::string> chessboardViews() {
    std::vector<std::string> paths;
    for (const char* number : {"01", "02", "03", "04", "05", "06", "07", "08", "09", "11", "12", "13", "14"})
        paths.push_back(viewPath(std::string("left") + number + ".jpg"));
    return paths;
}
inline std::vector<std::string> charucoViews() {
    return {viewPath("img_00.jpg"), viewPath("img_01.jpg"), viewPath("img_02.jpg"), viewPath("img_03.jpg")};
}

inline std::string textOf(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

inline GreyPicture greyOf(const std::string& path) {
    auto picture = readGreyPicture(path);
    EXPECT_TRUE(picture) << path;
    return picture ? *picture : GreyPicture();
}

inline GreyPicture flat(int width, int height, std::uint8_t value) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height), value)};
}

inline GreyPicture noise(int width, int height) {
    GreyPicture picture = flat(width, height, 0);
    std::mt19937 random(1);
    for (std::uint8_t& value : picture.values)
        value = static_cast<std::uint8_t>(random() % 256);
    return picture;
}

inline CameraModel sampleCamera() {
    CameraModel camera;
    camera.width = 1280;
    camera.height = 720;
    camera.fx = 1000.0;
    camera.fy = 1003.0;
    camera.cx = 630.0;
    camera.cy = 365.0;
    camera.distortion = {-0.21, 0.08, 0.0011, -0.0007, -0.02};
    return camera;
}

/// Where a camera shows a point (camera axes), by the formula of camera_model.h.
inline Eigen::Vector2d shown(const CameraModel& camera, const Eigen::Vector3d& point) {
    const double x = point.x() / point.z(), y = point.y() / point.z(), r2 = x * x + y * y;
    std::vector<double> k = camera.distortion;
    k.resize(8, 0.0);
    const double g =
        (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    return {camera.fx * (g * x + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x)) + camera.cx,
            camera.fy * (g * y + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y) + camera.cy};
}

/// A board or marker as drawn, on white, seen in a camera without distortion; `X_CB` as the pattern's upper
/// left corner, x right, y down. Each pixel is the mean of 3 x 3 samples.
inline GreyPicture pictureOf(const std::vector<DarkSquare>& squares, const Pose& X_CB,
                             const CameraModel& camera) {
    GreyPicture picture = flat(camera.width, camera.height, 0);
    Eigen::Matrix3d K;
    K << camera.fx, 0, camera.cx, 0, camera.fy, camera.cy, 0, 0, 1;
    Eigen::Matrix3d toPicture;
    toPicture << X_CB.linear().col(0), X_CB.linear().col(1), X_CB.translation();
    const Eigen::Matrix3d toPlane = (K * toPicture).inverse();
    const auto isDark = [&](const Eigen::Vector2d& p) {
        for (const DarkSquare& s : squares)
            if (p.x() >= s.corner_m.x() && p.y() >= s.corner_m.y() && p.x() < s.corner_m.x() + s.side_m &&
                p.y() < s.corner_m.y() + s.side_m)
                return true;
        return false;
    };
    for (int v = 0; v < picture.height; ++v)
        for (int u = 0; u < picture.width; ++u) {
            int sum = 0;
            for (int k = 0; k < 9; ++k)
                sum += isDark((toPlane * Eigen::Vector3d(u + (k % 3 - 1) / 3.0, v + (k / 3 - 1) / 3.0, 1))
                                  .hnormalized())
                           ? 20
                           : 235;
            picture.values[static_cast<std::size_t>(v * picture.width + u)] =
                static_cast<std::uint8_t>(sum / 9);
        }
    return picture;
}

inline CameraModel smallCamera() {
    CameraModel camera;
    camera.width = 640;
    camera.height = 480;
    camera.fx = camera.fy = 500.0;
    camera.cx = 319.5;
    camera.cy = 239.5;
    camera.distortion = {0, 0, 0, 0, 0};
    return camera;
}

} // namespace bask::test
