// `bask thermal-frame`: its figures, words and exit codes, on frames of make_frames.py.

#include "app/commands/command_line.h"
#include "tests/support/captured_command.h"

#include <QFile>
#include <QTemporaryDir>

#include <nlohmann/json.hpp>

#include <fstream>

namespace bask {
namespace {

using Json = nlohmann::json;
using test::Captured;

Captured thermalFrame(const QStringList& arguments) {
    return test::captured(thermalFrameCommand, arguments);
}

QString frame(const std::string& name) {
    return QStringLiteral(BASK_FRAMES "/") + QString::fromStdString(name);
}

QStringList withProfile(const Json& one, QStringList arguments) {
    if (one["profile"].is_null())
        return arguments;
    const auto name = one["profile"].get<std::string>();
    return arguments << "--profile" << (name.ends_with(".json") ? frame(name) : QString::fromStdString(name));
}

const Json& expectedFrames() {
    static const Json kExpected = [] {
        std::ifstream file(BASK_FRAMES "/expected.json");
        return Json::parse(file);
    }();
    return kExpected;
}

QString written(const QTemporaryDir& folder, const char* name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
}

constexpr const char* kRegions = R"({"regions": [
    {"name": "disk", "polygon_px": [[54, 62], [74, 62], [74, 82], [54, 82]]},
    {"name": "ground", "polygon_px": [[100, 5], [150, 5], [150, 30], [100, 30]]}]})";

} // namespace

// Catches: other keys, other figures, and a frame that fails for its kind of file.
TEST(ThermalFrameCommand, tellsTheSizeAndTheTemperaturesAsJson) {
    for (const auto& [name, one] : expectedFrames()["good"].items()) {
        SCOPED_TRACE(name);
        const Captured done = thermalFrame(withProfile(one, {frame(name), "--json"}));
        ASSERT_EQ(done.code, kExitDone) << done.err;
        const Json told = Json::parse(done.out);
        EXPECT_EQ(told.size(), 5U) << done.out;
        EXPECT_EQ(told["width"], one["width"]);
        EXPECT_EQ(told["height"], one["height"]);
        for (const char* key : {"min_degC", "max_degC", "mean_degC"})
            EXPECT_NEAR(told[key].get<double>(), one[key].get<double>(), 2e-9) << key;
        EXPECT_EQ(std::ranges::count(done.err, '\n'), one["warnings"].get<int>()) << done.err;
    }
}

// Catches: a frame that does not fit and is taken, or is refused without its name.
TEST(ThermalFrameCommand, refusesWhatDoesNotFit) {
    for (const auto& [name, one] : expectedFrames()["bad"].items()) {
        SCOPED_TRACE(name);
        const Captured done = thermalFrame(withProfile(one, {frame(name), "--json"}));
        EXPECT_EQ(done.code, kExitBadInput);
        EXPECT_TRUE(done.out.empty()) << done.out;
        EXPECT_NE(done.err.find(name), std::string::npos) << done.err;
    }
}

TEST(ThermalFrameCommand, withoutJsonItIsASentence) {
    const Captured done = thermalFrame({frame("lepton.raw"), "--profile", "lepton-3.5"});
    EXPECT_EQ(done.code, kExitDone);
    EXPECT_TRUE(done.out.starts_with("160 x 120 pixels, ")) << done.out;
    EXPECT_NE(done.out.find(" degC, mean "), std::string::npos) << done.out;
}

// Catches: regions whose rows and columns are exchanged, and keys that come unasked.
TEST(ThermalFrameCommand, tellsTheStatisticsOfRegions) {
    const QTemporaryDir folder;
    const QString regions = written(folder, "regions.json", kRegions);
    const Captured done =
        thermalFrame({frame("lepton.raw"), "--profile", "lepton-3.5", "--json", "--regions", regions});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    const Json told = Json::parse(done.out);
    ASSERT_EQ(told["regions"].size(), 2U);
    const Json &disk = told["regions"][0], &ground = told["regions"][1];
    EXPECT_EQ(disk["name"], "disk");
    EXPECT_NEAR(disk["mean_degC"].get<double>(), 60.0, 0.02); // the scene's disk is at 333.15 K +-0.11
    EXPECT_LT(ground["mean_degC"].get<double>(), 35.0);
    EXPECT_NEAR(disk["pixels"].get<int>(), 400, 41);
    EXPECT_GT(ground["largest_difference_K"]["value"].get<double>(),
              5 * disk["largest_difference_K"]["value"].get<double>());
    const Captured words =
        thermalFrame({frame("lepton.raw"), "--profile", "lepton-3.5", "--regions", regions});
    EXPECT_NE(words.out.find("disk: 60.0"), std::string::npos) << words.out;
}

