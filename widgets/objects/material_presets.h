#pragma once
// Materials offered by name on the Objects page: values of common plates and prints, and those of a library.

#include "engine/model/material_library.h"

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

/// Returns `material`, without its name if the name is a preset's and the values are not, unless it is a
/// library's, or comes with a source or date of its own.
Material withTrueName(Material material, const MaterialLibrary& library = {});

/// Returns `after`, whose values were typed over those of `before`, without name, source, date and
/// uncertainties if these told where the values before were from and how good they were; a thickness that is
/// typed has no uncertainty.
Material withTypedValues(const Material& before, Material after, const MaterialLibrary& library);

/// Returns the place in the list of presets followed by the library's materials; empty if the values were
/// typed, or are from elsewhere.
std::optional<std::size_t> listedMaterial(const Material& material, const MaterialLibrary& library);

/// Returns `material` with everything except its thickness from that place of the list. Another thickness
/// than that of the sample has no uncertainty.
Material withListed(const Material& material, const MaterialLibrary& library, std::size_t index);

/// Returns "Standard uncertainty: emittance 0.02, thickness 0.01 mm"; empty if none is known.
QString uncertaintyText(const Material& material);

} // namespace bask
