// `bask fit-contour`: its figures, its file, its exit codes.

#include "app/commands/command_line.h"

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/model/experiment.h"
#include "engine/shape/contour_import.h"
#include "engine/shape/fourier_contour.h"
#include "tests/engine/shape/shape_samples.h"
#include "tests/support/captured_command.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>
#include <QImage>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>

namespace bask {
namespace {

struct Outcome : test::Captured {
    std::map<std::string, double> figures() const {
        std::map<std::string, double> figures;
        std::istringstream in(out);
        std::string name;
        double value = 0.0;
        while (in >> name >> value)
            figures[name] = value;
        return figures;
    }
};

Outcome run(const QStringList& arguments) {
    return {test::captured(fitContourCommand, arguments)};
}

QString example(const char* name) {
    return QString::fromStdString(test::examplePath(name));
}
QString data(const char* name) {
    return QString::fromStdString(test::dataPath(name));
}

TEST(FitContourCommand, PrintsTheFiguresOfTheBunny) {
    const Outcome outcome = run({example("bunny_mm.csv"), "--harmonics", "5"});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_EQ(outcome.err, "");
    auto figures = outcome.figures();
    EXPECT_EQ(figures.size(), 10U);
    EXPECT_EQ(figures["net_area_mm2"], figures["area_mm2"]);
    EXPECT_EQ(figures["harmonics"], 5);
    EXPECT_NEAR(figures["area_error"], 2851.1269 / 2894.2338 - 1, 1e-6);
    EXPECT_GT(figures["hausdorff_mm"], 0.3 * figures["max_mm"]);
    EXPECT_LE(figures["hausdorff_mm"], figures["max_mm"]);
    EXPECT_NEAR(figures["area_mm2"], 2851.1269, 1e-3);
    EXPECT_NEAR(figures["rms_mm"], 2.49189, 1e-4);
    EXPECT_NEAR(figures["max_mm"], 5.92367, 0.02);
    EXPECT_NEAR(figures["perimeter_mm"], 233.593, 1e-2);
    EXPECT_NEAR(figures["outline_area_mm2"], 2894.2338, 1e-3);
    EXPECT_NEAR(figures["outline_perimeter_mm"], 284.3103, 1e-3);
}

TEST(FitContourCommand, TakesPicturesAndUnits) {
    auto picture = run({"--harmonics", "20", "--scale", "15", example("hand_1200.png")}).figures();
    EXPECT_NEAR(picture["outline_area_mm2"], 2326.74, 2.3);
    EXPECT_NEAR(picture["rms_mm"], 0.44885, 1e-3);
    auto list = run({data("bunny_semicolon_comma.csv"), "--harmonics=8", "--unit", "mm"}).figures();
    EXPECT_NEAR(list["rms_mm"], 1.38249, 1e-4);
}

TEST(FitContourCommand, WritesTheSeriesInMetres) {
    const std::string path = test::writeFile(".json", "");
    EXPECT_EQ(run({example("bunny_mm.csv"), "--harmonics", "3", "-o", QString::fromStdString(path)}).code,
              kExitDone);
    std::ifstream in(path);
    const auto json = nlohmann::json::parse(in);
    EXPECT_EQ(json.at("type"), "fourier");
    ASSERT_EQ(json.at("coefficients").size(), 7U);
    std::vector<std::complex<double>> c;
    for (const auto& row : json.at("coefficients")) {
        EXPECT_EQ(row.at(0), static_cast<int>(c.size()) - 3);
        c.emplace_back(row.at(1).get<double>(), row.at(2).get<double>());
    }
    EXPECT_NEAR(FourierContour(c).area() * 1e6, 2918.5881, 1e-3);
    std::filesystem::remove(path);
}

// Catches: a file of the user's, the input itself or a device replaced by the contour.
TEST(FitContourCommand, ReplacesNothingButAContour) {
    const std::string outline = test::writeFile(".csv", "x_mm,y_mm\n0,0\n50,0\n40,30\n0,40\n");
    const std::string notes = test::writeFile(".json", "{\"notes\": 1}");
    const std::string link = notes + ".link";
    std::filesystem::create_symlink(outline, link);
    for (const std::string& output : {outline, link, notes, std::string("/dev/null"),
                                      std::string("/dev/stdout"), std::string("/tmp"), std::string()}) {
        const auto before = std::filesystem::file_size(notes) + std::filesystem::file_size(outline);
        const Outcome outcome =
            run({QString::fromStdString(outline), "--harmonics", "1", "-o", QString::fromStdString(output)});
        EXPECT_EQ(outcome.code, kExitBadInput) << output;
        EXPECT_EQ(outcome.out, "") << output;
        EXPECT_NE(outcome.err.find(output), std::string::npos) << outcome.err;
        EXPECT_EQ(std::filesystem::file_size(notes) + std::filesystem::file_size(outline), before) << output;
    }
    const std::string contour = test::writeFile(".json", "");
    for (int i = 0; i < 2; ++i)
        EXPECT_EQ(
            run({QString::fromStdString(outline), "--harmonics", "1", "-o", QString::fromStdString(contour)})
                .code,
            kExitDone)
            << "its own contour is replaced";
    for (const std::string& path : {outline, link, notes, contour})
        std::filesystem::remove(path);
}

// Catches names and order that scripts rely on.
TEST(FitContourCommand, ListsTheOutlines) {
    const Outcome outcome = run({example("bunny_mm.csv"), "--list"});
    EXPECT_EQ(outcome.code, kExitDone) << outcome.err;
    const auto list = nlohmann::json::parse(outcome.out);
    ASSERT_TRUE(list.is_array());
    ASSERT_EQ(list.size(), 1U);
    const auto& only = list[0];
    EXPECT_EQ(only.size(), 6U);
    EXPECT_EQ(only.at("index"), 0);
    EXPECT_EQ(only.at("closed"), true);
    EXPECT_EQ(only.at("hole"), false);
    EXPECT_NEAR(only.at("area_mm2"), 2894.2338, 1e-3);
    EXPECT_NEAR(only.at("perimeter_mm"), 284.3103, 1e-3);
    const std::array box{0.0, 0.0, 70.0, 68.237672};
    for (std::size_t k = 0; k < 4; ++k)
        EXPECT_NEAR(only.at("bbox_mm").at(k), box[k], 1e-6);
}

/// Two squares of 30 and 20 mm at 10 px/mm, a hole of 10 mm in the larger one, as a BMP.
std::string twoSquares() {
    const int width = 700, height = 400;
    std::string bmp("BM");
    const auto put = [&](std::uint32_t value, int bytes) {
        for (int k = 0; k < bytes; ++k)
            bmp += static_cast<char>(value >> 8 * k & 0xFFU);
    };
    put(54 + 3 * width * height, 4);
    put(0, 4);
    put(54, 4);
    put(40, 4);
    put(width, 4);
    put(height, 4);
    put(1, 2);
    put(24, 2);
    for (int k = 0; k < 6; ++k)
        put(0, 4);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const auto within = [&](int x0, int y0, int side) {
                return x >= x0 && x < x0 + side && y >= y0 && y < y0 + side;
            };
            const bool dark = (within(50, 50, 300) && !within(150, 150, 100)) || within(450, 100, 200);
            put(dark ? 0x202020 : 0xF0F0F0, 3);
        }
    return test::writeFile(".bmp", bmp);
}

// Catches the wrong outline picked, and others or holes left out without a word.
TEST(FitContourCommand, PicksOneOfSeveral) {
    const QString file = QString::fromStdString(twoSquares());
    const auto list = nlohmann::json::parse(run({file, "--list", "--scale", "10"}).out);
    ASSERT_EQ(list.size(), 3U);
    const std::array areas{900.0, 400.0, 100.0};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(list[k].at("index"), k);
        EXPECT_NEAR(list[k].at("area_mm2"), areas[k], 0.02 * areas[k]) << "corners are rounded";
        EXPECT_EQ(list[k].at("hole"), k == 2);
    }
    const Outcome first = run({file, "--harmonics", "8", "--scale", "10"});
    EXPECT_NEAR(first.figures()["outline_area_mm2"], 900.0, 9.0);
    EXPECT_NE(first.err.find("2 outlines"), std::string::npos) << first.err;
    auto figures = first.figures();
    EXPECT_NEAR(figures["area_mm2"] - figures["net_area_mm2"], 100.0, 2.0);
    const Outcome second = run({file, "--harmonics", "8", "--scale", "10", "--pick", "1"});
    EXPECT_NEAR(second.figures()["outline_area_mm2"], 400.0, 6.0);
    EXPECT_EQ(second.err, "");
    const Outcome beyond = run({file, "--harmonics", "8", "--scale", "10", "--pick", "3"});
    EXPECT_EQ(beyond.code, kExitBadInput);
    EXPECT_NE(beyond.err.find("0 to 2"), std::string::npos) << beyond.err;
}