// Catches: a region beyond the picture's edge that passes for a whole one, and one at its edge that does not.
TEST(ThermalFrameCommand, tellsRegionsThatArePartlyOutside) {
    const QTemporaryDir folder;
    const QString regions = written(folder, "r.json", R"({"regions": [
        {"name": "all", "polygon_px": [[-0.5, -0.5], [159.5, -0.5], [159.5, 119.5], [-0.5, 119.5]]},
        {"name": "over", "polygon_px": [[100, 90], [150, 90], [150, 121], [100, 121]]}]})");
    const QStringList lepton{frame("lepton.raw"), "--profile", "lepton-3.5", "--regions", regions};
    const Captured done = thermalFrame(lepton + QStringList{"--json"});
    ASSERT_EQ(done.code, kExitDone) << done.err;
    const Json told = Json::parse(done.out);
    EXPECT_EQ(told["regions"][0]["pixels"], 160 * 120);
    EXPECT_EQ(told["regions"][0]["partly_outside"], false);
    EXPECT_EQ(told["regions"][1]["partly_outside"], true);
    const Captured words = thermalFrame(lepton);
    EXPECT_EQ(words.out.find("outside of the picture"), words.out.rfind("outside of the picture"));
    EXPECT_NE(words.out.find("outside of the picture"), std::string::npos) << words.out;
}

// Catches: a frame that is not the one asked for, and one that is taken unasked.
TEST(ThermalFrameCommand, ofSeveralFramesOneIsChosen) {
    std::ifstream file(BASK_FRAMES "/three.json");
    const Json middle_degC = Json::parse(file);
    const QTemporaryDir folder;
    const QString regions = written(folder, "r.json", R"({"regions": [{"name": "middle",
        "polygon_px": [[76.5, 56.5], [83.5, 56.5], [83.5, 63.5], [76.5, 63.5]]}]})");
    for (const char* name : {"three.raw", "three.tif"}) {
        const QStringList several{frame(name), "--profile", "lepton-3.5"};
        for (int k = 1; k <= 3; ++k) {
            const Captured done = thermalFrame(
                several + QStringList{"--frame", QString::number(k), "--json", "--regions", regions});
            ASSERT_EQ(done.code, kExitDone) << done.err;
            const Json told = Json::parse(done.out);
            EXPECT_EQ(told["frame"], k);
            EXPECT_EQ(told["frames"], 3);
            EXPECT_NEAR(told["regions"][0]["mean_degC"].get<double>(),
                        middle_degC[static_cast<std::size_t>(k - 1)].get<double>(), 0.2);
        }
        EXPECT_TRUE(thermalFrame(several + QStringList{"--frame", "2"}).out.starts_with("frame 2 of 3: "));
        for (const char* wrong : {"0", "4", "-1", "1.5", "first", ""}) {
            const Captured refused = thermalFrame(several + QStringList{"--frame", wrong});
            EXPECT_EQ(refused.code, kExitBadInput) << wrong;
            EXPECT_NE(refused.err.find("holds 3"), std::string::npos) << refused.err;
        }
        const Captured unasked = thermalFrame(several);
        EXPECT_EQ(unasked.code, kExitBadInput);
        EXPECT_NE(unasked.err.find("holds 3"), std::string::npos) << unasked.err;
        EXPECT_NE(unasked.err.find("--frame"), std::string::npos) << unasked.err;
    }
    EXPECT_TRUE(thermalFrame({frame("comma.csv"), "--frame", "1"}).out.starts_with("frame 1 of 1: "));
}

