#pragma once
// Outlines and files that several tests of engine/shape share.

#include "engine/shape/contour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

namespace bask::test {

using Points = std::vector<Eigen::Vector2d>;

inline std::string dataPath(const std::string& name) {
    return BASK_TEST_DATA "/contours/" + name;
}
inline std::string examplePath(const std::string& name) {
    return BASK_EXAMPLES "/contours/" + name;
}

/// A file of its own for the running test.
inline std::string writeFile(const std::string& ending, const std::string& bytes) {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string path = testing::TempDir() + "bask_" + info->test_suite_name() + "_" + info->name() + ending;
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

inline Points ellipse(double a, double b, int n, Eigen::Vector2d centre = Eigen::Vector2d::Zero()) {
    Points points;
    for (int k = 0; k < n; ++k) {
        const double t = 2.0 * std::numbers::pi * k / n;
        points.emplace_back(centre.x() + a * std::cos(t), centre.y() + b * std::sin(t));
    }
    return points;
}

/// A wavy ring of `n` points, r = 1 + 0.3 cos(k phi): simple, and far from convex.
inline Points wavy(int n, int waves) {
    Points points;
    for (int k = 0; k < n; ++k) {
        const double t = 2.0 * std::numbers::pi * k / n, r = 1.0 + 0.3 * std::cos(waves * t);
        points.emplace_back(r * std::cos(t), r * std::sin(t));
    }
    return points;
}

} // namespace bask::test
