// Polygons are painted by the area that they cover of each pixel, to the last digit, wherever they lie.

#include "engine/simulation/area_paint.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

namespace bask {
namespace {

GreyCanvas blank(int width, int height) {
    return {width, height, std::vector<float>(static_cast<std::size_t>(width * height), 0.0F)};
}

double sumOf(const GreyCanvas& canvas) {
    return std::accumulate(canvas.values.begin(), canvas.values.end(), 0.0);
}

Ring rectangle(double left, double top, double right, double bottom) {
    return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

double areaOf(const Ring& ring) {
    double area = 0.0;
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Eigen::Vector2d &a = ring[k], &b = ring[(k + 1) % ring.size()];
        area += 0.5 * (a.x() * b.y() - a.y() * b.x());
    }
    return std::abs(area);
}

// Catches: pixel centres at halves, columns and rows exchanged.
TEST(AreaPaint, APixelTakesTheShareThatIsCovered) {
    GreyCanvas canvas = blank(6, 5);
    const std::vector<Ring> rings{rectangle(1.0, 1.5, 3.75, 2.5)}; // row 2, from the middle of column 1
    AreaPainter().paint(canvas, rings, 100.0F);
    const std::vector<float> row(canvas.values.begin() + 12, canvas.values.begin() + 18);
    for (const auto& [column, grey] :
         {std::pair(0, 0.0F), {1, 50.0F}, {2, 100.0F}, {3, 100.0F}, {4, 25.0F}, {5, 0.0F}})
        EXPECT_NEAR(row[static_cast<std::size_t>(column)], grey, 1e-4F) << column;
    EXPECT_NEAR(sumOf(canvas), 275.0, 1e-3) << "other rows stay as they are";
}

// Catches: an edge of some slope that is counted in the wrong column, a triangle that loses area or shifts.
TEST(AreaPaint, AreaAndMiddleOfAnyTriangleAreKept) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0.0, 39.0);
    for (int trial = 0; trial < 300; ++trial) {
        Ring ring(3);
        for (Eigen::Vector2d& p : ring)
            p = {anywhere(random), anywhere(random)};
        GreyCanvas canvas = blank(40, 40);
        AreaPainter().paint(canvas, std::vector<Ring>{ring}, 1.0F);
        const double area = areaOf(ring);
        ASSERT_NEAR(sumOf(canvas), area, 1e-3);
        Eigen::Vector2d middle = Eigen::Vector2d::Zero();
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 40; ++x)
                middle += canvas.values[static_cast<std::size_t>(40 * y + x)] * Eigen::Vector2d(x, y);
        // A pixel's share counts at its centre, hence as much as half a pixel at the edges of small ones.
        if (area > 50.0) {
            ASSERT_LT((middle / area - (ring[0] + ring[1] + ring[2]) / 3.0).norm(), 0.02);
        }
    }
}

// Catches: seams between cells of one marker, holes that are filled, a disk of wrong size.
TEST(AreaPaint, NeighboursHaveNoSeamAndHolesStayOpen) {
    GreyCanvas canvas = blank(30, 30);
    const std::vector<Ring> cells{rectangle(3.0, 3.0, 10.3, 20.0), rectangle(10.3, 3.0, 20.0, 20.0)};
    AreaPainter().paint(canvas, cells, 255.0F);
    EXPECT_NEAR(canvas.values[10 * 30 + 10], 255.0F, 1e-3F);
    Ring disk, hole;
    for (int k = 0; k < 400; ++k) {
        const double phi = 2.0 * std::numbers::pi * k / 400;
        disk.emplace_back(15.2 + 12.0 * std::cos(phi), 14.7 + 12.0 * std::sin(phi));
        hole.emplace_back(15.2 + 5.0 * std::cos(phi), 14.7 - 5.0 * std::sin(phi));
    }
    canvas = blank(30, 30);
    AreaPainter().paint(canvas, std::vector<Ring>{disk, hole}, 1.0F);
    EXPECT_NEAR(sumOf(canvas), std::numbers::pi * (144.0 - 25.0), 0.05);
    EXPECT_NEAR(canvas.values[15 * 30 + 15], 0.0F, 1e-4F);
}

// Catches: writing outside of the picture, and a shape cut by its border that is lost or spills over.
TEST(AreaPaint, WhatIsOutsideIsCutOff) {
    for (const Ring& ring :
         {rectangle(-1e4, -1e4, 1e4, 1e4), rectangle(-7.0, -3.0, 4.5, 40.0), rectangle(2.5, 1.5, 1e6, 7.5),
          rectangle(-9, -9, -8, -8), rectangle(30, 2, 40, 5),
          Ring{{-20.0, 5.0}, {5.0, -20.0}, {30.0, 5.0}, {5.0, 30.0}}}) {
        Eigen::AlignedBox2d all(Eigen::Vector2d(-0.5, -0.5), Eigen::Vector2d(9.5, 9.5)), box;
        for (const Eigen::Vector2d& p : ring)
            box.extend(p);
        const Eigen::AlignedBox2d common = all.intersection(box);
        GreyCanvas canvas = blank(10, 10);
        AreaPainter().paint(canvas, std::vector<Ring>{ring}, 1.0F);
        EXPECT_NEAR(sumOf(canvas), common.isEmpty() ? 0.0 : common.volume(), 1e-3);
    }
    GreyCanvas one = blank(1, 1);
    AreaPainter().paint(one, std::vector<Ring>{rectangle(-0.5, -0.5, 0.0, 0.5), {}}, 1.0F);
    EXPECT_NEAR(one.values[0], 0.5F, 1e-6F);
}

} // namespace
} // namespace bask
