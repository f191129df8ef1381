// `bask fit-contour`: its figures, its file, its exit codes.

#include "app/commands/command_line.h"

#include "engine/shape/fourier_contour.h"
#include "tests/engine/shape/shape_samples.h"
#include "tests/support/captured_command.h"

#include <QCoreApplication>

#include <nlohmann/json.hpp>

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
    EXPECT_EQ(figures.size(), 6U);
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

TEST(FitContourCommand, WarnsOfACurveThatCrossesItself) {
    const Outcome outcome = run({example("hand_mm.csv"), "--harmonics", "5"});
    EXPECT_EQ(outcome.code, kExitDone);
    EXPECT_NE(outcome.err.find("crosses itself"), std::string::npos);
}

TEST(FitContourCommand, HelpNamesEveryOption) {
    const Outcome outcome = run({"--help"});
    EXPECT_EQ(outcome.code, kExitDone);
    for (const char* word :
         {"bask fit-contour [options] FILE", "--harmonics", "--unit", "--scale", "--output"})
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
