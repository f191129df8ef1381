// Every reader through the one entrance, against figures computed by other programs.

#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"
#include "engine/shape/hausdorff.h"
#include "tests/engine/shape/shape_samples.h"

#include <Eigen/Geometry>

#include <chrono>
#include <sstream>

namespace bask {
namespace {

constexpr auto kMillimetre = LengthUnit::Millimetre;

struct Known {
    std::string path;
    double area_mm2, perimeter_mm;
    std::array<double, 4> box_mm; // x and y least, x and y most
};

Eigen::AlignedBox2d boxOf(const FileOutline& outline) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& p : outline.points_m)
        box.extend(1e3 * p);
    return box;
}

// By numpy (shoelace over all rows); the unit taken as mm. Catches a column, unit or row misread.
TEST(Readers, ListsOfPointsHaveTheirKnownSizes) {
    const std::array bunny{0.0, 0.0, 70.0, 68.237672};
    const Known files[] = {
        {test::dataPath("airfoil_e423.dat"), 0.082732, 2.095649, {2e-05, -0.01485, 1.0, 0.15828}},
        {test::dataPath("earcut_dude.csv"),
         15345.289136,
         1678.408871,
         {250.53571, 325.93361, 450.71429, 685.21933}},
        {test::dataPath("earcut_hourglass.csv"), 17.0, 30.076342, {5.0, 13.0, 17.0, 18.0}},
        {test::dataPath("mosquito_wing_000.csv"), 0.997474, 4.819435, {-1.13416, -0.31464, 0.99973, 0.51171}},
        {test::dataPath("pyefd_contour_1.csv"),
         54.063152,
         87.796811,
         {5.9875, 6.995812, 24.003137, 22.006299}},
        {test::examplePath("bunny_mm.csv"), 2894.233844, 284.310287, bunny},
        {test::dataPath("bunny_semicolon_comma.csv"), 2894.233844, 284.310287, bunny},
        {test::dataPath("bunny_bom_closed.csv"), 2894.233844, 284.310287, bunny},
        {test::dataPath("bunny_tab_noheader.txt"), 2894.233844, 284.310287, bunny},
        {test::examplePath("hand_mm.csv"), 2326.741699, 379.956126, {0.0, 0.0, 70.0, 69.999854}},
    };
    for (const Known& known : files) {
        const auto file = readOutlines(known.path, {.unit = kMillimetre});
        ASSERT_TRUE(file) << known.path << describe(file.error());
        ASSERT_EQ(file->outlines.size(), 1U);
        const FileOutline& outline = file->outlines[0];
        EXPECT_TRUE(outline.closed && !outline.hole) << known.path;
        EXPECT_EQ(file->unit, "mm");
        EXPECT_NEAR(outline.area_m2() * 1e6, known.area_mm2, 1e-5 * known.area_mm2) << known.path;
        EXPECT_NEAR(outline.perimeter_m() * 1e3, known.perimeter_mm, 1e-5 * known.perimeter_mm) << known.path;
        const Eigen::AlignedBox2d box = boxOf(outline);
        const Eigen::Vector4d found(box.min().x(), box.min().y(), box.max().x(), box.max().y());
        EXPECT_LT((found - Eigen::Map<const Eigen::Vector4d>(known.box_mm.data())).norm(), 1e-5)
            << known.path;
    }
}