// Catches a scale by a known length and a colour that do not reach the reader.
// Catches a unit that a drawing without one does not heed, one that overrides a drawing's own, and a factor
// for nothing.
TEST(FitContourCommand, TakesAUnitAndAFactorForDrawings) {
    const auto width_m = [](const char* name, const ContourImportOptions& options) {
        const auto file = readOutlines(test::dataPath(name), options);
        double min = 1e9, max = -1e9;
        for (const auto& p : file.value().outlines[0].points_m) {
            min = std::min(min, p.x());
            max = std::max(max, p.x());
        }
        return max - min;
    };
    const double px_m = width_m("svg/leaf_maple_mdi.svg", {});
    EXPECT_NEAR(width_m("svg/leaf_maple_mdi.svg", {.unit = LengthUnit::Millimetre}), px_m * 96.0 / 25.4,
                1e-9);
    EXPECT_NEAR(width_m("svg/leaf_maple_mdi.svg", {.factor = 2.0}), 2.0 * px_m, 1e-12);
    const double mm_m = width_m("svg/bunny_mm.svg", {});
    EXPECT_NEAR(width_m("svg/bunny_mm.svg", {.unit = LengthUnit::Inch}), mm_m, 1e-12);
    EXPECT_EQ(
        readOutlines(test::dataPath("svg/bunny_mm.svg"), {.unit = LengthUnit::Inch})->warnings.back().code,
        MessageCode::UnitNotUsed);
    EXPECT_EQ(readOutlines(test::dataPath("svg/bunny_mm.svg"), {.factor = 0.0}).error().code(),
              MessageCode::ValueNotPositive);
}

