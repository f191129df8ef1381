#include "engine/base/message_code.h"
#include "engine/shape/dxf_outlines.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <numbers>
#include <random>
#include <sstream>

namespace bask {
namespace {

constexpr double kTolerance_m = 1e-5;

std::string dataPath(const std::string& name) {
    return BASK_TEST_DATA "/contours/dxf/" + name;
}

std::string bytesOf(const std::string& name) {
    std::ifstream in(dataPath(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

// Words as lines: "0 LINE 10 1.5" is two groups.
std::string lines(const std::string& words) {
    std::string text;
    std::istringstream in(words);
    for (std::string word; in >> word;)
        text += word + "\n";
    return text;
}

// A drawing in millimetres.
std::string drawing(const std::string& entities, const std::string& blocks = {},
                    const std::string& layers = {}) {
    return lines("0 SECTION 2 HEADER 9 $INSUNITS 70 4 0 ENDSEC 0 SECTION 2 TABLES 0 TABLE 2 LAYER " + layers +
                 " 0 ENDTAB 0 ENDSEC 0 SECTION 2 BLOCKS " + blocks + " 0 ENDSEC 0 SECTION 2 ENTITIES " +
                 entities + " 0 ENDSEC 0 EOF");
}

// Processor time, which a busy machine does not stretch.
double cpu_s(std::clock_t start) {
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Result<OutlineFile> read(const std::string& bytes) {
    return dxfOutlines(bytes, "drawing", kTolerance_m);
}

OutlineFile outlinesOf(const std::string& entities, const std::string& blocks = {},
                       const std::string& layers = {}) {
    auto file = read(drawing(entities, blocks, layers));
    EXPECT_TRUE(file.ok()) << (file ? "" : describe(file.error()));
    return file ? std::move(file).value() : OutlineFile{};
}

Eigen::AlignedBox2d boxOf_mm(const FileOutline& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline.points_m)
        box.extend(p * 1e3);
    return box;
}

// One closed outline of the area (mm2) and box (mm).
void expectOne(const OutlineFile& file, double area_mm2, double xmin, double ymin, double xmax, double ymax) {
    ASSERT_EQ(file.outlines.size(), 1u);
    ASSERT_TRUE(file.outlines[0].closed);
    EXPECT_NEAR(file.outlines[0].area_m2() * 1e6, area_mm2, 2e-3 * area_mm2);
    const Eigen::AlignedBox2d box = boxOf_mm(file.outlines[0]);
    const double slack = 2e-3 * std::max(xmax - xmin, ymax - ymin);
    EXPECT_NEAR(box.min().x(), xmin, slack);
    EXPECT_NEAR(box.min().y(), ymin, slack);
    EXPECT_NEAR(box.max().x(), xmax, slack);
    EXPECT_NEAR(box.max().y(), ymax, slack);
}

struct Expected {
    std::string file, unit, closed_outlines;
    std::size_t rank = 0;
    bool closed = true;
    double area = 0.0, perimeter = 0.0;
    std::vector<double> box; // empty where not known
};

std::vector<Expected> expectedOutlines() {
    std::vector<Expected> rows;
    std::ifstream in(dataPath("expected.csv"));
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#') || line.starts_with("file,"))
            continue;
        std::vector<std::string> fields;
        std::istringstream text(line);
        for (std::string field; std::getline(text, field, ',');)
            fields.push_back(field);
        Expected row{fields[0],
                     fields[1],
                     fields[2],
                     std::stoul(fields[3]),
                     fields[4] == "yes",
                     std::stod(fields[5]),
                     std::stod(fields[6]),
                     {}};
        for (std::size_t k = 7; k < fields.size(); ++k)
            if (!fields[k].empty())
                row.box.push_back(std::stod(fields[k]));
        rows.push_back(row);
    }
    return rows;
}

// Catches wrong arcs, ignored weights, wrong units, blocks placed wrongly, pieces not joined: every drawing
// at hand against another reader's numbers.
TEST(DxfOutlines, AgreesWithAnotherReaderOnEveryDrawing) {
    const auto rows = expectedOutlines();
    ASSERT_GE(rows.size(), 30u);
    for (const Expected& row : rows) {
        SCOPED_TRACE(row.file + " outline " + std::to_string(row.rank));
        const auto file = readDxfOutlines(dataPath(row.file), kTolerance_m);
        ASSERT_TRUE(file.ok()) << describe(file.error());
        const double unit_m = row.unit == "m" ? 1.0 : 1e-3;
        std::vector<FileOutline> closed, open;
        for (const FileOutline& outline : file->outlines)
            (outline.closed ? closed : open).push_back(outline);
        if (!row.closed_outlines.empty()) {
            EXPECT_EQ(std::to_string(closed.size()), row.closed_outlines);
        }
        const auto& kind = row.closed ? closed : open;
        ASSERT_GT(kind.size(), row.rank);
        const FileOutline& outline = kind[row.rank];
        EXPECT_NEAR(outline.area_m2() / (unit_m * unit_m), row.area, 2e-3 * row.area);
        EXPECT_NEAR(outline.perimeter_m() / unit_m, row.perimeter, 2e-3 * row.perimeter);
        if (!row.box.empty()) {
            const Eigen::AlignedBox2d box = boxOf_mm(outline);
            const Eigen::Vector2d low = box.min() * (1e-3 / unit_m), high = box.max() * (1e-3 / unit_m);
            const double slack = 2e-3 * std::max(row.box[2] - row.box[0], row.box[3] - row.box[1]);
            EXPECT_NEAR(low.x(), row.box[0], slack);
            EXPECT_NEAR(low.y(), row.box[1], slack);
            EXPECT_NEAR(high.x(), row.box[2], slack);
            EXPECT_NEAR(high.y(), row.box[3], slack);
        }
        const bool warned = !file->warnings.empty() && file->warnings[0].code == MessageCode::DxfUnitless;
        EXPECT_EQ(warned, row.unit == "none");
    }
}

// Catches a refusal that is silent or for the wrong reason.
TEST(DxfOutlines, RefusesForTheStatedReason) {
    const std::vector<std::pair<std::string, MessageCode>> refused = {
        {"bad_truncated.dxf", MessageCode::DxfCutOff}, {"binary_diamond_r12.dxf", MessageCode::DxfBinary},
        {"binary_r13.dxf", MessageCode::DxfBinary},    {"bunny_binary_mm.dxf", MessageCode::DxfBinary},
        {"empty.dxf", MessageCode::FileEmpty},         {"minimal_eof_only.dxf", MessageCode::NoOutline},
        {"no_entities.dxf", MessageCode::NoOutline},   {"missing.dxf", MessageCode::FileNotFound},
    };
    for (const auto& [name, code] : refused) {
        const auto file = readDxfOutlines(dataPath(name), kTolerance_m);
        ASSERT_FALSE(file.ok()) << name;
        EXPECT_STREQ(messageName(file.error().code()), messageName(code)) << name;
    }
}

// Catches an outline that crosses itself going on as a contour.
TEST(DxfOutlines, CrossingOutlineIsReadButNoContour) {
    const auto file = readDxfOutlines(dataPath("star7_selfintersecting.dxf"), kTolerance_m);
    ASSERT_TRUE(file.ok());
    const auto contour = contourOf(file->outlines[0]);
    ASSERT_FALSE(contour.ok());
    EXPECT_EQ(contour.error().code(), MessageCode::ContourCrossing);
}

// Catches a wrong centre, radius, direction of sweep or flattening of each kind, against its exact area.
TEST(DxfOutlines, EachKindHasItsExactAreaAndBox) {
    expectOne(outlinesOf("0 CIRCLE 10 3 20 4 40 2"), 4 * std::numbers::pi, 1, 2, 5, 6);
    // an arc over the seam of its angle, closed by two lines: three quarters of a disk
    expectOne(outlinesOf("0 ARC 10 0 20 0 40 10 50 180 51 90 0 LINE 10 0 20 0 11 -10 21 0 "
                         "0 LINE 10 0 20 0 11 0 21 10"),
              75 * std::numbers::pi, -10, -10, 10, 10);
    // half an ellipse with its long axis up, from parameter 0 to pi: the left half
    expectOne(outlinesOf("0 ELLIPSE 10 0 20 0 11 0 21 6 40 0.5 41 0 42 3.14159265358979 "
                         "0 LINE 10 0 20 6 11 0 21 -6"),
              9 * std::numbers::pi, -3, -6, 0, 6);
    expectOne(outlinesOf("0 ELLIPSE 10 0 20 0 11 0 21 6 40 0.5 210 0 220 0 230 -1 41 0 42 3.14159265358979 "
                         "0 LINE 10 0 20 6 11 0 21 -6"),
              9 * std::numbers::pi, 0, -6, 3, 6);
    // a stadium: bulge 1 is half a circle, to the right of the way up
    const std::string stadium = "10 0 20 0 10 8 20 0 42 1 10 8 20 4 10 0 20 4 42 1";
    expectOne(outlinesOf("0 LWPOLYLINE 90 4 70 1 " + stadium), 32 + 4 * std::numbers::pi, -2, 0, 10, 4);
    expectOne(outlinesOf("0 POLYLINE 70 1 0 VERTEX 10 0 20 0 0 VERTEX 10 8 20 0 42 1 0 VERTEX 10 8 20 4 "
                         "0 VERTEX 10 0 20 4 42 1 0 SEQEND"),
              32 + 4 * std::numbers::pi, -2, 0, 10, 4);
    // a disk of two bulges, and one of bulges that are not halves: 90 degrees have tan(22.5 degrees)
    expectOne(outlinesOf("0 LWPOLYLINE 90 2 70 1 10 -1 20 0 42 1 10 1 20 0 42 1"), std::numbers::pi, -1, -1,
              1, 1);
    expectOne(outlinesOf("0 LWPOLYLINE 90 4 70 1 10 1 20 0 42 .414213562 10 0 20 1 42 .414213562 "
                         "10 -1 20 0 42 .414213562 10 0 20 -1 42 .414213562"),
              std::numbers::pi, -1, -1, 1, 1);
}

// Catches weights ignored (a unit disk as a rational quadratic), a wrong knot span, a closed flag ignored.
TEST(DxfOutlines, SplinesAreExact) {
    std::ostringstream disk;
    disk << "0 SPLINE 70 5 71 2 72 12 73 9 ";
    for (const int knot : {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4})
        disk << "40 " << knot << ' ';
    const int x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    for (int k = 0; k < 9; ++k)
        disk << "10 " << x[k] << " 20 " << y[k] << " 41 " << (k % 2 ? "0.70710678118" : "1") << ' ';
    expectOne(outlinesOf(disk.str()), std::numbers::pi, -1, -1, 1, 1);

    // parabola y = x (2 - x) as a Bezier curve, flagged closed: 2/3 of the box of 2 x 1
    const std::string arch = "71 2 72 6 73 3 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0";
    expectOne(outlinesOf("0 SPLINE 70 1 " + arch), 4.0 / 3.0, 0, 0, 2, 1);
    const auto open = outlinesOf("0 SPLINE 70 8 " + arch);
    ASSERT_EQ(open.outlines.size(), 1u);
    EXPECT_FALSE(open.outlines[0].closed);
}

// Catches a spline through fit points that misses them, or has a corner where it closes.
TEST(DxfOutlines, SplineRunsThroughItsFitPoints) {
    std::ostringstream ring;
    ring << "0 SPLINE 70 11 71 3 72 0 73 0 74 24 ";
    for (int k = 0; k < 24; ++k)
        ring << "11 " << 10 * std::cos(k * std::numbers::pi / 12) << " 21 "
             << 10 * std::sin(k * std::numbers::pi / 12) << ' ';
    const auto file = outlinesOf(ring.str());
    expectOne(file, 100 * std::numbers::pi, -10, -10, 10, 10);
    for (const Eigen::Vector2d& p : file.outlines[0].points_m)
        EXPECT_NEAR(p.norm(), 0.010, 2e-5);

    // start along +y and end along -y, 2 apart: as a half circle starts and ends
    const auto arch =
        outlinesOf("0 SPLINE 70 8 71 3 74 3 12 0 22 1 13 0 23 -1 11 -1 21 0 11 0 21 1 11 1 21 0");
    ASSERT_EQ(arch.outlines.size(), 1u);
    const auto& points = arch.outlines[0].points_m;
    EXPECT_GT((points[1] - points[0]).normalized().y(), 0.98);
    EXPECT_NEAR(arch.outlines[0].perimeter_m() * 1e3, std::numbers::pi, 0.1);
    // steps so unlike that a sum swallows the short ones
    const auto uneven = outlinesOf("0 SPLINE 70 1 71 3 11 1e15 21 0 11 1 21 0 11 1 21 1");
    ASSERT_EQ(uneven.outlines.size(), 1u);
    for (const Eigen::Vector2d& p : uneven.outlines[0].points_m)
        EXPECT_TRUE(p.allFinite());
    // of two points: a straight line
    EXPECT_NEAR(outlinesOf("0 SPLINE 71 3 74 2 11 0 21 0 11 3 21 4").outlines[0].perimeter_m(), 5e-3, 1e-8);
}

// Catches a wrong order of scale, turn, base point and shift, copies missed, mirrors lost.
TEST(DxfOutlines, BlocksAreCopied) {
    const std::string triangle = "0 BLOCK 2 tri 10 1 20 1 "
                                 "0 LWPOLYLINE 8 0 90 3 70 1 10 1 20 1 10 5 20 1 10 1 20 3 0 ENDBLK ";
    // scaled by 2 and 3, turned by 90 degrees about the insertion point: x = 10 - 3 y', y = 20 + 2 x'
    expectOne(outlinesOf("0 INSERT 2 TRI 10 10 20 20 41 2 42 3 50 90", triangle), 24, 4, 20, 10, 28);
    expectOne(outlinesOf("0 INSERT 2 tri 10 0 20 0 41 -1", triangle), 4, -4, 0, 0, 2);
    // seen from below: x runs to the left
    expectOne(outlinesOf("0 INSERT 2 tri 10 10 20 0 230 -1", triangle), 4, -14, 0, -10, 2);
    expectOne(outlinesOf("0 CIRCLE 10 5 20 0 40 1 210 0 220 0 230 -1"), std::numbers::pi, -6, -1, -4, 1);
    // from below a bulge turns the other way
    expectOne(outlinesOf("0 LWPOLYLINE 90 2 70 1 10 0 20 0 42 1 10 0 20 2 230 -1"), std::numbers::pi / 2, -1,
              0, 0, 2);

    // a disk squeezed to an ellipse, turned, within a block of a block
    const std::string nested = triangle + "0 BLOCK 2 disk 0 CIRCLE 10 0 20 0 40 1 0 ENDBLK "
                                          "0 BLOCK 2 both 0 INSERT 2 disk 41 3 0 ENDBLK ";
    expectOne(outlinesOf("0 INSERT 2 both 10 5 50 90", nested), 3 * std::numbers::pi, 4, -3, 6, 3);

    // a block without its end
    expectOne(outlinesOf("0 CIRCLE 40 1", "0 BLOCK 2 b 0 CIRCLE 40 2"), std::numbers::pi, -1, -1, 1, 1);

    // 3 columns and 2 rows, 10 and 20 apart, turned by 90 degrees: rows go left, columns up
    const auto grid = outlinesOf("0 INSERT 2 disk 41 0.5 42 0.5 50 90 70 3 71 2 44 10 45 20", nested);
    ASSERT_EQ(grid.outlines.size(), 6u);
    Eigen::AlignedBox2d all;
    for (const FileOutline& outline : grid.outlines)
        all.extend(boxOf_mm(outline));
    EXPECT_NEAR(all.min().x(), -20.5, 0.01);
    EXPECT_NEAR(all.max().x(), 0.5, 0.01);
    EXPECT_NEAR(all.min().y(), -0.5, 0.01);
    EXPECT_NEAR(all.max().y(), 20.5, 0.01);
}

// Catches lengths of a unit misread.
TEST(DxfOutlines, UnitsAreHonoured) {
    const std::vector<std::pair<int, double>> units = {{1, 0.0254}, {2, 0.3048},  {4, 1e-3},    {5, 1e-2},
                                                       {6, 1.0},    {9, 2.54e-5}, {10, 0.9144}, {14, 0.1}};
    for (const auto& [code, metres] : units) {
        const auto file =
            read(lines("0 SECTION 2 HEADER 9 $INSUNITS 70 " + std::to_string(code) +
                       " 0 ENDSEC 0 SECTION 2 ENTITIES 0 LWPOLYLINE 90 3 70 1 10 0 20 0 10 3 20 0 "
                       "10 0 20 4 0 ENDSEC 0 EOF"));
        ASSERT_TRUE(file.ok());
        EXPECT_NEAR(file->outlines[0].perimeter_m(), 12 * metres, 1e-12) << code;
        EXPECT_TRUE(file->warnings.empty());
    }
}

// Catches outlines not joined, joined wrongly at a spur or a touching corner, or doubled.
TEST(DxfOutlines, PiecesAreChained) {
    const auto square = [](double x, double y) {
        std::ostringstream text; // every second edge runs back
        text << "0 LINE 10 " << x << " 20 " << y << " 11 " << x + 1 << " 21 " << y << " 0 LINE 10 " << x + 1
             << " 20 " << y + 1 << " 11 " << x + 1 << " 21 " << y << " 0 LINE 10 " << x + 1 << " 20 " << y + 1
             << " 11 " << x << " 21 " << y + 1 << " 0 LINE 10 " << x << " 20 " << y << " 11 " << x << " 21 "
             << y + 1 << ' ';
        return text.str();
    };
    expectOne(outlinesOf(square(0, 0)), 1, 0, 0, 1, 1);
    expectOne(outlinesOf(square(0, 0) + square(0, 0)), 1, 0, 0, 1, 1); // drawn twice

    const auto touching = outlinesOf(square(0, 0) + square(1, 1));
    ASSERT_EQ(touching.outlines.size(), 2u);
    for (const FileOutline& outline : touching.outlines)
        EXPECT_NEAR(outline.area_m2(), 1e-6, 1e-12);

    const auto spur = outlinesOf(square(0, 0) + "0 LINE 10 1 20 1 11 3 21 3");
    ASSERT_EQ(spur.outlines.size(), 2u);
    EXPECT_NEAR(spur.outlines[0].area_m2(), 1e-6, 1e-12);
    EXPECT_FALSE(spur.outlines[1].closed);

    // ends a tenth of a millionth of the extent apart are one, a thousandth apart are not
    const std::string corner = "0 LINE 10 0 20 0 11 1 21 0 0 LINE 10 1 20 0 11 0 21 1 ";
    EXPECT_TRUE(outlinesOf(corner + "0 LINE 10 0 20 1 11 0 21 1e-7").outlines[0].closed);
    const auto gap = outlinesOf(corner + "0 LINE 10 0 20 1 11 0 21 1e-3");
    ASSERT_EQ(gap.outlines.size(), 1u);
    EXPECT_FALSE(gap.outlines[0].closed);
}

// Catches holes not told.
TEST(DxfOutlines, InnerOutlinesAreHoles) {
    const auto file = outlinesOf("0 CIRCLE 10 0 20 0 40 1 0 CIRCLE 10 0 20 0 40 5 0 CIRCLE 10 0 20 0 40 3");
    ASSERT_EQ(file.outlines.size(), 3u);
    EXPECT_FALSE(file.outlines[0].hole);
    EXPECT_TRUE(file.outlines[1].hole);
    EXPECT_FALSE(file.outlines[2].hole);
}

// Catches construction lines and texts that come in unseen, and silence about what was left out.
TEST(DxfOutlines, WhatIsHiddenOrNoCurveIsLeftOutAndTold) {
    const std::string layers = "0 LAYER 2 frozen 70 1 62 7 0 LAYER 2 off 70 0 62 -7 0 LAYER 2 on 70 0 62 7";
    const auto file = outlinesOf("0 CIRCLE 8 on 40 1 0 CIRCLE 8 Frozen 40 2 0 CIRCLE 8 OFF 40 3 "
                                 "0 CIRCLE 8 on 60 1 40 4 0 CIRCLE 8 on 67 1 40 5 "
                                 "0 TEXT 8 on 1 words 0 HATCH 8 on 0 TEXT 1 more 0 INSERT 2 nowhere "
                                 "0 CIRCLE 40 6 210 0 220 1 230 0 0 POLYLINE 70 16 0 VERTEX 10 1 20 1",
                                 "", layers);
    expectOne(file, std::numbers::pi, -1, -1, 1, 1);
    ASSERT_EQ(file.warnings.size(), 2u);
    EXPECT_EQ(file.warnings[0],
              (Message{MessageCode::ElementsUnread, {"1 CIRCLE, 1 HATCH, 1 INSERT, 1 MESH, 2 TEXT"}}));
    EXPECT_EQ(file.warnings[1], (Message{MessageCode::DxfHidden, {"4"}}));

    // layer 0 in a block is the layer of its copy
    const std::string block = "0 BLOCK 2 b 0 CIRCLE 8 0 40 1 0 ENDBLK";
    const auto hidden = read(drawing("0 INSERT 8 off 2 b", block, layers));
    ASSERT_FALSE(hidden.ok());
    EXPECT_EQ(hidden.error().code(), MessageCode::NoOutline);
    EXPECT_EQ(outlinesOf("0 INSERT 8 on 2 b", block, "0 LAYER 2 0 62 -7").outlines.size(), 1u);
}

struct Hostile {
    const char* name;
    std::string bytes;
    MessageCode code;
};

std::string repeated(const std::string& text, int times) {
    std::string all;
    for (int k = 0; k < times; ++k)
        all += text;
    return all;
}

std::vector<Hostile> hostileDrawings() {
    const std::string spline = "0 SPLINE 71 3 72 8 73 4 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 ";
    const std::string controls = "10 0 20 0 10 1 20 0 10 1 20 1 10 0 20 1";
    const std::string disk = "0 BLOCK 2 b0 0 CIRCLE 40 1 0 ENDBLK ", empty = "0 BLOCK 2 e0 0 ENDBLK ";
    std::string laughs = disk, nothings = empty, deep = disk;
    for (int k = 1; k < 12; ++k) {
        const std::string here = std::to_string(k), below = std::to_string(k - 1);
        laughs += "0 BLOCK 2 b" + here + " " + repeated("0 INSERT 2 b" + below + " ", 10) + "0 ENDBLK ";
        nothings += "0 BLOCK 2 e" + here + " " + repeated("0 INSERT 2 e" + below + " ", 10) + "0 ENDBLK ";
    }
    for (int k = 1; k < 100; ++k)
        deep += "0 BLOCK 2 b" + std::to_string(k) + " 0 INSERT 2 b" + std::to_string(k - 1) + " 0 ENDBLK ";
    std::string big = "0 BLOCK 2 b1 0 INSERT 2 b0 41 1e15 0 ENDBLK ";
    using enum MessageCode;
    return {
        {"block in itself",
         drawing("0 INSERT 2 a", "0 BLOCK 2 a 0 INSERT 2 b 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 A 0 ENDBLK"),
         DxfBlockInItself},
        {"1e18 copies", drawing("0 INSERT 2 b0 70 1000000000 71 1000000000", disk), FileTooLarge},
        {"1e18 copies of nothing", drawing("0 INSERT 2 e0 70 1000000000 71 1000000000", empty), FileTooLarge},
        {"1e11 copies in blocks", drawing("0 INSERT 2 b11", laughs), FileTooLarge},
        {"1e11 copies of nothing in blocks", drawing("0 INSERT 2 e11", nothings), FileTooLarge},
        {"blocks 100 deep", drawing("0 INSERT 2 b99", deep), FileTooLarge},
        {"a copy of no finite size", drawing("0 INSERT 2 b1 41 1e15", disk + big), ContourNotFinite},
        {"columns beyond int", drawing("0 INSERT 2 b0 70 99999999999", disk), DxfDamaged},
        {"falling knots", drawing("0 SPLINE 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 0 " + controls),
         DxfDamaged},
        {"one knot", drawing("0 SPLINE 71 3 " + repeated("40 1 ", 8) + controls), DxfDamaged},
        {"degree 1000", drawing("0 SPLINE 71 1000 40 0 40 1 " + controls), DxfDamaged},
        {"degree 0", drawing("0 SPLINE 71 0 40 0 40 1 40 2 40 3 40 4 " + controls), DxfDamaged},
        {"two degrees",
         drawing("0 SPLINE 71 2 71 15 40 0 40 0 40 0 40 1 40 1 40 1 10 0 20 0 10 1 20 2 10 2 20 0"),
         DxfDamaged},
        {"too few controls", drawing(spline + "10 0 20 0 10 1 20 1"), DxfDamaged},
        {"weight 0", drawing(spline + controls + " 41 1 41 0 41 1 41 1"), DxfDamaged},
        {"knots that are not there", drawing("0 SPLINE 71 3 72 2000000000 73 4 " + controls), DxfDamaged},
        {"not a number", drawing("0 CIRCLE 40 nan"), ContourNotFinite},
        {"infinite", drawing("0 LINE 10 1e400 20 0 11 1 21 1"), ContourNotFinite},
        {"huge", drawing("0 LINE 10 1e300 20 0 11 1 21 1"), ContourNotFinite},
        {"words for a number", drawing("0 CIRCLE 40 wide"), ContourNotANumber},
        {"no group code", lines("0 SECTION 2 ENTITIES 0 LINE ten 0 0 EOF"), DxfDamaged},
        {"long name", drawing("0 INSERT 2 " + std::string(5000, 'a')), DxfDamaged},
        {"one long line", std::string(4'000'000, '0'), DxfCutOff},
        {"zeros", std::string(100'000, '\0'), DxfCutOff},
        {"UTF-16",
         std::string("\xFF\xFE"
                     "0\0\n\0S\0\n\0",
                     10),
         DxfDamaged},
        {"400 000 lines", drawing(repeated("0 LINE ", 400'000)), FileTooLarge},
        {"5 million vertices", drawing("0 LWPOLYLINE " + repeated("10 1 ", 5'000'000)), FileTooLarge},
        {"4900 disks", drawing(repeated("0 CIRCLE 40 1 ", 4900)), FileTooLarge},
        {"11 million points of arcs", drawing(repeated("0 CIRCLE 40 1e12 ", 600)), FileTooLarge},
    };
}

// Catches a hostile drawing that reaches dxflib, recurses, or takes time or memory without end.
TEST(DxfOutlines, HostileDrawingsAreRefusedSoon) {
    for (const Hostile& hostile : hostileDrawings()) {
        const std::clock_t start = std::clock();
        const auto file = read(hostile.bytes);
        const double took_s = cpu_s(start);
        ASSERT_FALSE(file.ok()) << hostile.name;
        EXPECT_STREQ(messageName(file.error().code()), messageName(hostile.code)) << hostile.name;
        EXPECT_LT(took_s, 30.0) << hostile.name;
    }
}

// Catches counts taken on trust: of vertices, knots, controls, and a spline's counts left to the next one.
TEST(DxfOutlines, CountsInTheFileAreNotTrusted) {
    const std::string triangle = " 70 1 10 0 20 0 10 4 20 0 10 0 20 2";
    for (const char* count : {"90 2000000000", "90 -5", "90 2", "90 0", ""})
        expectOne(outlinesOf(std::string("0 LWPOLYLINE ") + count + triangle), 4, 0, 0, 4, 2);
    const std::string knots = "40 0 40 0 40 0 40 1 40 1 40 1 ", arch = "10 0 20 0 10 1 20 2 10 2 20 0 ";
    const auto file = outlinesOf("0 SPLINE 70 1 71 2 72 900000000 73 -3 74 7 " + knots + arch +
                                 "0 SPLINE 70 1 71 2 " + knots + arch);
    ASSERT_EQ(file.outlines.size(), 2u);
    EXPECT_NEAR(file.outlines[1].area_m2(), 4e-6 / 3, 1e-8);
}

// Catches crashes and hangs on files cut off anywhere or with bytes changed.
TEST(DxfOutlines, DamagedDrawingsNeverCrash) {
    std::mt19937 random(20261121);
    for (const char* name : {"structure_error_r12.dxf", "insert_rotated_scaled_mm.dxf", "splines_open.dxf",
                             "r12_polylines_text.dxf", "bulge_wifi_mm.dxf"}) {
        const std::string whole = bytesOf(name);
        ASSERT_FALSE(whole.empty());
        const std::clock_t start = std::clock();
        for (std::size_t cut = 0; cut + 5 < whole.size(); cut += 1 + whole.size() / 97)
            EXPECT_FALSE(read(whole.substr(0, cut)).ok()) << name << " cut at " << cut;
        for (int round = 0; round < 200; ++round) {
            std::string changed = whole;
            for (int k = 0; k < 1 + round / 10; ++k)
                changed[random() % changed.size()] = static_cast<char>(random());
            const auto file = read(changed);
            for (const FileOutline& outline : file ? file->outlines : std::vector<FileOutline>{})
                EXPECT_TRUE(std::isfinite(outline.perimeter_m())) << name;
        }
        const double took_s = cpu_s(start);
        EXPECT_LT(took_s, 20.0) << name; // 300 readings
    }
}

// Catches counts of 100 000 and more that reach dxflib as 1e+05, which it takes for 1.
TEST(DxfOutlines, LongPolylinesAreWhole) {
    std::ostringstream text;
    text << "0 LWPOLYLINE 70 1 ";
    for (int k = 0; k < 100'000; ++k)
        text << "10 " << 100 * std::cos(2 * std::numbers::pi * k / 1e5) << " 20 "
             << 100 * std::sin(2 * std::numbers::pi * k / 1e5) << ' ';
    const std::clock_t start = std::clock();
    expectOne(outlinesOf(text.str()), 1e4 * std::numbers::pi, -100, -100, 100, 100);
    const double took_s = cpu_s(start);
    EXPECT_LT(took_s, 30.0);
}

// Catches the join of pieces growing as their square.
TEST(DxfOutlines, ManyPiecesAreJoinedSoon) {
    std::ostringstream text;
    constexpr int kCount = 60'000;
    for (int k = 0; k < kCount; ++k) {
        const int from = static_cast<int>((k * 7919LL) % kCount); // in no order
        for (const int end : {0, 1}) {
            const double t = 2 * std::numbers::pi * ((from + end) % kCount) / kCount;
            text << (end ? "11 " : "0 LINE 10 ") << 100 * std::cos(t) << (end ? " 21 " : " 20 ")
                 << 100 * std::sin(t) << ' ';
        }
    }
    const std::string bytes = drawing(text.str());
    const std::clock_t start = std::clock();
    const auto file = read(bytes);
    const double took_s = cpu_s(start);
    ASSERT_TRUE(file.ok()) << describe(file.error());
    EXPECT_NEAR(file->outlines[0].area_m2(), 1e-2 * std::numbers::pi, 1e-5);
    EXPECT_LT(took_s, 30.0);
}

} // namespace
} // namespace bask
