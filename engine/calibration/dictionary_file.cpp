#include "engine/calibration/dictionary_file.h"

#include "engine/base/message_code.h"
#include "engine/calibration/plain_yaml.h"
#include "engine/shape/contour_file.h"

namespace bask {

Result<MarkerDictionary> readDictionary(const std::string& path) {
    constexpr std::uintmax_t kLargestFile = 4U << 20;
    const auto text = readFileBytes(path, kLargestFile);
    return text ? dictionaryFromYaml(*text, path) : Result<MarkerDictionary>(text.error());
}

Result<MarkerDictionary> dictionaryFromYaml(const std::string& text, const std::string& path) {
    const PlainYaml yaml(text);
    const auto count = yaml.whole("nmarkers", 1, 10'000, path);
    if (!count)
        return count.error();
    const auto side = yaml.whole("markersize", 3, 8, path);
    if (!side)
        return side.error();
    MarkerDictionary dictionary{path, *side, {}, 0};
    const auto bits = static_cast<std::size_t>(*side * *side);
    if (yaml.has("maxCorrectionBits")) {
        const auto correctable = yaml.whole("maxCorrectionBits", 0, static_cast<int>(bits), path);
        if (!correctable)
            return correctable.error();
        dictionary.correctableBits = *correctable;
    }
    for (int id = 0; id < *count; ++id) {
        const std::string key = "marker_" + std::to_string(id);
        if (!yaml.has(key))
            return Error{MessageCode::JsonMissingKey, path, {key}};
        std::string marker = yaml.text(key);
        if (marker.size() != bits || marker.find_first_not_of("01") != std::string::npos)
            return Error{MessageCode::MarkerBitsUnusable, path, {key, std::to_string(bits)}};
        dictionary.bits.push_back(std::move(marker));
    }
    return dictionary;
}

} // namespace bask
