// Uneven sources in experiment files: round trips, profiles from CSV files, what is refused.

#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/radial_profile_file.h"
#include "engine/model/uneven_source.h"
#include "tests/engine/recording/recording.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <QFile>
#include <QTemporaryDir>

namespace bask {
namespace {

using nlohmann::json;

json withSource(const char* key, const char* value) {
    json j = json::parse(experimentToJson(test::twoDisks()));
    j["source"][key] = json::parse(value);
    return j;
}

Error refusedSource(const char* key, const char* value, const std::string& folder = "/nowhere") {
    const auto read = experimentFromJson(withSource(key, value).dump(), "e.json", folder);
    EXPECT_FALSE(read) << value;
    return read ? Error() : read.error();
}

constexpr const char* kTwoHalves = R"([
  {"contour": {"type": "polygon", "points_m": [[-0.05, -0.05], [0, -0.05], [0, 0.05], [-0.05, 0.05]]},
   "temperature_ratio": 0.9},
  {"contour": {"type": "polygon", "points_m": [[0, -0.05], [0.05, -0.05], [0.05, 0.05], [0, 0.05]]},
   "emittance": 0.5, "temperature_offset_K": -12.5}])";

} // namespace

// Catches: a part that is moved to its centroid, so that both halves lie on one another, or a value that is
// lost in the file.
TEST(UnevenSourceFile, PartsStayWhereTheyAreWritten) {
    for (const char* place : {"source", "simulation"}) {
        json j = json::parse(experimentToJson(test::twoDisks()));
        j[place][place == std::string("source") ? "parts" : "source_parts"] = json::parse(kTwoHalves);
        const auto read = experimentFromJson(j.dump(), "e.json", "");
        ASSERT_TRUE(read) << describe(read.error());
        const Unevenness& uneven =
            place == std::string("source") ? read->source.uneven : *read->simulation.sourceUneven;
        ASSERT_EQ(uneven.parts.size(), 2U);
        EXPECT_EQ(shapeOutline(uneven.parts[1].shape, 4)[1], Eigen::Vector2d(0.05, -0.05));
        EXPECT_EQ(uneven.parts[0].temperatureRatio, 0.9);
        EXPECT_EQ(uneven.parts[1].temperatureOffset_K, -12.5);
        EXPECT_EQ(uneven.parts[1].emittance, 0.5);
        EXPECT_FALSE(uneven.parts[0].emittance);
        const auto again = experimentFromJson(experimentToJson(*read), "e.json", "");
        ASSERT_TRUE(again);
        EXPECT_EQ(*again, *read);
        EXPECT_EQ(experimentToJson(*again), experimentToJson(*read));
    }
}

