#include "widgets/objects/material_presets.h"

#include <QCoreApplication>

#include <cmath>

namespace bask {
namespace {

MaterialPreset preset(const char* label, double emittance, double specificHeat_J_kgK, double density_kg_m3,
                      const char* source, double infill = 1.0) {
    MaterialPreset out{label, {}, source};
    out.material.name = label;
    out.material.emittance = emittance;
    out.material.absorptance = emittance;
    out.material.specificHeat_J_kgK = specificHeat_J_kgK;
    out.material.density_kg_m3 = density_kg_m3;
    out.material.thickness_m = 0.001;
    out.material.infill = infill;
    return out;
}

constexpr const char* kHandbook =
    QT_TRANSLATE_NOOP("MaterialPreset", "Incropera et al., Fundamentals of Heat and Mass Transfer, app. A");
constexpr const char* kCoated =
    QT_TRANSLATE_NOOP("MaterialPreset", "handbook (bulk), thermal-imaging tables (surface)");
constexpr const char* kPaper =
    QT_TRANSLATE_NOOP("MaterialPreset", "Hu et al., arXiv 2012.13147 (bulk), flat paint (surface)");
constexpr const char* kPrint =
    QT_TRANSLATE_NOOP("MaterialPreset", "data sheets of filaments (bulk), thermal imaging (surface)");

bool same(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

} // namespace

const std::vector<MaterialPreset>& materialPresets() {
    static const std::vector<MaterialPreset> presets{
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, painted"), 0.9, 904.0, 2700.0, kPaper),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, painted black"), 0.98, 903.0, 2702.0,
               kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, anodised"), 0.82, 903.0, 2702.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, bare"), 0.04, 904.0, 2700.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "copper, polished"), 0.03, 385.0, 8933.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "copper, oxidised"), 0.5, 385.0, 8933.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "steel, painted black"), 0.98, 434.0, 7832.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "stainless steel, polished"), 0.17, 477.0, 7900.0,
               kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "stainless steel, oxidised"), 0.67, 477.0, 7900.0,
               kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 30 % infill"), 0.9, 1800.0, 1240.0, kPrint, 0.3),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 50 % infill"), 0.9, 1800.0, 1240.0, kPrint, 0.5),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, solid"), 0.9, 1800.0, 1240.0, kPrint),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "ABS, 30 % infill"), 0.92, 1400.0, 1050.0, kPrint, 0.3),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "ABS, solid"), 0.92, 1400.0, 1050.0, kPrint),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "glass"), 0.92, 750.0, 2500.0, kHandbook),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "graphite"), 0.85, 709.0, 2210.0, kCoated),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "cardboard"), 0.92, 1340.0, 930.0, kHandbook),
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

QString materialPresetSource(std::size_t index) {
    return QCoreApplication::translate("MaterialPreset", materialPresets().at(index).source);
}

Material withPreset(const Material& material, std::size_t index) {
    Material result = materialPresets().at(index).material;
    result.thickness_m = material.thickness_m;
    return result;
}

} // namespace bask
