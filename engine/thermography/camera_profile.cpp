#include "engine/thermography/camera_profile.h"

#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/base/units.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace bask {

/// The files in profiles/, put into the program by CMake: names and texts.
std::vector<std::pair<std::string, std::string>> thermalProfileTexts();

namespace {

using nlohmann::json;

constexpr int kMinSide = 8, kMaxSide = 4096, kMinBits = 8, kMaxBits = 16;
constexpr std::uintmax_t kLargestProfile = 64 << 10;

const std::map<std::string, CountUnit> kCountUnits{
    {"K", CountUnit::Kelvin}, {"degC", CountUnit::Celsius}, {"degF", CountUnit::Fahrenheit}};
const std::map<std::string, std::string> kPixelFormats{{"Y16", "Y16 "}, {"YUYV", "YUYV"}};
const std::map<std::string, bool> kByteOrders{{"little", false}, {"big", true}};

void readWithin(Fields& fields, const std::string& key, int& out, int min, int max, bool required = false) {
    fields.read(key, out, required);
    if (out < min || out > max)
        if (fields.find(key) != nullptr)
            fields.fail(MessageCode::ValueOutOfRange, fields.pathOf(key),
                        {std::to_string(out), std::to_string(min), std::to_string(max), ""});
}

/// A temperature that a BandRadiance has.
void readTemperature(Fields& fields, const std::string& key, double& out_K, bool required) {
    double value_degC = 0.0;
    fields.read(key, value_degC, required);
    if (fields.find(key) == nullptr || fields.failure())
        return;
    out_K = kelvinFromCelsius(value_degC);
    if (!(out_K >= kMinBand_K && out_K <= kMaxBand_K))
        fields.fail(MessageCode::ValueOutOfRange, fields.pathOf(key),
                    {formatNumber(value_degC), formatNumber(celsiusFromKelvin(kMinBand_K), 6),
                     formatNumber(celsiusFromKelvin(kMaxBand_K), 6), "degC"});
}

constexpr double kMinBand_um = 1.0, kMaxBand_um = 50.0;
constexpr std::size_t kMaxResponse = 500;
constexpr double kMaxGain = 0.2, kMaxOffset_K = 20.0, kMaxDrift_K_min = 10.0; // uncertainties

/// A standard uncertainty from 0 to `max`.
void readUncertainty(Fields& fields, const std::string& key, double& out, double max, const char* unit) {
    fields.read(key, out);
    if (!(out >= 0.0 && out <= max))
        fields.fail(MessageCode::ValueOutOfRange, fields.pathOf(key),
                    {formatNumber(out), "0", formatNumber(max), unit});
}

/// Wavelengths have to grow, within what thermal cameras see.
void addResponse(const Fields& fields, const std::string& place, double wavelength_um, double response,
                 std::vector<BandResponse>& out) {
    const double least_um = out.empty() ? kMinBand_um : 1e6 * out.back().wavelength_m;
    const bool isGrowing = out.empty() ? wavelength_um >= least_um : wavelength_um > least_um;
    if (!isGrowing || !(wavelength_um <= kMaxBand_um))
        return fields.fail(
            MessageCode::ValueOutOfRange, place,
            {formatNumber(wavelength_um), formatNumber(least_um, 6), formatNumber(kMaxBand_um), "um"});
    if (!(response >= 0.0 && response <= 1e6))
        return fields.fail(MessageCode::ValueOutOfRange, place, {formatNumber(response), "0", "1000000", ""});
    out.push_back({1e-6 * wavelength_um, response});
}

/// "band_um": [8, 14], or "response": [[7.5, 0.2], [8, 1], ...].
void readBand(Fields& fields, std::vector<BandResponse>& out) {
    const json* const band = fields.find("band_um");
    const json* const response = fields.find("response");
    if (band != nullptr && response != nullptr)
        return fields.fail(MessageCode::JsonTwoSpellings, "response", {"band_um", "response"});
    const auto isPair = [](const json& j) {
        return j.is_array() && j.size() == 2 && j[0].is_number() && j[1].is_number();
    };
    if (band != nullptr) {
        if (!isPair(*band))
            return fields.fail(MessageCode::JsonWrongType, "band_um",
                               {"two wavelengths in um", typeName(*band)});
        for (const json& end : *band)
            addResponse(fields, "band_um", end.get<double>(), 1.0, out);
    }
    if (response == nullptr)
        return;
    if (!response->is_array() || response->size() < 2 || response->size() > kMaxResponse)
        return fields.fail(MessageCode::JsonWrongType, "response",
                           {"2 to " + std::to_string(kMaxResponse) + " pairs of um and weight",
                            response->is_array() ? std::to_string(response->size()) + " entries"
                                                 : std::string(typeName(*response))});
    for (std::size_t k = 0; k < response->size() && !fields.failure(); ++k) {
        const std::string place = "response[" + std::to_string(k) + ']';
        if (!isPair((*response)[k]))
            return fields.fail(MessageCode::JsonWrongType, place,
                               {"a pair of um and weight", typeName((*response)[k])});
        addResponse(fields, place, (*response)[k][0].get<double>(), (*response)[k][1].get<double>(), out);
    }
    const bool isSeeing = std::ranges::any_of(out, [](const BandResponse& r) { return r.response > 0.0; });
    if (!fields.failure() && !isSeeing)
        fields.fail(MessageCode::ValueNotPositive, "response", {"0"});
}

void readPositive(Fields& fields, const std::string& key, double& out, bool required) {
    fields.read(key, out, required);
    if (fields.find(key) != nullptr && !(out > 0.0))
        fields.fail(MessageCode::ValueNotPositive, fields.pathOf(key), {formatNumber(out)});
}

void checkRange(const Fields& fields, const ThermalProfile& profile) {
    if (fields.failure())
        return;
    const double lowest_K = profile.temperature_K(0.0);
    const double highest_K = profile.temperature_K(static_cast<double>((1 << profile.bits) - 1));
    const auto words = [](double T_K) { return formatNumber(celsiusFromKelvin(T_K), 6); };
    if (!(profile.min_K < profile.max_K))
        fields.fail(MessageCode::ValueOutOfRange, "max_degC",
                    {words(profile.max_K), words(profile.min_K), words(kMaxBand_K), "degC"});
    // A range that no number of the camera reaches: scale, offset or unit is wrong.
    if (!(lowest_K < profile.max_K && highest_K > profile.min_K))
        fields.fail(MessageCode::ValueOutOfRange, "min_degC",
                    {words(profile.min_K), words(lowest_K), words(highest_K), "degC"});
}

void readThermalProfile(const json& j, Failure& failure, ThermalProfile& out) {
    Fields fields(j, {}, failure);
    fields.readName("name", out.name, true);
    fields.readTitle("title", out.title);
    fields.read("source", out.source);
    readWithin(fields, "width", out.width, kMinSide, kMaxSide, true);
    readWithin(fields, "height", out.height, kMinSide, kMaxSide, true);
    readWithin(fields, "skip_top", out.skipTop, 0, kMaxSide);
    readWithin(fields, "skip_bottom", out.skipBottom, 0, kMaxSide);
    readWithin(fields, "optional_bottom", out.optionalBottom, 0, kMaxSide);
    readWithin(fields, "bits", out.bits, kMinBits, kMaxBits);
    fields.readWord("pixel_format", kPixelFormats, out.pixelFormat);
    fields.readWord("byte_order", kByteOrders, out.isBigEndian);
    readPositive(fields, "scale", out.scale, true);
    fields.read("offset", out.offset);
    fields.readWord("unit", kCountUnits, out.unit, true);
    readTemperature(fields, "min_degC", out.min_K, true);
    readTemperature(fields, "max_degC", out.max_K, true);
    if (fields.find("warn_above_degC") != nullptr)
        readTemperature(fields, "warn_above_degC", out.warnAbove_K.emplace(), false);
    if (fields.find("frame_rate_Hz") != nullptr)
        readPositive(fields, "frame_rate_Hz", out.frameRate_Hz.emplace(), false);
    readUncertainty(fields, "gain", out.uncertainty.gain, kMaxGain, "");
    readUncertainty(fields, "offset_K", out.uncertainty.offset_K, kMaxOffset_K, "K");
    readUncertainty(fields, "drift_K_per_min", out.uncertainty.drift_K_min, kMaxDrift_K_min, "K/min");
    readBand(fields, out.response);
    fields.close();
    if (out.name.empty())
        fields.fail(MessageCode::JsonWrongType, "name", {"a name", "nothing"});
    checkRange(fields, out);
}

} // namespace