TEST(UnevenSourceFile, AProfileIsReadTypedOrFromAFile) {
    const QTemporaryDir folder;
    QFile file(folder.filePath("plate.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(
        "# a scan\r\nradius_mm,note,temperature_offset_K\r\n0,middle,1.5\r\n\r\n40,,0\r\n80,rim,-20\r\n");
    file.close();
    const auto read = experimentFromJson(withSource("profile_file", "\"plate.csv\"").dump(), "e.json",
                                         folder.path().toStdString());
    ASSERT_TRUE(read) << describe(read.error());
    const std::vector<ProfilePoint> expected{{0.0, 1.0, 1.5}, {0.04, 1.0, 0.0}, {0.08, 1.0, -20.0}};
    EXPECT_EQ(read->source.uneven.profile, expected);
    const auto typed = experimentFromJson(experimentToJson(*read), "e.json", "/nowhere"); // self-contained
    ASSERT_TRUE(typed) << describe(typed.error());
    EXPECT_EQ(*typed, *read);

    const auto commas = radialProfile("radius_cm;temperature_ratio\n0;1,05\n8;0,9\n", "p.csv");
    ASSERT_TRUE(commas);
    EXPECT_EQ((*commas)[0].temperatureRatio, 1.05);
    EXPECT_DOUBLE_EQ((*commas)[1].radius_m, 0.08);
}

TEST(UnevenSourceFile, RefusesBadFilesWithTheLine) {
    const auto refused = [](const std::string& text) {
        const auto read = radialProfile(text, "p.csv");
        EXPECT_FALSE(read) << text;
        return read ? Error() : read.error();
    };
    for (const char* text :
         {"", "\n\n", "# nothing\n", "0,1\n1,2\n", "radius_mm\n0\n", "radius,temperature_ratio\n0,1\n",
          "radius_mm,radius_m,temperature_ratio\n0,0,1\n",
          "radius_mm,temperature_ratio,temperature_ratio\n0,1,0.5\n", "\xff\xfe\x01"})
        EXPECT_EQ(refused(text).code(), MessageCode::ProfileHeader) << text;
    const std::string header = "radius_mm,temperature_ratio\n";
    for (const char* line : {"0", "0,", "0,x", "0,1e999", "nan,1", "0,inf", "0 1", "0;1", "0,1 K"}) {
        const Error error = refused(header + "0,1\n" + line + "\n");
        EXPECT_EQ(error.code(), MessageCode::ProfileLine) << line;
        EXPECT_NE(describe(error).find("line 3"), std::string::npos) << describe(error);
    }
    EXPECT_EQ(refused(header).code(), MessageCode::SourcePartsNone);

    const QTemporaryDir folder;
    QFile file(folder.filePath("huge.csv"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(header.c_str()) + QByteArray("1,1\n").repeated(300'000));
    file.close();
    Error error = refusedSource("profile_file", "\"huge.csv\"", folder.path().toStdString());
    EXPECT_EQ(error.code(), MessageCode::FileTooLarge);
    EXPECT_EQ(error.where.rfind("e.json: source.profile_file", 0), 0U) << error.where;
    file.resize(0);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(header.c_str()));
    for (int k = 0; k < 201; ++k)
        file.write(QByteArray::number(0.1 * k) + ",1\n");
    file.close();
    EXPECT_EQ(refusedSource("profile_file", "\"huge.csv\"", folder.path().toStdString()).where,
              "e.json: source.profile");
    error = refusedSource("profile_file", "\"none.csv\"", folder.path().toStdString());
    EXPECT_EQ(error.code(), MessageCode::FileNotFound);
}

TEST(UnevenSourceFile, RefusesBadListsWithTheirPlace) {
    struct Bad {
        const char *key, *value;
        MessageCode code;
        const char* where;
    };
    using enum MessageCode;
    for (
        const Bad& bad :
        {Bad{"parts", "[]", SourcePartsNone, "source.parts"},
         Bad{"profile", "[]", SourcePartsNone, "source.profile"},
         Bad{"parts", "{}", JsonWrongType, "source.parts"},
         Bad{"parts", "[1]", JsonWrongType, "source.parts[0]"},
         Bad{"parts", "[{}]", JsonMissingKey, "source.parts[0]"},
         Bad{"parts", R"([{"contour": {"type": "disk", "radius_m": -0.1}}])", ValueNotPositive,
             "source.parts[0].contour.radius_m"},
         Bad{"parts", R"([{"contour": {"type": "disk", "radius_m": 0.01}, "temperature_ratio": -0.1}])",
             ValueOutOfRange, "source.parts[0].temperature_ratio"},
         Bad{"parts", R"([{"contour": {"type": "disk", "radius_m": 0.01}, "emittance": 0}])",
             ValueNotPositive, "source.parts[0].emittance"},
         Bad{"parts", R"([{"contour": {"type": "disk", "radius_m": 0.01}, "temperature_K": 400}])",
             JsonUnknownKey, "source.parts[0]"},
         Bad{"parts",
             R"([{"contour": {"type": "disk", "radius_m": 0.03}}, {"contour": {"type": "disk", "radius_m": 0.01}}])",
             SourcePartsOverlap, "source.parts[1]"},
         Bad{"profile", R"([{"radius_mm": 5}, {"radius_mm": 5}])", RadiiNotGrowing,
             "source.profile[1].radius_mm"},
         Bad{"profile", R"([{"temperature_ratio": 1}])", JsonMissingKey, "source.profile[0]"},
         Bad{"profile", R"([{"radius_mm": 0}, {"radius_mm": 50, "temperature_offset_K": -500}])",
             ValueOutOfRange, "source.profile[1].temperature"},
         Bad{"profile_file", "\"plate.csv\"", FileNotFound, "source.profile_file"}}) {
        const Error error = refusedSource(bad.key, bad.value);
        EXPECT_EQ(error.code(), bad.code) << bad.value << ": " << describe(error);
        EXPECT_EQ(error.where.rfind(std::string("e.json: ") + bad.where, 0), 0U) << error.where;
    }
    json both = withSource("parts", kTwoHalves);
    both["source"]["profile"] = json::parse(R"([{"radius_mm": 0}])");
    const auto read = experimentFromJson(both.dump(), "e.json", "");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code(), JsonTwoSpellings);
    for (const double emittance : {0.0, -0.1, 1.5}) { // weights are over it
        json weak = withSource("parts", kTwoHalves);
        weak["simulation"]["source_emittance"] = emittance;
        EXPECT_EQ(experimentFromJson(weak.dump(), "e.json", "").error().where,
                  "e.json: simulation.source_emittance");
    }
}

} // namespace bask