// Catches files read that say nothing of a shape, and reasons that are not the file's.
TEST(Readers, RefuseTheRestForItsReason) {
    const auto code = [](const char* name, const ContourImportOptions& options) {
        const auto contour = readContour(test::dataPath(name), options);
        return contour ? MessageCode::None : contour.error().code();
    };
    const ContourImportOptions mm{.unit = kMillimetre}, scale{.scale_px_per_mm = 10.0};
    EXPECT_EQ(code("bunny_tab_noheader.txt", {}), MessageCode::ContourUnitMissing);
    EXPECT_EQ(code("earcut_hourglass.csv", mm), MessageCode::ContourCrossing);
    EXPECT_EQ(code("bad_collinear.csv", mm), MessageCode::ContourZeroArea);
    EXPECT_EQ(code("bad_nan_row.csv", mm), MessageCode::ContourNotFinite);
    EXPECT_EQ(code("bad_two_points.csv", mm), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(code("empty.csv", mm), MessageCode::FileEmpty);
    EXPECT_EQ(code("empty.png", scale), MessageCode::FileEmpty);
    EXPECT_EQ(code("truncated.jpg", scale), MessageCode::ImageUnreadable);
    EXPECT_EQ(code("hand_photo_border.jpg", scale), MessageCode::SilhouetteAtBorder);
    EXPECT_EQ(code("tiny_indexed_3x5.png", scale), MessageCode::NoSilhouette);
    const std::string picture = test::writeFile(".csv", "\x89PNG\r\n\x1a\n\0\0\0\rIHDR");
    EXPECT_EQ(readOutlines(picture, mm).error().code(), MessageCode::FileUnreadable) << "a picture named csv";
    const std::string list = test::writeFile(".png", "x_mm,y_mm\n0,0\n1,0\n0,1\n");
    EXPECT_EQ(readOutlines(list, scale).error().code(), MessageCode::ImageUnreadable) << "a list named png";
}

// By OpenCV in Python: Otsu's area in px, box of pixel indices. Catches silhouettes of the wrong polarity.
TEST(Readers, PicturesHaveTheirKnownSizes) {
    struct Picture {
        std::string path;
        double area_px;
        std::array<int, 4> box; // left, top, width, height
        int rows;
    };
    for (const Picture& known :
         {Picture{test::dataPath("horse.png"), 43412, {18, 9, 371, 304}, 328},
          Picture{test::dataPath("templ.png"), 8614, {5, 5, 91, 124}, 130},
          Picture{test::examplePath("bunny_1200.png"), 651496, {75, 88, 1050, 1024}, 1200},
          Picture{test::examplePath("hand_1200.png"), 523927, {75, 75, 1050, 1050}, 1200},
          Picture{test::dataPath("hand_white_on_black.png"), 523927, {75, 75, 1050, 1050}, 1200}}) {
        const auto file = readOutlines(known.path, {.scale_px_per_mm = 1.0});
        ASSERT_TRUE(file) << known.path << describe(file.error());
        EXPECT_NEAR(file->outlines[0].area_m2() * 1e6, known.area_px, 0.01 * known.area_px) << known.path;
        const Eigen::AlignedBox2d box = boxOf(file->outlines[0]);
        EXPECT_NEAR(box.min().x(), known.box[0], 1.0) << known.path;
        EXPECT_NEAR(known.rows - box.max().y(), known.box[1], 1.0) << known.path;
        EXPECT_NEAR(box.sizes().x(), known.box[2], 1.0) << known.path;
        EXPECT_NEAR(box.sizes().y(), known.box[3], 1.0) << known.path;
    }
}

std::vector<Eigen::Vector2d> centredPoints(const std::string& path, const ContourImportOptions& options) {
    const auto contour = readContour(path, options);
    EXPECT_TRUE(contour) << describe(contour.error());
    return contour ? centred(*contour).points_m : std::vector<Eigen::Vector2d>(1);
}

// Catches a reader whose outline is shifted, stretched or rounded against the others of the same shape.
TEST(Readers, FilesOfOneShapeAgreePairwise) {
    for (const std::string name : {"bunny", "hand"}) {
        const std::pair<std::string, test::Points> files[] = {
            {"csv", centredPoints(test::examplePath(name + "_mm.csv"), {})},
            {"png", centredPoints(test::examplePath(name + "_1200.png"), {.scale_px_per_mm = 15.0})},
            {"svg", centredPoints(test::dataPath("svg/" + name + "_mm.svg"), {})},
            {"dxf", centredPoints(test::dataPath("dxf/" + name + "_mm.dxf"), {})}};
        for (const auto& [kind, points] : files)
            for (const auto& [other, others] : files) {
                if (kind >= other)
                    continue;
                const double distance_m = hausdorffDistance(points, others, 1e-7);
                RecordProperty(name + "_" + kind + "_" + other + "_mm", std::to_string(distance_m * 1e3));
                EXPECT_LT(distance_m, 0.15e-3) << name << ' ' << kind << ' ' << other;
            }
    }
}

// Catches a sample shape of another size than its README says, off its page, or without its bore.
TEST(Readers, SampleShapesAreAsTheyAreDescribed) {
    const auto read = [](const char* name) {
        const auto file = readOutlines(test::examplePath(name), {});
        EXPECT_TRUE(file) << name << describe(file.error());
        EXPECT_TRUE(file && file->warnings.empty()) << name;
        return file ? *file : OutlineFile{};
    };
    const OutlineFile circle = read("circle.svg"), leaf = read("leaf.svg"), gear = read("gear.svg");
    ASSERT_EQ(circle.outlines.size(), 1U);
    EXPECT_NEAR(boxOf(circle.outlines[0]).sizes().x(), 50.0, 0.02);
    ASSERT_EQ(leaf.outlines.size(), 1U);
    EXPECT_NEAR(boxOf(leaf.outlines[0]).sizes().y(), 76.0, 1e-3);
    ASSERT_EQ(gear.outlines.size(), 2U);
    EXPECT_NEAR(boxOf(gear.outlines[0]).sizes().x(), 62.0, 0.2);
    EXPECT_TRUE(gear.outlines[1].hole);
    EXPECT_NEAR(boxOf(gear.outlines[1]).sizes().x(), 16.0, 0.01);
    for (const OutlineFile& file : {circle, leaf, gear})
        EXPECT_TRUE(contourOf(file.outlines[0]));
}

// Catches an import or a fit that takes quadratic time: 60,000 points and 20 harmonics in half a second.
TEST(Readers, SixtyThousandPointsAreReadAndFittedAtOnce) {
    std::ostringstream text;
    text << "x_mm,y_mm\n";
    text.precision(12);
    for (const auto& p : test::wavy(60000, 12))
        text << 40 * p.x() << ',' << 40 * p.y() << '\n';
    const std::string path = test::writeFile(".csv", text.str());
    const auto start = std::chrono::steady_clock::now();
    const auto contour = readContour(path, {});
    const auto read = std::chrono::steady_clock::now();
    ASSERT_TRUE(contour);
    ASSERT_TRUE(fitFourier(*contour, 20));
    const std::chrono::duration<double> whole = std::chrono::steady_clock::now() - start;
    RecordProperty("read_s", std::to_string(std::chrono::duration<double>(read - start).count()));
    RecordProperty("read_and_fit_s", std::to_string(whole.count()));
    EXPECT_LT(whole.count(), 2.0) << "ten times what it takes, for machines that are busy";
}

} // namespace
} // namespace bask
