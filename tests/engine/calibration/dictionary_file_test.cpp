// Dictionaries of one's own.

#include "engine/calibration/dictionary_file.h"

#include "engine/base/message_code.h"
#include "tests/engine/calibration/calibration_samples.h"

namespace bask {
namespace {

TEST(DictionaryFile, ReadsTheTutorials) {
    const auto dictionary = readDictionary(test::markersPath("tutorial_dict.yml"));
    ASSERT_TRUE(dictionary) << describe(dictionary.error());
    EXPECT_EQ(markerCount(*dictionary), 35);
    EXPECT_EQ(dictionary->side_bits, 6);
    const auto cells = markerCells(*dictionary, 34); // as its line in the file, with a border
    ASSERT_EQ(cells.size(), 8U);
    EXPECT_EQ(cells[1], "00111110");
    EXPECT_EQ(cells[6], "01001010");
}

// Catches: a file that makes a dictionary with other markers than it says, or crashes.
TEST(DictionaryFile, RefusesInWords) {
    const std::string good = test::textOf(test::markersPath("tutorial_dict.yml"));
    const auto with = [&](const std::string& from, const std::string& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    const std::pair<std::string, MessageCode> cases[] = {
        {"", MessageCode::JsonMissingKey},
        {with("nmarkers: 35", "nmarkers: 36"), MessageCode::JsonMissingKey},
        {with("nmarkers: 35", "nmarkers: 2000000000"), MessageCode::ValueOutOfRange},
        {with("nmarkers: 35", "nmarkers: many"), MessageCode::NumbersUnusable},
        {with("markersize: 6", "markersize: 5"), MessageCode::MarkerBitsUnusable},
        {with("markersize: 6", "markersize: 40000"), MessageCode::ValueOutOfRange},
        {with("\"1010", "\"1012"), MessageCode::MarkerBitsUnusable},
        {good + "maxCorrectionBits: 99\n", MessageCode::ValueOutOfRange},
    };
    for (const auto& [text, code] : cases) {
        const auto dictionary = dictionaryFromYaml(text, "d.yml");
        ASSERT_FALSE(dictionary);
        EXPECT_EQ(dictionary.error().code(), code) << describe(dictionary.error());
    }
    for (std::size_t length = 0; length < good.size(); ++length)
        (void)dictionaryFromYaml(good.substr(0, length), "d.yml");
}

} // namespace
} // namespace bask
