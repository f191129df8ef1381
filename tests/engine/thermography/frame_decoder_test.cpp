// Frames by make_frames.py, an independent writer: what is decoded, and what is refused.

#include "engine/thermography/frame_decoder.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/thermography/frame_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

namespace bask {
namespace {

const std::string kFrames = BASK_FRAMES "/";

const nlohmann::json& expectedFrames() {
    static const nlohmann::json kExpected = [] {
        std::ifstream file(kFrames + "expected.json");
        return nlohmann::json::parse(file);
    }();
    return kExpected;
}

std::optional<ThermalProfile> profileOf(const nlohmann::json& one) {
    if (one["profile"].is_null())
        return std::nullopt;
    const auto name = one["profile"].get<std::string>();
    return findThermalProfile(name.ends_with(".json") ? kFrames + name : name).value();
}

std::string bytesOf(const std::string& name) {
    std::ifstream file(kFrames + name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

// Catches: a wrong row, half, byte order, scale or separator.
TEST(FrameDecoder, readsWhatAnotherWriterWrote) {
    int checked = 0;
    for (const auto& [name, one] : expectedFrames()["good"].items()) {
        SCOPED_TRACE(name);
        const auto frame = readFrame(kFrames + name, profileOf(one));
        ASSERT_TRUE(frame) << describe(frame.error());
        const ThermalPicture& picture = frame->picture;
        EXPECT_EQ(picture.width, one["width"].get<int>());
        EXPECT_EQ(picture.height, one["height"].get<int>());
        const auto range = pictureRange(picture);
        ASSERT_TRUE(range);
        EXPECT_NEAR(celsiusFromKelvin(range->min_K), one["min_degC"].get<double>(), 1e-9);
        EXPECT_NEAR(celsiusFromKelvin(range->max_K), one["max_degC"].get<double>(), 1e-9);
        EXPECT_NEAR(celsiusFromKelvin(range->mean_K), one["mean_degC"].get<double>(), 1e-9);
        for (const auto& sample : one["samples"])
            EXPECT_NEAR(celsiusFromKelvin(picture.at(sample[0].get<int>(), sample[1].get<int>())),
                        sample[2].get<double>(), 1e-9);
        EXPECT_EQ(frame->warnings.size(), one["warnings"].get<std::size_t>());
        ++checked;
    }
    EXPECT_EQ(checked, 50);
}

// Catches: a damaged, short, long, foreign or constant frame that is taken for a picture; an error that does
// not name its file.
TEST(FrameDecoder, refusesWhatDoesNotFit) {
    int checked = 0;
    for (const auto& [name, one] : expectedFrames()["bad"].items()) {
        SCOPED_TRACE(name);
        const auto frame = readFrame(kFrames + name, profileOf(one));
        ASSERT_FALSE(frame);
        EXPECT_EQ(messageName(frame.error().code()), one["code"].get<std::string>())
            << describe(frame.error());
        EXPECT_EQ(frame.error().where, kFrames + name);
        ++checked;
    }
    EXPECT_EQ(checked, 54);
}

// Catches: a refusal that leaves the reader without a place.
TEST(FrameDecoder, tellsWhereACellIsUnusable) {
    const auto frame = readFrame(kFrames + "nan.csv", findThermalProfile("lepton-3.5").value());
    ASSERT_FALSE(frame);
    EXPECT_NE(describe(frame.error()).find("line 41"), std::string::npos) << describe(frame.error());
    EXPECT_NE(describe(frame.error()).find("NaN"), std::string::npos) << describe(frame.error());
}

// Catches: a saturated pixel that is a number, and a maximum that is known though it is not.
TEST(FrameDecoder, whatTheCameraCannotTellIsInfinite) {
    const auto frame = readFrame(kFrames + "saturated.raw", findThermalProfile("lepton-3.5").value());
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->picture.at(60, 70), std::numeric_limits<double>::infinity());
    EXPECT_EQ(frame->picture.at(61, 70), std::numeric_limits<double>::infinity());
    EXPECT_EQ(frame->picture.at(150, 3), -std::numeric_limits<double>::infinity());
    EXPECT_TRUE(std::isfinite(frame->picture.at(62, 70)));
    const auto range = pictureRange(frame->picture);
    ASSERT_FALSE(range);
    EXPECT_EQ(range.error().code(), MessageCode::ThermalPixelsOut);
    EXPECT_NE(describe(range.error()).find("column 150, row 3"), std::string::npos)
        << describe(range.error());
}

// Catches: any length but the exact one that is taken.
TEST(FrameDecoder, takesNoOtherNumberOfBytes) {
    const ThermalProfile lepton = findThermalProfile("lepton-3.5").value();
    const std::string whole = bytesOf("lepton_telemetry.y16");
    ASSERT_EQ(whole.size(), 39040U);
    for (std::size_t size = 0; size <= whole.size(); size += size < 38000 ? 97 : 1) {
        const bool isFrame = size == 38400 || size == 39040;
        EXPECT_EQ(frameOfBytes(std::string_view(whole).substr(0, size), lepton, "f").ok(), isFrame) << size;
    }
}

// Catches: a picture that is unpacked before its size is looked at, or read beyond its end.
TEST(FrameDecoder, aPictureCutAnywhereIsRefusedOrWhole) {
    const ThermalProfile lepton = findThermalProfile("lepton-3.5").value();
    for (const char* name : {"lepton.png", "lepton.tif", "lepton_deflated.tiff"}) {
        const std::string whole = bytesOf(name);
        const auto expected = frameOfImage(whole, lepton, name);
        ASSERT_TRUE(expected);
        for (std::size_t size = 0; size < whole.size(); size += size < 200 ? 1 : 1009) {
            const auto cut = frameOfImage(std::string_view(whole).substr(0, size), lepton, name);
            EXPECT_TRUE(!cut || cut->picture == expected->picture) << name << ", " << size;
        }
    }
}

} // namespace bask
