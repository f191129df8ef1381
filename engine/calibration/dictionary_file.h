#pragma once
// Dictionaries of markers of one's own, as OpenCV writes them.

#include "engine/base/result.h"
#include "engine/shape/marker.h"

#include <string>

namespace bask {

/// YAML with nmarkers (at most 10,000), markersize (3 to 8 bits a side), marker_0, marker_1 ... as 0 and 1
/// row by row, and maxCorrectionBits if it likes. The dictionary is named after the file. Errors: those of a
/// file; JsonMissingKey, NumbersUnusable, ValueOutOfRange, MarkerBitsUnusable.
Result<MarkerDictionary> readDictionary(const std::string& path);
/// The same from a file's text.
Result<MarkerDictionary> dictionaryFromYaml(const std::string& text, const std::string& path);

} // namespace bask