TEST(FitContourCommand, TakesAKnownLengthAndAColour) {
    const QString file = QString::fromStdString(twoSquares());
    auto figures =
        run({file, "--harmonics", "8", "--known-length", "50,50,350,50,15", "--colour", "#222222"}).figures();
    EXPECT_NEAR(figures["outline_area_mm2"], 225.0, 3.0);
    figures = run({file, "--harmonics", "8", "--known-length", "50,50,350,50,15", "--colour", "#202020",
                   "--colour-tolerance", "10"})
                  .figures();
    EXPECT_NEAR(figures["outline_area_mm2"], 225.0, 3.0);
}

// Catches a fit reported beyond its tolerance, or with more harmonics than it needs.
TEST(FitContourCommand, FindsTheNumberOfHarmonics) {
    auto found = run({example("bunny_mm.csv"), "--harmonics", "auto", "--tolerance", "0.7"}).figures();
    EXPECT_LE(found["hausdorff_mm"], 0.7);
    const int harmonics = static_cast<int>(found["harmonics"]);
    ASSERT_GT(harmonics, 1);
    auto fewer = run({example("bunny_mm.csv"), "--harmonics", QString::number(harmonics - 1)}).figures();
    EXPECT_GT(fewer["hausdorff_mm"], 0.7);
}

