#pragma once
// What the bytes of a thermal camera mean, as data: a new camera needs only a file.

#include "engine/base/result.h"
#include "engine/thermography/band_radiance.h"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// The unit of scale * number + offset.
enum class CountUnit { Kelvin, Celsius, Fahrenheit };

/// Standard uncertainties of a thermal camera that has been zeroed.
struct ThermalCameraUncertainty {
    double gain = 0.01;        ///< relative to the distance from the temperature of the zeroing
    double offset_K = 0.1;     ///< between two shutter events
    double drift_K_min = 0.05; ///< since the last one
    bool operator==(const ThermalCameraUncertainty&) const = default;
};

/// A camera that gives 16 bits a pixel, row by row. A frame of it is `skipTop` rows, `height` rows of
/// temperatures, `skipBottom` rows and, in some frames, `optionalBottom` rows more.
struct ThermalProfile {
    std::string name;                                    ///< "lepton-3.5"
    std::string title;                                   ///< maker and camera, for people
    std::string source;                                  ///< what it is based on
    int width = 0, height = 0;                           ///< of the temperatures, pixels
    int skipTop = 0, skipBottom = 0, optionalBottom = 0; ///< rows
    int bits = 16;                    ///< used of the 16; the number of all ones is a saturated pixel
    std::string pixelFormat = "Y16 "; ///< four characters, by which a camera is asked for such frames (V4L2)
    bool isBigEndian = false;         ///< of the camera's bytes; pictures in files have their own order
    double scale = 1.0, offset = 0.0; ///< temperature = scale * number + offset
    CountUnit unit = CountUnit::Kelvin;
    double min_K = 0.0, max_K = 0.0;    ///< what the camera can tell; other values are no temperatures of it
    std::optional<double> warnAbove_K;  ///< above this its values are known to be wrong, or nobody knows
    std::optional<double> frameRate_Hz; ///< of recorded frames that have no times
    ThermalCameraUncertainty uncertainty{};
    /// What the camera sees of the spectrum; empty: 8 to 14 um, evenly.
    std::vector<BandResponse> response{};

    bool operator==(const ThermalProfile&) const = default;

    /// Returns the number of bytes of a frame, without and with the rows that it may have or not.
    std::array<std::size_t, 2> frameSizes() const;
    bool isFrameSize(std::size_t bytes) const;
    /// Returns the temperature (K) for a number, whether the camera can tell it or not.
    double temperature_K(double number) const;
};

/// Returns the band of a camera; of cameras without a curve it is thermalBand().
std::shared_ptr<const BandRadiance> bandOf(const ThermalProfile& profile);

/// Parses a profile; `where` names it in errors. Refuses unknown, repeated and missing keys, wrong types and
/// numbers out of range. docs/thermal-cameras.md lists the keys.
Result<ThermalProfile> thermalProfileFromJson(const std::string& text, const std::string& where);

/// Returns JSON that thermalProfileFromJson reads back as the same profile.
std::string thermalProfileToJson(const ThermalProfile& profile);

/// Returns the profiles that are part of Bask, in the order of their names.
const std::vector<ThermalProfile>& shippedThermalProfiles();

/// Returns the shipped profile of this name, or reads the file. Errors: ValueUnknown for what is neither a
/// name nor looks like a file (".json", or a folder in it); those of thermalProfileFromJson and of files.
Result<ThermalProfile> findThermalProfile(const std::string& nameOrPath);

} // namespace bask
