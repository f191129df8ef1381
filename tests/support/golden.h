#pragma once
// Files of what the program writes, as they were when a person last looked at what had changed. Without them
// a round trip compares the program with itself.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

namespace bask::test {

/// Set in the environment it writes the files anew: see CONTRIBUTING.md.
inline bool isGoldenRenewed() {
    return std::getenv("BASK_RENEW_GOLDEN") != nullptr; // NOLINT(concurrency-mt-unsafe)
}

inline std::string textOfFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A number at the beginning of a text, and how long it is there.
inline std::optional<std::pair<double, std::size_t>> numberAt(std::string_view text) {
    constexpr std::string_view kOfNumbers = "0123456789.eE+-";
    const std::size_t end = std::min(text.find_first_not_of(kOfNumbers), text.size());
    const std::string word(text.substr(0, end));
    char* last = nullptr;
    const double value = std::strtod(word.c_str(), &last);
    const auto length = static_cast<std::size_t>(last - word.c_str());
    return length == 0 ? std::nullopt : std::optional(std::pair(value, length));
}

/// Whether two lines are the same but for numbers that differ by `share` of themselves: another library of
/// mathematics may round the last digit otherwise.
inline bool isSameLine(std::string_view a, std::string_view b, double share) {
    constexpr double kNothing = 1e-12;
    while (!a.empty() && !b.empty()) {
        const auto x = numberAt(a), y = numberAt(b);
        if (!x || !y) {
            if (a.front() != b.front())
                return false;
            a.remove_prefix(1);
            b.remove_prefix(1);
        } else {
            if (std::abs(x->first - y->first) > kNothing + share * std::abs(x->first))
                return false;
            a.remove_prefix(x->second);
            b.remove_prefix(y->second);
        }
    }
    return a.empty() && b.empty();
}

/// Compares a text with the file tests/data/golden/NAME, line by line, or writes the file anew.
inline void expectGolden(const std::string& name, const std::string& now, double share) {
    const std::filesystem::path path = std::filesystem::path(BASK_TEST_DATA "/golden") / name;
    if (isGoldenRenewed()) {
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << now;
        return;
    }
    ASSERT_TRUE(std::filesystem::exists(path)) << path << ": write it anew, see CONTRIBUTING.md";
    std::istringstream before(textOfFile(path)), after(now);
    std::string was, is, told;
    int differences = 0;
    for (int line = 1;; ++line) {
        const bool had = static_cast<bool>(std::getline(before, was)),
                   has = static_cast<bool>(std::getline(after, is));
        if (!had && !has)
            break;
        if (had && has && isSameLine(was, is, share))
            continue;
        constexpr int kTold = 5;
        constexpr std::size_t kLength = 300;
        if (++differences <= kTold)
            told += "line " + std::to_string(line) + "\n- " + (had ? was.substr(0, kLength) : "(none)") +
                    "\n+ " + (has ? is.substr(0, kLength) : "(none)") + '\n';
    }
    EXPECT_EQ(differences, 0) << path << '\n'
                              << told
                              << "If this is meant, write the files anew (CONTRIBUTING.md) and look at the "
                                 "difference.";
}

} // namespace bask::test
