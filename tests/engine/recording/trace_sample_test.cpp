#include "engine/recording/session_tables.h"
#include "engine/recording/trace_overview.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

namespace bask {
namespace {

std::string manual(const std::string& name) {
    std::ifstream file(std::string(BASK_DOCS "/") + name);
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_FALSE(text.str().empty()) << name;
    return text.str();
}

template <class Columns> void expectSound(const Columns& columns) {
    std::set<std::string> keys;
    std::set<int> places;
    for (const auto& column : columns) {
        EXPECT_TRUE(keys.insert(column.key).second) << column.key;
        EXPECT_NE(column.value.get, nullptr) << column.key;
        if (column.stored.place > 0) {
            EXPECT_TRUE(places.insert(column.stored.place).second) << column.key;
            EXPECT_NE(column.value.set, nullptr) << column.key;
            EXPECT_NE(column.stored.view, nullptr) << column.key;
        }
        if (column.plot) {
            EXPECT_STRNE(column.label, "") << column.key;
            EXPECT_STRNE(column.title, "") << column.key;
        }
    }
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(*places.rbegin(), static_cast<int>(places.size())) << "a place is left out";
}

TEST(TraceSampleColumns, AreCompleteAndHaveTheirOwnPlaces) {
    expectSound(kObjectColumns);
    expectSound(kRunColumns);
}

TEST(TraceSampleColumns, EveryQuantityHasOneColumnOrIsTheSpeed) {
    for (std::size_t q = 0; q < quantityCount(); ++q) {
        const auto quantity = static_cast<Quantity>(q);
        const bool isColumn = plottedColumn(quantity) != nullptr || plottedRunColumn(quantity) != nullptr;
        EXPECT_NE(isColumn, quantity == Quantity::Speed) << q;
    }
    EXPECT_EQ(lineCount(3), 6U * 3U + 2U);
    EXPECT_EQ(lineIndex(Quantity::Speed, 1, 3), 16U);
}

template <class Row, std::size_t N> void expectRoundTrip(const std::array<SampleColumn<Row>, N>& columns) {
    for (const auto& column : columns) {
        if (column.value.set == nullptr)
            continue;
        Row row;
        column.value.set(row, 1.0);
        EXPECT_EQ(column.value.get(row), 1.0) << column.key;
        column.value.set(row, std::numeric_limits<double>::quiet_NaN());
        const double unknown = column.value.get(row);
        EXPECT_TRUE(column.isWhole ? unknown == 0.0 : std::isnan(unknown)) << column.key;
    }
}

TEST(TraceSampleColumns, GiveBackWhatWasPutIn) {
    expectRoundTrip(kObjectColumns);
    expectRoundTrip(kRunColumns);
}

TEST(TraceSampleColumns, AreInTheManualOfSessionFiles) {
    const std::string text = manual("session-format.md");
    const auto expectRow = [&](const std::string& view, const std::string& begin, const auto& columns) {
        std::vector<const std::remove_reference_t<decltype(columns[0])>*> stored;
        for (const auto& column : columns)
            if (column.stored.place > 0 && column.stored.view == view)
                stored.push_back(&column);
        std::ranges::sort(stored, {}, [](const auto* column) { return column->stored.place; });
        std::string row = "| `" + view + "` " + begin;
        for (const auto* column : stored)
            row += std::string(", `") + column->nameInView() + '`';
        EXPECT_NE(text.find(row + " |"), std::string::npos) << row;
    };
    for (const std::string& view : storedViews(kObjectColumns))
        expectRow(view, "(N) | `time_s`, `object`", kObjectColumns);
    for (const std::string& view : storedViews(kRunColumns))
        expectRow(view, "(1) | `time_s`", kRunColumns);
    for (const ObjectColumn& column : kObjectColumns) {
        if (column.stored.place > 0) {
            EXPECT_NE(text.find(std::string("`") + column.nameInView() + "_n`"), std::string::npos)
                << column.key;
        }
    }
}

TEST(TraceSampleColumns, AreInTheManualOfExports) {
    const std::string text = manual("exports.md");
    for (const ObjectColumn& column : kObjectColumns)
        if (column.nexus) {
            const std::string path = column.nexus->path;
            EXPECT_NE(text.find(path.substr(path.rfind('/') + 1) + '`'), std::string::npos) << path;
        }
}

// Catches: a shade where none is known, where no light would come, or one that a rounded view factor makes
// less than nothing.
TEST(TraceSampleColumns, TheShadeIsTheShareThatTheOthersTake) {
    ObjectSample object;
    const auto shade = [&](double F, double unshaded) {
        object.viewFactor = F;
        object.unshadedViewFactor = unshaded;
        return shadedShare(object);
    };
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    EXPECT_DOUBLE_EQ(shade(0.15, 0.2), 0.25);
    EXPECT_EQ(shade(0.2, 0.2), 0.0);
    EXPECT_EQ(shade(0.2 + 1e-6, 0.2), 0.0);
    EXPECT_EQ(shade(0.0, 0.2), 1.0);
    EXPECT_TRUE(std::isnan(shade(0.0, 0.0)));
    EXPECT_TRUE(std::isnan(shade(0.1, kUnknown)));
    EXPECT_TRUE(std::isnan(shade(kUnknown, 0.2)));
}

// An overview of before the last quantities has their lines only.
TEST(TraceSampleColumns, AnOverviewOfFewerQuantitiesIsReadAsUnknownInTheOthers) {
    TraceSample sample;
    sample.objects.resize(1);
    sample.objects[0].measured_K = 300.0;
    sample.objects[0].valid = true;
    sample.objects[0].viewFactor = 0.15;
    sample.objects[0].unshadedViewFactor = 0.2;
    TraceOverview all(1);
    for (std::size_t k = 0; k < TraceOverview::kStretch; ++k)
        all.add(sample);
    const std::string bytes = all.bytes();
    constexpr std::size_t kTimes = 16,
                          kLine = 8; // bytes; the shade's line is the last, after the speed's two
    TraceOverview old(1);
    ASSERT_TRUE(old.addBytes(std::string_view(bytes).substr(0, kTimes + 7 * kLine), quantityCount() - 1));
    EXPECT_EQ(old.samples(), TraceOverview::kStretch);
    EXPECT_EQ(old.extremes(Quantity::Temperature, 0, 0).min, 300.0F);
    EXPECT_TRUE(old.hasValues(Quantity::Temperature));
    EXPECT_TRUE(old.hasValues(Quantity::Speed));
    EXPECT_FALSE(old.hasValues(Quantity::Shade));
    EXPECT_FLOAT_EQ(static_cast<float>(all.largest(Quantity::Shade)), 0.25F);
}

} // namespace
} // namespace bask
