// Outlines from lists of points: every form that is read, every refusal, and damaged files.

#include "engine/base/message_code.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/outline_formats.h"
#include "tests/engine/shape/shape_samples.h"

#include <filesystem>
#include <iterator>
#include <random>
#include <sstream>

namespace bask {
namespace {

constexpr auto kMm = LengthUnit::Millimetre;

Result<Contour> readText(const std::string& text, std::optional<LengthUnit> unit = std::nullopt) {
    return readContourCsv(test::writeFile(".csv", text), unit);
}

MessageCode codeOf(const Result<Contour>& result) {
    if (result)
        return MessageCode::None;
    EXPECT_FALSE(describe(result.error()).empty());
    return result.error().code();
}

std::string fileText(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

void expectBunny(const Result<Contour>& contour) {
    ASSERT_TRUE(contour) << describe(contour.error());
    EXPECT_EQ(contour->points_m.size(), 165U);
    EXPECT_NEAR(contourArea(*contour) * 1e6, 2894.233844, 1e-5);
    EXPECT_NEAR(contourPerimeter(*contour) * 1e3, 284.310287, 1e-5);
    EXPECT_NEAR(contourCentroid(*contour).x() * 1e3, 31.924593, 1e-5);
    EXPECT_NEAR(contourCentroid(*contour).y() * 1e3, 27.399354, 1e-5);
}

TEST(ContourCsv, ReadsTheBunnyInEveryDress) {
    expectBunny(readContourCsv(test::examplePath("bunny_mm.csv"), std::nullopt));
    expectBunny(readContourCsv(test::dataPath("bunny_bom_closed.csv"), std::nullopt));
    expectBunny(readContourCsv(test::dataPath("bunny_semicolon_comma.csv"), kMm));
    expectBunny(readContourCsv(test::dataPath("bunny_tab_noheader.txt"), kMm));
    expectBunny(readContour(test::dataPath("bunny_tab_noheader.txt"), {.unit = kMm}));
}

TEST(ContourCsv, ReadsOtherPeoplesFiles) {
    const auto areaOf = [](const char* name) {
        const auto contour = readContourCsv(test::dataPath(name), LengthUnit::Metre);
        return contour ? contourArea(*contour) : -1.0;
    };
    EXPECT_NEAR(areaOf("mosquito_wing_000.csv"), 0.997474, 1e-6)
        << "x and y are its third and fourth columns";
    EXPECT_NEAR(areaOf("airfoil_e423.dat"), 0.082732, 1e-6) << "a name line, columns set apart by blanks";
    EXPECT_NEAR(areaOf("earcut_dude.csv"), 15345.289136, 1e-5) << "clockwise";
    EXPECT_NEAR(areaOf("pyefd_contour_1.csv"), 54.063152, 1e-6) << "first point repeated";
}

TEST(ContourCsv, TakesTheUnitFromTheHeaderUnlessOneIsGiven) {
    const auto areaOf = [](const std::string& header, std::optional<LengthUnit> unit = std::nullopt) {
        const auto contour = readText(header + "\n0,0\n2,0\n2,1\n0,1\n", unit);
        return contour ? contourArea(*contour) : -1.0;
    };
    for (const char* header :
         {"x_mm,y_mm", "X (mm),Y (mm)", "x[mm],y[mm]", "x / mm , y / mm", "\"x_mm\",\"y_mm\"", "x mm,y"})
        EXPECT_NEAR(areaOf(header), 2e-6, 1e-18) << header;
    EXPECT_NEAR(areaOf("x_cm,y_cm"), 2e-4, 1e-16);
    EXPECT_NEAR(areaOf("x_m,y_m"), 2.0, 1e-12);
    EXPECT_NEAR(areaOf("x_in,y_in"), 2 * 25.4e-3 * 25.4e-3, 1e-15);
    EXPECT_NEAR(areaOf("x_m,y_m", kMm), 2e-6, 1e-18);
    EXPECT_EQ(areaOf("x,y"), -1.0);
    EXPECT_EQ(codeOf(readText("x,y\n0,0\n2,0\n2,1\n")), MessageCode::ContourUnitMissing);
    EXPECT_EQ(codeOf(readText("0,0\n2,0\n2,1\n")), MessageCode::ContourUnitMissing);
    EXPECT_EQ(codeOf(readText("x_px,y_px\n0,0\n2,0\n2,1\n")), MessageCode::ContourUnitMissing);
    EXPECT_EQ(codeOf(readText("x_mm,y_cm\n0,0\n2,0\n2,1\n")), MessageCode::ContourUnitMissing);
}

TEST(ContourCsv, ReadsEveryDelimiterEndOfLineAndNumber) {
    const char* const files[] = {
        "0,0\n2,0\n2,1\n0,1",
        "0;0\r\n2;0\r\n2;1\r\n0;1\r\n",
        "0\t0\r2\t0\r2\t1\r0\t1\r",
        "# a comment\n\n 0 , 0 \n2 ,0\n\n  2, 1\n0,1\n\n",
        "0,0;0,0\n2,0;0,0\n2,0;1,0\n0;1",
        "0.0;0\n+2.0;-0\n2e0;10E-1\n0;1",
        "0\t0,0\n2,0\t0\n2\t1,0\n0\t1",
        "0  0\n2   0\n  2 1\n0 1  ",
        "\"0\",\"0\"\n\"2\",\"0\"\n\"2\",\"1\"\n\"0\",\"1\"\n",
        "0,0 0,0\n2,0 0,0\n2,0 1,0\n0 1\n",
        "\"0,0\" \"0,0\"\n\"2,0\" \"0,0\"\n\"2,0\" \"1,0\"\n\"0,0\" \"1,0\"\n",
        "x,\"y, seen\",\"at 1, 2\"\n0,0,\"a, b\"\n2,0,\"\"\n2,1,\"a \"\"b\"\", c\"\n0,1,\"\n",
        "t,x,y\n2024-01-01 10:00:00,0,0\n2024-01-01 10:00:01,2,0\n2024-01-01 10:00:02,2,1\n"
        "2024-01-01 10:00:03,0,1\n",
        "0,0,7\n2,0,7\n2,1,7\n0,1,7\n0,0,7\n"};
    for (const char* file : files) {
        const auto contour = readText(file, LengthUnit::Metre);
        ASSERT_TRUE(contour) << file << describe(contour.error());
        EXPECT_EQ(contour->points_m, (test::Points{{0, 0}, {2, 0}, {2, 1}, {0, 1}})) << file;
    }
}

TEST(ContourCsv, NamesTheLineOfABadRow) {
    const auto words = [](const std::string& text) { return describe(readText(text, kMm).error()); };
    EXPECT_NE(words("x,y\n0,0\n1,oops\n1,1\n").find("\"oops\" in line 3"), std::string::npos);
    EXPECT_NE(words("0,0\n\n1,0\n1\n").find("line 4 has 1 column"), std::string::npos);
    EXPECT_NE(words("0,0\n1,\n1,1\n").find("\"\" in line 2"), std::string::npos);
    EXPECT_NE(words("0,0\n1,nan\n1,1\n").find("line 2"), std::string::npos);
    EXPECT_NE(words("0,0\n1,1e999\n1,1\n").find("line 2"), std::string::npos);
    EXPECT_NE(words("0,0\n1 2,3\n1,1\n").find("\"1 2\" in line 2"), std::string::npos);
    const auto nan = readContourCsv(test::dataPath("bad_nan_row.csv"), kMm);
    EXPECT_EQ(codeOf(nan), MessageCode::ContourNotFinite);
    EXPECT_EQ(nan.error().where, test::dataPath("bad_nan_row.csv"));
    EXPECT_NE(describe(nan.error()).find("line 12"), std::string::npos);
}

TEST(ContourCsv, RefusesBadOutlinesInWords) {
    const auto code = [](const char* name) { return codeOf(readContourCsv(test::dataPath(name), kMm)); };
    EXPECT_EQ(code("bad_collinear.csv"), MessageCode::ContourZeroArea);
    EXPECT_EQ(code("bad_two_points.csv"), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(code("earcut_hourglass.csv"), MessageCode::ContourCrossing);
    EXPECT_EQ(code("empty.csv"), MessageCode::FileEmpty);
    EXPECT_EQ(codeOf(readText("x_mm,y_mm\n")), MessageCode::ContourTooFewPoints);
    EXPECT_EQ(codeOf(readText("\n \n\t\n# nothing\n", kMm)), MessageCode::FileEmpty);
    EXPECT_EQ(codeOf(readText("\xEF\xBB\xBF", kMm)), MessageCode::FileEmpty);
}

TEST(ContourCsv, RefusesWhatIsNoReadableText) {
    EXPECT_EQ(codeOf(readContourCsv("/no/such/file.csv", kMm)), MessageCode::FileNotFound);
    EXPECT_EQ(codeOf(readContourCsv("", kMm)), MessageCode::FileNotFound);
    EXPECT_EQ(codeOf(readContourCsv(testing::TempDir(), kMm)), MessageCode::FileUnreadable);
    EXPECT_EQ(codeOf(readContourCsv("/dev/zero", kMm)), MessageCode::FileUnreadable);
    EXPECT_EQ(codeOf(readContourCsv(test::examplePath("bunny_1200.png"), kMm)), MessageCode::FileUnreadable);
    EXPECT_EQ(codeOf(readText(std::string("\xFF\xFE") + "0\0,\0", kMm)), MessageCode::FileUnreadable);
    const std::string large = test::writeFile(".csv", "0,0\n");
    std::filesystem::resize_file(large, (std::uintmax_t{64} << 20) + 1);
    EXPECT_EQ(codeOf(readContourCsv(large, kMm)), MessageCode::FileTooLarge);
    std::filesystem::remove(large);
}

TEST(ContourCsv, TellsAnOpenOutlineFromOneWhoseLastEdgeIsLeftOut) {
    std::ostringstream arc; // three quarters of a circle in 1 degree steps: the ends are 81 steps apart
    for (int k = 0; k <= 270; ++k)
        arc << 10 * std::cos(k * std::numbers::pi / 180) << ',' << 10 * std::sin(k * std::numbers::pi / 180)
            << '\n';
    const auto open = readText(arc.str(), kMm);
    EXPECT_EQ(codeOf(open), MessageCode::ContourOpen);
    EXPECT_NE(describe(open.error()).find("14.14 mm"), std::string::npos) << describe(open.error());
    EXPECT_TRUE(readText(arc.str() + "10,0\n", kMm)) << "closed on purpose by a repeated first point";
    EXPECT_TRUE(readText("0,0\n100,0\n100,1\n0,1\n", kMm));
    EXPECT_TRUE(readText("0,0\n0,1\n100,1\n100,0\n", kMm)) << "a long edge left out, another there";
    EXPECT_TRUE(readText("0,0\n10,0\n0,3\n", kMm));
    std::ostringstream circle;
    for (int k = 0; k < 350; ++k)
        circle << std::cos(k * std::numbers::pi / 180) << ',' << std::sin(k * std::numbers::pi / 180) << '\n';
    EXPECT_TRUE(readText(circle.str(), kMm)) << "ten steps missing";
}

TEST(ContourCsv, SixtyThousandPoints) {
    std::ostringstream text;
    text << "x_mm,y_mm\n";
    text.precision(12);
    for (const auto& p : test::wavy(60000, 12))
        text << 40 * p.x() << ',' << 40 * p.y() << '\n';
    const auto contour = readText(text.str());
    ASSERT_TRUE(contour) << describe(contour.error());
    EXPECT_EQ(contour->points_m.size(), 60000U);
}

TEST(ContourCsv, DamagedFilesNeverCrashAndAlwaysAnswer) {
    std::mt19937 random(3);
    const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    int ok = 0, refused = 0;
    const auto take = [&](const std::string& text) {
        const auto contour = readText(text, pick(2) ? std::optional(kMm) : std::nullopt);
        if (!contour) {
            ++refused;
            EXPECT_FALSE(describe(contour.error()).empty());
        } else {
            ++ok;
            EXPECT_GT(contourArea(*contour), 0.0);
        }
    };
    const std::string bom = fileText(test::dataPath("bunny_bom_closed.csv"));
    const std::string semicolon = fileText(test::dataPath("bunny_semicolon_comma.csv"));
    ASSERT_GT(bom.size(), 1000U);
    for (int trial = 0; trial < 600; ++trial) {
        std::string text = trial % 2 ? bom : semicolon;
        for (std::size_t k = pick(4); k < 4; ++k)
            text[pick(text.size())] =
                trial % 3 ? "0123456789.,;\t\n- e"[pick(18)] : static_cast<char>(random());
        take(text);
    }
    for (std::size_t length = 0; length < 300; length += 3)
        take(bom.substr(0, length));
    for (int trial = 0; trial < 60; ++trial)
        take(semicolon.substr(0, pick(semicolon.size())));
    EXPECT_GT(ok, 20);
    EXPECT_GT(refused, 100);
}

// Catches an ending that two formats claim, one that is not found again, and a refusal that leaves one out.
TEST(ContourImport, EveryEndingHasOneFormat) {
    const std::string all = outlineEndings();
    for (const OutlineFormat& format : outlineFormats())
        for (const std::string_view ending : format.endings) {
            EXPECT_EQ(outlineFormatOf("a." + std::string(ending)), &format) << ending;
            EXPECT_NE(all.find(ending), std::string::npos) << ending;
        }
    EXPECT_EQ(outlineFormatOf("a.pdf"), nullptr);
    EXPECT_EQ(outlineFormatOf("svg"), nullptr);
    EXPECT_EQ(outlineEndings("*.", " "),
              "*.svg *.dxf *.csv *.txt *.dat *.png *.jpg *.jpeg *.bmp *.tif *.tiff");
    EXPECT_EQ(outlineFormatNames(OutlineKind::Picture), "PNG, JPEG, BMP, TIFF");
}

TEST(ContourImport, ChoosesTheReaderByTheEnding) {
    EXPECT_EQ(codeOf(readContour("drawing.pdf", {})), MessageCode::FormatUnknown);
    for (const char* drawing : {"drawing.svg", "drawing.DXF"})
        EXPECT_EQ(codeOf(readContour(drawing, {})), MessageCode::FileNotFound) << drawing;
    EXPECT_EQ(codeOf(readContour("drawing", {})), MessageCode::FormatUnknown);
    EXPECT_EQ(codeOf(readContour("drawing.csv", {})), MessageCode::FileNotFound);
    EXPECT_EQ(codeOf(readContour("drawing.PNG", {})), MessageCode::ScaleMissing);
    EXPECT_EQ(codeOf(readContour("drawing.JPEG", {.scale_px_per_mm = 10.0})), MessageCode::FileNotFound);
}

TEST(LengthUnit, NamesGoThereAndBack) {
    for (const auto unit :
         {LengthUnit::Metre, LengthUnit::Centimetre, LengthUnit::Millimetre, LengthUnit::Inch})
        EXPECT_EQ(lengthUnitFromName(lengthUnitName(unit)), unit);
    EXPECT_EQ(lengthUnitFromName("MM"), LengthUnit::Millimetre);
    EXPECT_FALSE(lengthUnitFromName("furlong"));
    EXPECT_FALSE(lengthUnitFromName(""));
    EXPECT_DOUBLE_EQ(metresPer(LengthUnit::Inch), 0.0254);
}

} // namespace
} // namespace bask