// Catches: a maximum of a saturated picture, and a region without a temperature that passes for one.
TEST(ThermalFrameCommand, saturatedPixelsMakeInvalidNotWrong) {
    const QStringList saturated{frame("saturated.raw"), "--profile", "lepton-3.5", "--json"};
    const Captured refused = thermalFrame(saturated);
    EXPECT_EQ(refused.code, kExitBadInput);
    EXPECT_NE(refused.err.find("column 150, row 3"), std::string::npos) << refused.err;
    const QTemporaryDir folder;
    const Captured done =
        thermalFrame(saturated + QStringList{"--regions", written(folder, "r.json", kRegions)});
    EXPECT_EQ(done.code, kExitNegative);
    const Json told = Json::parse(done.out);
    EXPECT_TRUE(told["max_degC"].is_null());
    EXPECT_NE(told["regions"][0]["invalid"].get<std::string>().find("saturated"), std::string::npos);
    EXPECT_FALSE(told["regions"][0].contains("mean_degC"));
    EXPECT_TRUE(told["regions"][1].contains("mean_degC"));
}

TEST(ThermalFrameCommand, refusesRegionsThatAreNone) {
    const QTemporaryDir folder;
    const QByteArray triangle = "\"polygon_px\": [[0, 0], [9, 9], [0, 9]]", a = "{\"name\": \"a\", ";
    const QByteArray refused[] = {"",
                                  "{}",
                                  "{\"regions\": []}",
                                  "{\"regions\": [{\"name\": \"a\"}]}",
                                  "{\"regions\": [" + a + "\"polygon_px\": [[0, 0], [1, 1]]}]}",
                                  "{\"regions\": [" + a + "\"polygon_px\": [[0, 0], [1, 1], [\"2\", 0]]}]}",
                                  "{\"regions\": [{\"name\": \"\", " + triangle + "}]}",
                                  "{\"regions\": [{\"name\": \"a\\u202eb\", " + triangle + "}]}",
                                  "{\"regions\": [{\"name\": \"a\\u001b[31m\", " + triangle + "}]}",
                                  "{\"regions\": [" + a + triangle + ", \"colour\": 1}]}",
                                  "{\"regions\": [" + a + triangle + "}, " + a + triangle + "}]}"};
    for (const QByteArray& text : refused) {
        const Captured done = thermalFrame(
            {frame("lepton.raw"), "--profile", "lepton-3.5", "--regions", written(folder, "r.json", text)});
        EXPECT_EQ(done.code, kExitBadInput) << text.toStdString();
        EXPECT_NE(done.err.find("r.json"), std::string::npos) << done.err;
        EXPECT_TRUE(done.out.empty());
    }
    const Captured outside = thermalFrame(
        {frame("lepton.raw"), "--profile", "lepton-3.5", "--regions",
         written(folder, "o.json",
                 "{\"regions\": [{\"name\": \"a\", \"polygon_px\": [[200, 0], [209, 9], [200, 9]]}]}")});
    EXPECT_EQ(outside.code, kExitNegative);
    EXPECT_NE(outside.out.find("a: it is not in the picture"), std::string::npos) << outside.out;
}

TEST(ThermalFrameCommand, complaintsAreOneSentence) {
    for (const QStringList& arguments : {QStringList{}, QStringList{frame("lepton.raw")},
                                         QStringList{frame("lepton.raw"), "--profile", "lepton"},
                                         QStringList{frame("lepton.raw"), "--profile", "gone.json"},
                                         QStringList{frame("gone.raw"), "--profile", "tc001"},
                                         QStringList{frame("lepton.raw"), "--profile", frame("lepton.raw")},
                                         QStringList{frame("folder"), "--profile", "tc001"},
                                         QStringList{frame("lepton.raw"), "--frobnicate"}}) {
        const Captured done = thermalFrame(arguments);
        EXPECT_EQ(done.code, kExitBadInput) << arguments.join(' ').toStdString();
        EXPECT_TRUE(done.out.empty());
        EXPECT_EQ(std::ranges::count(done.err, '\n'), 1) << done.err;
    }
}

} // namespace bask
