// The table of materials.

#include "widgets/objects/material_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace bask {

// Catches a preset out of the physical range, without a source, or that another one hides: the form would
// then show another name than the one that was chosen.
TEST(MaterialPresets, ArePhysicalHaveASourceAndAreToldApart) {
    const auto& presets = materialPresets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const Material& material = presets[i].material;
        EXPECT_GT(material.emittance, 0.0) << presets[i].label;
        EXPECT_LE(material.emittance, 1.0) << presets[i].label;
        EXPECT_EQ(material.absorptance, material.emittance) << presets[i].label;
        EXPECT_GT(material.specificHeat_J_kgK, 300.0) << presets[i].label;
        EXPECT_LT(material.specificHeat_J_kgK, 2500.0) << presets[i].label;
        EXPECT_GT(material.density_kg_m3, 300.0) << presets[i].label;
        EXPECT_LT(material.density_kg_m3, 9000.0) << presets[i].label;
        EXPECT_FALSE(materialPresetSource(i).isEmpty()) << presets[i].label;
        EXPECT_EQ(matchingPreset(material), i) << presets[i].label;
        EXPECT_EQ(matchingPreset(withListed({}, {}, i)), i) << presets[i].label;
    }
}

// Catches a material that people hold and that is missing.
TEST(MaterialPresets, TheUsualOnesAreThere) {
    for (const char* name : {"aluminium, bare", "aluminium, anodised", "aluminium, painted black", "copper",
                             "steel", "stainless steel", "PLA", "ABS", "glass", "graphite"})
        EXPECT_TRUE(std::ranges::any_of(materialPresets(), [name](const MaterialPreset& preset) {
            return std::string(preset.label).starts_with(name);
        })) << name;
}

// Catches values that drift away from docs/materials.md, where they were looked up.
TEST(MaterialPresets, ValuesAreThoseThatWereLookedUp) {
    struct LookedUp {
        const char* label;
        double emittance, specificHeat_J_kgK, density_kg_m3;
    };
    for (const LookedUp& row : {LookedUp{"aluminium, bare", 0.09, 903.0, 2702.0},
                                {"aluminium, anodised", 0.84, 903.0, 2702.0},
                                {"aluminium, painted black", 0.97, 903.0, 2702.0},
                                {"copper, oxidised", 0.65, 385.0, 8933.0},
                                {"steel, painted black", 0.97, 448.0, 7870.0},
                                {"stainless steel, polished", 0.16, 500.0, 7900.0},
                                {"PLA, solid", 0.9, 1800.0, 1240.0},
                                {"ABS, solid", 0.9, 1470.0, 1050.0},
                                {"glass", 0.84, 800.0, 2500.0},
                                {"graphite", 0.85, 720.0, 1750.0}}) {
        const auto preset = std::ranges::find_if(
            materialPresets(), [&row](const MaterialPreset& p) { return std::string(p.label) == row.label; });
        ASSERT_NE(preset, materialPresets().end()) << row.label;
        EXPECT_EQ(preset->material.emittance, row.emittance) << row.label;
        EXPECT_EQ(preset->material.specificHeat_J_kgK, row.specificHeat_J_kgK) << row.label;
        EXPECT_EQ(preset->material.density_kg_m3, row.density_kg_m3) << row.label;
    }
}

} // namespace bask
