#pragma once
// Reads custom marker dictionaries in OpenCV's format.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <string>

namespace bask {

/// Reads YAML with nmarkers (at most 10,000), markersize (3 to 8 bits a side), marker_0, marker_1 ... as 0
/// and 1 row by row, and optionally maxCorrectionBits. The dictionary gets the file's name. Errors: those of
/// a file; JsonMissingKey, NumbersUnusable, ValueOutOfRange, MarkerBitsUnusable.
Result<MarkerDictionary> readDictionary(const std::string& path);
/// Like readDictionary, from the text of a file.
Result<MarkerDictionary> dictionaryFromYaml(const std::string& text, const std::string& path);

} // namespace bask
