#pragma once
// A thermal picture as the camera's numbers again, in files that other programs read.

#include "engine/thermography/camera_profile.h"
#include "engine/thermography/frame_decoder.h"
#include "engine/thermography/thermal_picture.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace bask {

/// Returns the numbers that frameOfCounts made this picture of: to the last digit, where they are
/// temperatures of the camera. What is colder or hotter than it can tell is its least or largest number.
/// Throws std::invalid_argument for a picture of another size than the profile's.
CountPicture countsOfPicture(const ThermalPicture& picture, const ThermalProfile& profile);

/// Reads the numbers of a PNG or a TIFF without making temperatures of them. `picture` and errors: as
/// frameOfImage (frame_decoder.h), without the errors of the numbers.
Result<CountPicture> countsOfImage(std::string_view bytes, const ThermalProfile& profile,
                                   const std::string& where, std::optional<std::size_t> picture = {});

/// Returns the bytes of a PNG or a TIFF (LZW) of one channel of 16 bits, without loss: frameOfImage reads
/// both.
std::string pngOfCounts(const CountPicture& counts);
std::string tiffOfCounts(const CountPicture& counts);

} // namespace bask
