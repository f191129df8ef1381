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
                                                          {"gain", -0.01},
                                                          {"gain", 0.3},
                                                          {"offset_K", 21},
                                                          {"drift_K_per_min", -1},
                                                          {"drift_K_per_min", "slow"},
                                                          {"band_um", 8},
                                                          {"band_um", {8}},
                                                          {"band_um", {14, 8}},
                                                          {"band_um", {8, 60}},
                                                          {"band_um", {0.5, 8}},
                                                          {"response", {{8, 1}}},
                                                          {"response", {{8, 1}, {8, 1}}},
                                                          {"response", {{8, 1}, {9, -1}}},
                                                          {"response", {{8, 0}, {9, 0}}},
                                                          {"response", {{8, 1}, {9, "1"}}},
                                                          {"response", {8, 9}},
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

// Catches: a camera's own band and accuracy that are not those of its file, or get lost when it is stored.
TEST(ThermalProfile, hasABandAndUncertaintiesOfItsOwn) {
    const ThermalProfile usual = thermalProfileFromJson(minimal().dump(), "p").value();
    EXPECT_EQ(usual.uncertainty, ThermalCameraUncertainty());
    EXPECT_EQ(bandOf(usual).get(), &thermalBand());
    auto json = minimal();
    json["gain"] = 0.02;
    json["offset_K"] = 0.3;
    json["drift_K_per_min"] = 0.2;
    json["response"] = {{7.5, 0.0}, {8.2, 0.85}, {13.1, 0.6}, {14, 0}};
    const ThermalProfile own = thermalProfileFromJson(json.dump(), "p").value();
    EXPECT_EQ(own.uncertainty, (ThermalCameraUncertainty{0.02, 0.3, 0.2}));
    ASSERT_EQ(own.response.size(), 4U);
    EXPECT_DOUBLE_EQ(own.response[1].wavelength_m, 8.2e-6);
    EXPECT_EQ(thermalProfileFromJson(thermalProfileToJson(own), "p").value(), own);
    EXPECT_EQ(bandOf(own)->radiance(350.0), BandRadiance(own.response).radiance(350.0));
    json.erase("response");
    json["band_um"] = {3, 5};
    const ThermalProfile medium = thermalProfileFromJson(json.dump(), "p").value();
    EXPECT_NEAR(bandOf(medium)->radiance(350.0), BandRadiance(3e-6, 5e-6).radiance(350.0), 1e-8);
    EXPECT_EQ(thermalProfileFromJson(thermalProfileToJson(medium), "p").value(), medium);
    json["response"] = {{8, 1}, {14, 1}};
    EXPECT_EQ(thermalProfileFromJson(json.dump(), "p").error().code(), MessageCode::JsonTwoSpellings);
}

// Catches: a refusal without its place.
TEST(ThermalProfile, tellsWhichPointOfItsResponseIsWrong) {
    auto json = minimal();
    json["response"] = {{8, 1}, {10, 1}, {9, 1}};
    const auto refused = thermalProfileFromJson(json.dump(), "p.json");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().where.find("response[2]"), std::string::npos) << refused.error().where;
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
    for (const char* key :
         {"name",        "title",           "source",   "width",           "height",        "skip_top",
          "skip_bottom", "optional_bottom", "bits",     "byte_order",      "scale",         "offset",
          "unit",        "min_degC",        "max_degC", "warn_above_degC", "frame_rate_Hz", "gain",
          "offset_K",    "drift_K_per_min", "band_um",  "response"})
        EXPECT_NE(document.find('`' + std::string(key) + '`'), std::string::npos) << key;
    for (const ThermalProfile& profile : shippedThermalProfiles())
        EXPECT_NE(document.find('`' + profile.name + '`'), std::string::npos) << profile.name;
    const std::size_t first = document.find("```json\n") + 8;
    const std::string example = document.substr(first, document.find("```", first) - first);
    const auto profile = thermalProfileFromJson(example, "example");
    ASSERT_TRUE(profile) << example;
}

} // namespace bask
