#pragma once
// Materials offered by name on the Objects page: bulk and surface values of common plates and prints.

#include "engine/thermal/heat_balance.h"

#include <QString>

#include <optional>
#include <vector>

namespace bask {

/// A named material; its thickness is a default, since a plate's thickness belongs to the object.
struct MaterialPreset {
    const char* label; ///< English, context "MaterialPreset"; show it through materialPresetLabel
    Material material;
    const char* source; ///< source of the values, likewise; show it through materialPresetSource
};

/// Values at room temperature from the sources that docs/materials.md lists, absorptance equal to emittance
/// (gray). Surfaces differ: emittances are good to some 0.05, those of metals to a factor of two.
const std::vector<MaterialPreset>& materialPresets();

/// Translated label of a preset.
QString materialPresetLabel(std::size_t index);

/// Source of its values, translated.
QString materialPresetSource(std::size_t index);

/// Returns the preset with the same surface, bulk and infill (ignoring thickness); empty if the values were
/// typed.
std::optional<std::size_t> matchingPreset(const Material& material);

/// Returns `material`, without its name if the name is a preset's and the values are not.
Material withTrueName(Material material);

/// Returns `material` with everything except its thickness from the preset.
Material withPreset(const Material& material, std::size_t index);

} // namespace bask
