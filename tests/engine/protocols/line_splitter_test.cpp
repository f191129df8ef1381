#include "engine/protocols/line_splitter.h"

#include <gtest/gtest.h>

#include <vector>

namespace bask {
namespace {

std::vector<std::string> linesOf(LineSplitter& splitter) {
    std::vector<std::string> out;
    while (auto line = splitter.next())
        out.push_back(*line);
    return out;
}

// Catches lines lost or run together where bytes come one at a time, and blank lines handed on.
TEST(LineSplitter, PiecesAreTheSameAsTheWhole) {
    const std::string bytes = "ok\r\n\r\n<Idle>\nerror:9\r[MSG:a]\r\npart";
    LineSplitter whole, pieces;
    whole.add(bytes);
    std::vector<std::string> one;
    for (const char c : bytes) {
        pieces.add(std::string_view(&c, 1));
        for (const auto& line : linesOf(pieces))
            one.push_back(line);
    }
    const std::vector<std::string> expected{"ok", "<Idle>", "error:9", "[MSG:a]"};
    EXPECT_EQ(linesOf(whole), expected);
    EXPECT_EQ(one, expected);
    whole.add("ial\n");
    EXPECT_EQ(linesOf(whole), std::vector<std::string>{"partial"});
}

// Catches memory that grows with a device that never ends a line.
TEST(LineSplitter, EndlessLinesAreCut) {
    LineSplitter splitter;
    splitter.add(std::string(3 * LineSplitter::kLongest, 'x'));
    EXPECT_EQ(linesOf(splitter).size(), 3U);
    splitter.add("rest");
    splitter.clear();
    splitter.add("ok\n");
    EXPECT_EQ(linesOf(splitter), std::vector<std::string>{"ok"});
}

} // namespace
} // namespace bask