std::array<std::size_t, 2> ThermalProfile::frameSizes() const {
    const auto row = 2 * static_cast<std::size_t>(width);
    const auto usual = static_cast<std::size_t>(skipTop) + static_cast<std::size_t>(height) +
                       static_cast<std::size_t>(skipBottom);
    return {usual * row, (usual + static_cast<std::size_t>(optionalBottom)) * row};
}

bool ThermalProfile::isFrameSize(std::size_t bytes) const {
    const auto sizes = frameSizes();
    return bytes == sizes[0] || bytes == sizes[1];
}

double ThermalProfile::temperature_K(double number) const {
    const double value = scale * number + offset;
    switch (unit) {
    case CountUnit::Celsius:
        return kelvinFromCelsius(value);
    case CountUnit::Fahrenheit:
        return kelvinFromDisplay(value, TemperatureUnit::Fahrenheit);
    case CountUnit::Kelvin:
        break;
    }
    return value;
}

std::shared_ptr<const BandRadiance> bandOf(const ThermalProfile& profile) {
    if (profile.response.empty())
        return {std::shared_ptr<const BandRadiance>(), &thermalBand()};
    return std::make_shared<const BandRadiance>(profile.response);
}

Result<ThermalProfile> thermalProfileFromJson(const std::string& text, const std::string& where) {
    return readJsonText<ThermalProfile>(text, where, readThermalProfile);
}

