// The columns that bask.py reads are those that are recorded: its lines are made from the table.

#include "engine/model/trace_sample.h"
#include "tests/support/golden.h"

#include <gtest/gtest.h>

namespace bask {
namespace {

constexpr std::string_view kBegin =
    "# From engine/model/trace_sample.h, by the test PythonColumns (CONTRIBUTING.md):\n";
constexpr std::string_view kEnd = "# That far.\n";

std::string quoted(const std::string& text) {
    return '"' + text + '"';
}

/// "vx" of "vx_m_s", "smallest singular value".
std::string nameOf(std::string key, const Unit& unit) {
    std::string suffix;
    for (const char c : siUnit(unit))
        if (c == '/')
            suffix += '_';
        else if (c != '^' && c != '(' && c != ')' && c != ' ')
            suffix += c;
    if (key.ends_with('_' + suffix))
        key.erase(key.size() - suffix.size() - 1);
    std::ranges::replace(key, '_', ' ');
    return key;
}

/// In the order of the table; those of traces.csv or the others.
template <class Columns>
std::string linesOf(const std::string& name, const Columns& columns, bool isOfRun, bool isInTraces) {
    std::string out = name + " = (\n";
    for (const auto& column : columns) {
        if ((column.csv != nullptr) != isInTraces)
            continue;
        const bool isStored = column.stored.place != 0;
        if (!isInTraces && !isStored && !column.nexus) // only drawn, from the others
            continue;
        const bool isCelsius = column.unit.edge == EdgeUnit::Temperature;
        out += "    _Column(" + quoted(isInTraces ? column.csv : nameOf(column.key, column.unit)) + ", " +
               quoted(isCelsius ? "degC" : siUnit(column.unit)) + ", " +
               quoted(!isStored ? ""
                      : isOfRun ? column.key
                                : column.nameInView()) +
               ", " + (isStored && !column.stored.isLater ? quoted(column.stored.view) : "None") +
               ",\n            " +
               (column.nexus ? quoted((isOfRun ? "instrument/" : "") + std::string(column.nexus->path))
                             : "None") +
               "),\n";
    }
    return out + ")\n";
}

} // namespace

// Catches a recorded value that bask.py does not know, or looks for in another place.
TEST(PythonColumns, AreThoseThatAreRecorded) {
    const std::filesystem::path path = BASK_EXAMPLES "/../python/bask.py";
    const std::string text = test::textOfFile(path);
    const std::size_t begin = text.find(kBegin), end = text.find(kEnd);
    ASSERT_TRUE(begin != std::string::npos && end != std::string::npos && begin < end) << path;
    const std::size_t from = begin + kBegin.size();
    const std::string wanted = linesOf("_RUN", kRunColumns, true, true) +
                               linesOf("_OBJECT", kObjectColumns, false, true) + "# Not in traces.csv:\n" +
                               linesOf("_OTHER_RUN", kRunColumns, true, false) +
                               linesOf("_OTHER_OBJECT", kObjectColumns, false, false);
    if (test::isGoldenRenewed())
        std::ofstream(path, std::ios::binary) << text.substr(0, from) << wanted << text.substr(end);
    else
        EXPECT_EQ(text.substr(from, end - from), wanted) << "write it anew, see CONTRIBUTING.md";
}

} // namespace bask
