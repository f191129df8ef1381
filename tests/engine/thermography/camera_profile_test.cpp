#include "engine/thermography/camera_profile.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <sstream>

namespace bask {
namespace {

nlohmann::json minimal() {
    return nlohmann::json::parse(
        R"({"name": "mine", "width": 80, "height": 60, "scale": 0.04, "unit": "K", "min_degC": -40, "max_degC": 500})");
}

} // namespace

// Catches: a shipped camera that reads otherwise than its table says.
TEST(ThermalProfile, theShippedOnesAreWhatTheCamerasSend) {
    ASSERT_GE(shippedThermalProfiles().size(), 4U);
    const auto lepton = findThermalProfile("lepton-3.5");
    ASSERT_TRUE(lepton);
    EXPECT_EQ(lepton->width, 160);
    EXPECT_EQ(lepton->height, 120);
    EXPECT_EQ(lepton->optionalBottom, 2);
    EXPECT_NEAR(lepton->temperature_K(29315), 293.15, 1e-9);
    const auto small = findThermalProfile("lepton-2.5");
    ASSERT_TRUE(small);
    EXPECT_EQ(small->width, 80);
    EXPECT_EQ(small->height, 60);
    EXPECT_EQ(small->optionalBottom, 3);
    EXPECT_NEAR(small->temperature_K(29315), 293.15, 1e-9);
    for (const char* name : {"p2-pro", "tc001"}) {
        const auto profile = findThermalProfile(name);
        ASSERT_TRUE(profile) << name;
        EXPECT_EQ(profile->width, 256);
        EXPECT_EQ(profile->height, 192);
        EXPECT_EQ(profile->skipTop, 192);
        EXPECT_EQ(profile->temperature_K(64 * 300), 300.0);
        EXPECT_EQ(profile->warnAbove_K, kelvinFromCelsius(150.0));
    }
}

TEST(ThermalProfile, unitsAreConverted) {
    auto json = minimal();
    json["scale"] = 0.1;
    json["offset"] = -40;
    json["unit"] = "degF";
    EXPECT_NEAR(thermalProfileFromJson(json.dump(), "p")->temperature_K(2520), 373.15, 1e-9);
    json["unit"] = "degC";
    EXPECT_NEAR(thermalProfileFromJson(json.dump(), "p")->temperature_K(1400), 373.15, 1e-9);
}

// Catches: a profile that is read as something else than it says, and an error that does not tell its place.
TEST(ThermalProfile, refusesWhatItCannotMean) {
    ASSERT_TRUE(thermalProfileFromJson(minimal().dump(), "p"));
    const std::pair<const char*, nlohmann::json> bad[] = {{"name", ""},
                                                          {"name", "p2\u200b-pro"},
                                                          {"name", "p2\n"},
                                                          {"title", "a\x1b[31m"},
                                                          {"width", 7},
                                                          {"width", 5000},
                                                          {"height", "60"},
                                                          {"height", 60.5},
                                                          {"skip_top", -1},
                                                          {"optional_bottom", 4097},
                                                          {"bits", 17},
                                                          {"bits", 7},
                                                          {"byte_order", "middle"},
                                                          {"scale", 0},
                                                          {"scale", -0.01},
                                                          {"unit", "degK"},
                                                          {"min_degC", -200},
                                                          {"min_degC", 500},
                                                          {"min_degC", 600},
                                                          {"max_degC", 3000},
                                                          {"max_degC", -90},
                                                          {"frame_rate_Hz", 0},
                                                          {"warn_above_degC", -300},
                                                          {"offset", "0"},
                                                          {"offset", 1e6},
                                                          {"colour", "grey"}};
    for (const auto& [key, value] : bad) {
        auto json = minimal();
        json[key] = value;
        const auto refused = thermalProfileFromJson(json.dump(), "p.json");
        ASSERT_FALSE(refused) << json.dump();
        EXPECT_TRUE(refused.error().where.starts_with("p.json")) << refused.error().where;
    }
    for (const char* key : {"name", "width", "height", "scale", "unit", "min_degC", "max_degC"}) {
        auto json = minimal();
        json.erase(key);
        const auto refused = thermalProfileFromJson(json.dump(), "p.json");
        ASSERT_FALSE(refused) << key;
        EXPECT_EQ(refused.error().code(), MessageCode::JsonMissingKey) << key;
    }
    EXPECT_FALSE(thermalProfileFromJson("", "p"));
    EXPECT_FALSE(thermalProfileFromJson("[]", "p"));
    EXPECT_FALSE(thermalProfileFromJson("{\"name\": ", "p"));
}

TEST(ThermalProfile, anUnknownNameIsToldTheKnownOnes) {
    const auto refused = findThermalProfile("lepton");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code(), MessageCode::ValueUnknown);
    for (const char* name : {"lepton-3.5", "p2-pro", "tc001"})
        EXPECT_NE(describe(refused.error()).find(name), std::string::npos);
    EXPECT_EQ(findThermalProfile("gone.json").error().code(), MessageCode::FileNotFound);
    EXPECT_EQ(findThermalProfile("/nowhere/gone").error().code(), MessageCode::FileNotFound);
}

// Catches: a key that works and stands nowhere, and an example in the document that is refused.
TEST(ThermalProfile, theDocumentHasEveryKeyAndAnExampleThatIsRead) {
    std::ifstream file(BASK_DOCS "/thermal-cameras.md");
    std::stringstream text;
    text << file.rdbuf();
    const std::string document = text.str();
    for (const char* key : {"name", "title", "source", "width", "height", "skip_top", "skip_bottom",
                            "optional_bottom", "bits", "byte_order", "scale", "offset", "unit", "min_degC",
                            "max_degC", "warn_above_degC", "frame_rate_Hz"})
        EXPECT_NE(document.find('`' + std::string(key) + '`'), std::string::npos) << key;
    for (const ThermalProfile& profile : shippedThermalProfiles())
        EXPECT_NE(document.find('`' + profile.name + '`'), std::string::npos) << profile.name;
    const std::size_t first = document.find("```json\n") + 8;
    const std::string example = document.substr(first, document.find("```", first) - first);
    const auto profile = thermalProfileFromJson(example, "example");
    ASSERT_TRUE(profile) << example;
}

} // namespace bask