// Catches a report that lacks a name, has the wrong unit, or is not what the fit left.
TEST(FitContourCommand, ReportsAsJson) {
    const Outcome outcome = run({example("hand_mm.csv"), "--harmonics", "5", "--json"});
    ASSERT_EQ(outcome.code, kExitDone);
    const auto json = nlohmann::json::parse(outcome.out);
    for (const char* name :
         {"type", "outline", "coefficients", "area_mm2", "perimeter_mm", "rms_mm", "max_mm", "hausdorff_mm",
          "area_error", "centre_mm", "unit", "warnings", "net_area_mm2", "holes"})
        EXPECT_TRUE(json.contains(name)) << name;
    EXPECT_EQ(json.size(), 14U);
    EXPECT_TRUE(json.at("holes").empty());
    EXPECT_EQ(json.at("outline").size(), 769U);
    EXPECT_EQ(json.at("unit"), "mm");
    EXPECT_NEAR(json.at("rms_mm"), 5.33114, 1e-3);
    ASSERT_EQ(json.at("warnings").size(), 1U);
    EXPECT_NE(json.at("warnings")[0].get<std::string>().find("crosses itself"), std::string::npos);
    double max_mm = 0.0;
    for (const auto& point : json.at("outline"))
        max_mm = std::max(max_mm, point.at(0).get<double>());
    EXPECT_NEAR(max_mm, 70.0, 1e-9) << "in the file's coordinates";
}

