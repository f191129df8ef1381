#include "engine/recording/recording_name.h"

#include <array>
#include <cctype>
#include <ctime>
#include <string_view>

namespace bask {

std::string recordingStem(std::int64_t unixTime_s, int number) {
    const auto time = static_cast<std::time_t>(unixTime_s);
    std::tm utc{};
    ::gmtime_r(&time, &utc);
    std::array<char, 32> text{};
    const std::size_t length = std::strftime(text.data(), text.size(), "%Y%m%dT%H%M%SZ", &utc);
    const std::string stem(text.data(), length);
    return number > 1 ? stem + '-' + std::to_string(number) : stem;
}

bool isRecordingStem(const std::string& stem) {
    constexpr std::string_view kForm = "00000000T000000Z"; // a digit where there is a 0
    const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (stem.size() < kForm.size())
        return false;
    for (std::size_t k = 0; k < kForm.size(); ++k)
        if (kForm[k] == '0' ? !isDigit(stem[k]) : stem[k] != kForm[k])
            return false;
    const std::string_view rest = std::string_view(stem).substr(kForm.size());
    for (std::size_t k = 1; k < rest.size(); ++k)
        if (!isDigit(rest[k]))
            return false;
    return rest.empty() || (rest[0] == '-' && rest.size() > 1);
}

} // namespace bask
