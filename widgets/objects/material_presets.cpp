#include "widgets/objects/material_presets.h"

#include <QCoreApplication>

#include <cmath>

namespace bask {
namespace {

Material make(const char* name, double emittance, double specificHeat_J_kgK, double density_kg_m3,
              double infill = 1.0) {
    Material material;
    material.name = name;
    material.emittance = emittance;
    material.absorptance = emittance;
    material.specificHeat_J_kgK = specificHeat_J_kgK;
    material.density_kg_m3 = density_kg_m3;
    material.thickness_m = 0.001;
    material.infill = infill;
    return material;
}

MaterialPreset preset(const char* label, double emittance, double specificHeat_J_kgK, double density_kg_m3,
                      double infill = 1.0) {
    return {label, make(label, emittance, specificHeat_J_kgK, density_kg_m3, infill)};
}

bool same(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

} // namespace

const std::vector<MaterialPreset>& materialPresets() {
    static const std::vector<MaterialPreset> presets{
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, painted"), 0.9, 904.0, 2700.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, bare"), 0.04, 904.0, 2700.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 30 % infill"), 0.9, 1800.0, 1240.0, 0.3),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 50 % infill"), 0.9, 1800.0, 1240.0, 0.5),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, solid"), 0.9, 1800.0, 1240.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "ABS, solid"), 0.92, 1400.0, 1050.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "steel, oxidised"), 0.8, 490.0, 7850.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "copper, oxidised"), 0.7, 385.0, 8960.0),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "glass"), 0.92, 840.0, 2500.0),
    };
    return presets;
}

QString materialPresetLabel(std::size_t index) {
    return QCoreApplication::translate("MaterialPreset", materialPresets().at(index).label);
}

std::optional<std::size_t> matchingPreset(const Material& material) {
    const auto& presets = materialPresets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        const Material& p = presets[i].material;
        if (same(p.emittance, material.emittance) && same(p.absorptance, material.absorptance) &&
            same(p.specificHeat_J_kgK, material.specificHeat_J_kgK) &&
            same(p.density_kg_m3, material.density_kg_m3) && same(p.infill, material.infill))
            return i;
    }
    return std::nullopt;
}

Material withPreset(const Material& material, std::size_t index) {
    Material result = materialPresets().at(index).material;
    result.thickness_m = material.thickness_m;
    return result;
}

} // namespace bask