// Catches a file that Bask writes and cannot read.
TEST(FitContourCommand, WritesWhatExperimentsRead) {
    const std::string path = test::writeFile(".json", "");
    ASSERT_EQ(run({example("bunny_mm.csv"), "--harmonics", "9", "-o", QString::fromStdString(path)}).code,
              kExitDone);
    std::ifstream contour(path), base(BASK_EXAMPLES "/two-circles.json");
    auto experiment = nlohmann::json::parse(base);
    experiment.at("objects").at(0).at("contour") = nlohmann::json::parse(contour);
    const auto read = experimentFromJson(experiment.dump(), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_NEAR(std::get<FourierContour>(read->objects.at(0).shape).area() * 1e6, 2890.0, 20.0);
    std::filesystem::remove(path);
}

/// A plate of 50 x 50 mm with a corner off, and a hole of 4 x 10 mm off its middle.
QString piercedPlate() {
    return QString::fromStdString(test::writeFile(
        ".svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>"
                "<path d='M10,90 L60,90 L60,60 L40,40 L10,40 Z M20,50 h4 v10 h-4 z'/></svg>"));
}

// Catches holes that are left out, counted in the outline's own area, not in the file's coordinates, or not
// at their place in the contour that experiments read.
TEST(FitContourCommand, HolesComeAlong) {
    const QString path = QString::fromStdString(test::writeFile(".json", ""));
    const Outcome outcome = run({piercedPlate(), "--harmonics", "12", "--json", "-o", path});
    ASSERT_EQ(outcome.code, kExitDone) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const auto json = nlohmann::json::parse(outcome.out);
    const double area = json.at("area_mm2");
    EXPECT_NEAR(area, 2300.0, 20.0);
    EXPECT_NEAR(json.at("net_area_mm2"), area - 40.0, 1e-6);
    ASSERT_EQ(json.at("holes").size(), 1U);
    double x = 0.0, y = 0.0;
    for (const auto& point : json.at("holes")[0]) {
        x += point.at(0).get<double>() / 4;
        y += point.at(1).get<double>() / 4;
    }
    std::ifstream contour(path.toStdString()), base(BASK_EXAMPLES "/two-circles.json");
    auto experiment = nlohmann::json::parse(base);
    experiment.at("objects").at(0).at("contour") = nlohmann::json::parse(contour);
    const auto read = experimentFromJson(experiment.dump(), "", "");
    ASSERT_TRUE(read) << describe(read.error());
    const Shape& shape = read->objects.at(0).shape;
    EXPECT_NEAR(shapeArea(shape) * 1e6, area - 40.0, 1e-6);
    const Eigen::Vector2d middle = 1e3 * contourCentroid(holesOf(shape).at(0));
    EXPECT_NEAR(middle.x() + json.at("centre_mm").at(0).get<double>(), x, 1e-9);
    EXPECT_NEAR(middle.y() + json.at("centre_mm").at(1).get<double>(), y, 1e-9);
    EXPECT_LT(middle.x(), -8.0) << "the hole is left of the middle";
}

// Catches a fit that is said to be good although no experiment takes it.
TEST(FitContourCommand, WarnsOfAFitThatCutsAHole) {
    const std::string thin = test::writeFile(
        ".svg", "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' viewBox='0 0 100 100'>"
                "<path d='M10,10 h50 v50 h-50 z M11,11 v10 h10 v-10 z'/></svg>");
    const Outcome outcome = run({QString::fromStdString(thin), "--harmonics", "3"});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_NE(outcome.err.find("cuts a hole"), std::string::npos) << outcome.err;
    EXPECT_EQ(run({QString::fromStdString(thin), "--harmonics", "40"}).err, "");
}

// Catches a preview that fills the holes.
TEST(FitContourCommand, PreviewLeavesHolesOpen) {
    const QString path = QString::fromStdString(test::writeFile(".png", ""));
    ASSERT_EQ(run({piercedPlate(), "--harmonics", "12", "--preview", path}).code, kExitDone);
    const QImage image(path);
    // 50 mm are 850 px; the hole's middle lies 13 mm left of and 10 mm above the plate's.
    const auto isFilled = [&](double x_mm, double y_mm) {
        const QColor c =
            image.pixelColor(500 + static_cast<int>(17 * x_mm), 500 - static_cast<int>(17 * y_mm));
        return c.red() < c.blue() && c.red() < 0xDD;
    };
    EXPECT_FALSE(isFilled(-13.0, 10.0));
    EXPECT_FALSE(isFilled(-12.0, 14.0));
    EXPECT_TRUE(isFilled(-17.0, 10.0));
    EXPECT_TRUE(isFilled(-13.0, 3.0));
}

// Catches an empty picture, one that shows outline and fit apart, and a photograph replaced by it.
TEST(FitContourCommand, DrawsAPreview) {
    const QString path = QString::fromStdString(test::writeFile(".png", ""));
    for (int k = 0; k < 2; ++k) // the second replaces the first
        EXPECT_EQ(run({example("bunny_mm.csv"), "--harmonics", "20", "--preview", path}).code, kExitDone);
    const QImage image(path);
    ASSERT_EQ(image.size(), QSize(1000, 1000));
    int red = 0, filled = 0;
    QRect box;
    for (int y = 0; y < 1000; ++y)
        for (int x = 0; x < 1000; ++x) {
            const QColor c = image.pixelColor(x, y);
            red += c.red() > c.green() + 60;
            filled += c.red() < c.blue() && c.red() < 0xDD;
            if (c.red() > c.green() + 60)
                box |= QRect(x, y, 1, 1);
        }
    EXPECT_NEAR(box.width(), 850, 15);
    EXPECT_NEAR(box.center().x(), 500, 8);
    EXPECT_GT(red, 3000);
    EXPECT_NEAR(filled, 2894.23 * std::pow(850 / 70.0, 2), 0.05 * 427000) << "the area to scale";

    const QString photo = QString::fromStdString(testing::TempDir() + "bask_photo.png");
    QFile::remove(photo);
    QFile::copy(example("hand_1200.png"), photo);
    const auto size = QFileInfo(photo).size();
    const Outcome outcome = run({example("bunny_mm.csv"), "--harmonics", "20", "--preview", photo});
    EXPECT_EQ(outcome.code, kExitBadInput);
    EXPECT_EQ(QFileInfo(photo).size(), size);
    EXPECT_EQ(run({photo, "--harmonics", "20", "--scale", "15", "--preview", photo}).code, kExitBadInput);
    EXPECT_EQ(run({example("bunny_mm.csv"), "--harmonics", "20", "--preview", path, "-o", path}).code,
              kExitBadInput);
    QFile::remove(photo);
    QFile::remove(path);
}

TEST(FitContourCommand, WarnsOfACurveThatCrossesItself) {
    const Outcome outcome = run({example("hand_mm.csv"), "--harmonics", "5"});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_NE(outcome.err.find("crosses itself"), std::string::npos);
}

TEST(FitContourCommand, HelpNamesEveryOption) {
    const Outcome outcome = run({"--help"});
    EXPECT_EQ(outcome.code, kExitDone);
    for (const char* word :
         {"bask fit-contour [options] FILE", "--list", "--pick", "--harmonics", "--tolerance", "--unit",
          "--scale", "--known-length", "--marker-size", "--marker-dictionary", "--colour",
          "--colour-tolerance", "--json", "--output", "--preview"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
}

TEST(FitContourCommand, BadInputIsExplainedOnStandardErrorWithCode2) {
    const QStringList cases[] = {
        {},
        {example("bunny_mm.csv")},
        {example("bunny_mm.csv"), "--harmonics", "five"},
        {example("bunny_mm.csv"), "--harmonics", "0"},
        {example("bunny_mm.csv"), "--harmonics", "41"},
        {example("bunny_mm.csv"), "--harmonics", "5", "--unit", "furlong"},
        {example("bunny_mm.csv"), "--harmonics", "5", "--colour", "red"},
        {example("bunny_mm.csv"), example("hand_mm.csv"), "--harmonics", "5"},
        {example("bunny_1200.png"), "--harmonics", "5"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "0"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "much"},
        {example("bunny_mm.csv"), "--harmonics", "5", "-o", "/no/such/folder/contour.json"},
        {data("bad_collinear.csv"), "--harmonics", "5", "--unit", "mm"},
        {data("bunny_tab_noheader.txt"), "--harmonics", "5"},
        {"/no/such/file.csv", "--harmonics", "5"},
        {"/no/such/file.csv", "--list"},
        {example("bunny_mm.csv"), "--list", "-o", "x.json"},
        {example("bunny_mm.csv"), "--harmonics", "5", "--pick", "1"},
        {example("bunny_mm.csv"), "--harmonics", "5", "--pick", "-1"},
        {example("bunny_mm.csv"), "--harmonics", "5", "--pick", "one"},
        {example("bunny_mm.csv"), "--harmonics", "auto"},
        {example("bunny_mm.csv"), "--harmonics", "auto", "--tolerance", "0"},
        {example("bunny_mm.csv"), "--harmonics", "auto", "--tolerance", "0.0001"},
        {example("bunny_1200.png"), "--harmonics", "5", "--known-length", "0,0,1200,0"},
        {example("bunny_1200.png"), "--harmonics", "5", "--known-length", "0,0,0,0,80"},
        {example("bunny_1200.png"), "--harmonics", "5", "--known-length", "0,0,1200,0,80", "--scale", "15"},
        {example("bunny_1200.png"), "--harmonics", "5", "--marker-size", "40"},
        {example("bunny_1200.png"), "--harmonics", "5", "--marker-size", "-1"},
        {example("bunny_1200.png"), "--harmonics", "5", "--marker-size", "40", "--marker-dictionary", "9X9"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "15", "--marker-dictionary", "4X4_50"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "15", "--colour", "#12345"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "15", "--colour-tolerance", "9"},
        {example("bunny_1200.png"), "--harmonics", "5", "--scale", "15", "--colour", "#00ff00"},
    };
    for (const QStringList& arguments : cases) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_EQ(outcome.out, "") << arguments.join(' ').toStdString();
        EXPECT_GT(outcome.err.size(), 30U) << arguments.join(' ').toStdString();
    }
}

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
