// The list of controllers, and gains of a controller that the settings do not know.

#include "engine/control/controller_catalogue.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>
#include <stdexcept>
#include <string>

namespace bask {
namespace {

struct ProportionalGains {
    double gain_1_s = 0.25;
    double band_K = 1.0;
};

constexpr Parameter<ProportionalGains> kProportional[]{
    {{"gain", unit::kPerSecond, {0.0, 10.0}}, &ProportionalGains::gain_1_s},
    {{"band", unit::kKelvin, {0.0, 100.0}}, &ProportionalGains::band_K},
};
constexpr ParameterTable<ProportionalGains> kTable(kProportional);
constexpr const char* kGroup = "proportional";

} // namespace

// Catches an entry with a forgotten field, or two that files cannot tell apart.
TEST(ControllerCatalogue, EveryEntryIsWhole) {
    std::set<std::string> keys, groups;
    for (const ControllerEntry& entry : controllerCatalogue()) {
        EXPECT_TRUE(keys.insert(entry.kind.key()).second) << entry.kind.key();
        EXPECT_TRUE(groups.insert(entry.group).second) << entry.group;
        for (const char* words : {entry.name, entry.help, entry.description})
            EXPECT_GT(std::strlen(words), 0U) << entry.kind.key();
        EXPECT_FALSE(entry.gains.empty()) << entry.kind.key();
        EXPECT_NE(entry.make, nullptr) << entry.kind.key();
        EXPECT_EQ(&controllerEntry(entry.kind), &entry);
    }
}

// Catches an unknown controller that silently becomes another one.
TEST(ControllerCatalogue, AnUnknownKindIsAnError) {
    EXPECT_THROW(controllerEntry(ControllerKind("level")), std::invalid_argument);
    EXPECT_THROW(controllerEntry(ControllerKind("")), std::invalid_argument);
}

// Catches kinds that are told apart by where their key stands in memory.
TEST(ControllerCatalogue, AKindIsItsKey) {
    const std::string copy = "adaptive";
    EXPECT_EQ(ControllerKind(copy.c_str()), ControllerKind::Adaptive);
    EXPECT_NE(ControllerKind::Adaptive, ControllerKind::ModelBased);
}

// Catches own gains that are lost, mixed with another controller's, or that make equal settings differ.
TEST(ControllerCatalogue, AControllerKeepsGainsOfItsOwn) {
    const std::vector<ControllerGain> gains = ownGains(kTable, kGroup);
    ASSERT_EQ(gains.size(), 2U);
    ControllerSettings settings;
    EXPECT_EQ(gains[0].get(settings), 0.25) << "the default";
    gains[0].set(settings, 0.5);
    ownGains(kTable, "another")[1].set(settings, 7.0);
    EXPECT_EQ(gains[0].get(settings), 0.5);
    EXPECT_EQ(gains[1].get(settings), 1.0);
    const ProportionalGains own = gainsFrom(settings, kTable, kGroup);
    EXPECT_EQ(own.gain_1_s, 0.5);
    EXPECT_EQ(own.band_K, 1.0);
    EXPECT_NE(settings, ControllerSettings());

    gains[0].set(settings, 0.25);
    ownGains(kTable, "another")[1].set(settings, 1.0);
    EXPECT_EQ(settings, ControllerSettings());
}

} // namespace bask