std::string thermalProfileToJson(const ThermalProfile& profile) {
    nlohmann::ordered_json j;
    const auto temperature = [&](const char* key, double T_K) {
        const double rounded_degC = std::round(celsiusFromKelvin(T_K) * 1e6) / 1e6;
        j[key] = kelvinFromCelsius(rounded_degC) == T_K ? rounded_degC : celsiusFromKelvin(T_K);
    };
    const auto word = [&](const char* key, const auto& words, const auto& value) {
        for (const auto& [name, each] : words)
            if (each == value)
                j[key] = name;
    };
    j["name"] = profile.name;
    j["title"] = profile.title;
    j["source"] = profile.source;
    j["width"] = profile.width;
    j["height"] = profile.height;
    j["skip_top"] = profile.skipTop;
    j["skip_bottom"] = profile.skipBottom;
    j["optional_bottom"] = profile.optionalBottom;
    j["bits"] = profile.bits;
    word("pixel_format", kPixelFormats, profile.pixelFormat);
    word("byte_order", kByteOrders, profile.isBigEndian);
    j["scale"] = profile.scale;
    j["offset"] = profile.offset;
    word("unit", kCountUnits, profile.unit);
    temperature("min_degC", profile.min_K);
    temperature("max_degC", profile.max_K);
    if (profile.warnAbove_K)
        temperature("warn_above_degC", *profile.warnAbove_K);
    if (profile.frameRate_Hz)
        j["frame_rate_Hz"] = *profile.frameRate_Hz;
    j["gain"] = profile.uncertainty.gain;
    j["offset_K"] = profile.uncertainty.offset_K;
    j["drift_K_per_min"] = profile.uncertainty.drift_K_min;
    for (const BandResponse& point : profile.response) {
        const double rounded_um = std::round(point.wavelength_m * 1e12) / 1e6;
        const bool isExact = 1e-6 * rounded_um == point.wavelength_m;
        j["response"].push_back({isExact ? rounded_um : 1e6 * point.wavelength_m, point.response});
    }
    return j.dump();
}

const std::vector<ThermalProfile>& shippedThermalProfiles() {
    static const std::vector<ThermalProfile> kProfiles = [] {
        std::vector<ThermalProfile> out;
        for (const auto& [name, text] : thermalProfileTexts())
            out.push_back(thermalProfileFromJson(text, name).value());
        return out;
    }();
    return kProfiles;
}

Result<ThermalProfile> findThermalProfile(const std::string& nameOrPath) {
    std::string names;
    for (const ThermalProfile& profile : shippedThermalProfiles()) {
        if (profile.name == nameOrPath)
            return profile;
        names += profile.name + ", ";
    }
    if (!nameOrPath.ends_with(".json") && nameOrPath.find('/') == std::string::npos)
        return Error{
            MessageCode::ValueUnknown, "--profile", {plainWords(nameOrPath), names + "a file .json"}};
    const auto text = readTextFile(nameOrPath, kLargestProfile);
    if (!text)
        return text.error();
    return thermalProfileFromJson(*text, nameOrPath);
}

} // namespace bask
