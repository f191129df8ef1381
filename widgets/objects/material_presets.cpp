#include "widgets/objects/material_presets.h"

#include "engine/model/experiment_parameters.h"
#include "widgets/common/display.h"
#include "widgets/common/parameter_form.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

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

// What was looked up for each is in docs/materials.md.
constexpr const char* kPaper =
    QT_TRANSLATE_NOOP("MaterialPreset", "Hu et al., arXiv 2012.13147 (bulk), flat paint (surface)");
constexpr const char* kBlackAluminium = QT_TRANSLATE_NOOP(
    "MaterialPreset", "Incropera, table A.1 (bulk), FLIR tables: matte black lacquer (surface)");
constexpr const char* kAnodised =
    QT_TRANSLATE_NOOP("MaterialPreset", "Incropera, table A.1 (bulk), Neutrium: anodised, 20 \u00b0"
                                        "C (surface)");
constexpr const char* kSheet = QT_TRANSLATE_NOOP(
    "MaterialPreset", "Incropera, table A.1 (bulk), FLIR tables: sheet as received (surface)");
constexpr const char* kPolished =
    QT_TRANSLATE_NOOP("MaterialPreset", "Hu et al., arXiv 2012.13147; FLIR tables: 0.04 to 0.06, polished");
constexpr const char* kCopper =
    QT_TRANSLATE_NOOP("MaterialPreset", "Incropera, table A.1 (bulk), FLIR tables (surface)");
constexpr const char* kSteel = QT_TRANSLATE_NOOP(
    "MaterialPreset", "AISI 1010, Matmake (bulk), FLIR tables: matte black lacquer (surface)");
constexpr const char* kStainless =
    QT_TRANSLATE_NOOP("MaterialPreset", "EN 10088-1, 1.4301 (bulk), Trotec: 18-8, 25 \u00b0"
                                        "C (surface)");
constexpr const char* kHeatedStainless = QT_TRANSLATE_NOOP(
    "MaterialPreset", "EN 10088-1, 1.4301 (bulk), Thome, EPFL: 0.5 to 0.7 after heating (surface)");
constexpr const char* kPla =
    QT_TRANSLATE_NOOP("MaterialPreset", "FreeCAD card PLA-Generic (bulk), plastics: 0.85 to 0.95 (surface)");
constexpr const char* kAbs =
    QT_TRANSLATE_NOOP("MaterialPreset", "Kaiao, Granta Design (bulk), plastics: 0.85 to 0.95 (surface)");
constexpr const char* kGlass = QT_TRANSLATE_NOOP(
    "MaterialPreset", "Pilkington ATS-129; specific heat: tables say 720 to 880 J/(kg\u00b7K)");
constexpr const char* kGraphite =
    QT_TRANSLATE_NOOP("MaterialPreset", "Entegris, by FreeCAD's card (bulk), tables: 0.8 to 0.98 (surface)");
constexpr const char* kCardboard =
    QT_TRANSLATE_NOOP("MaterialPreset", "Ashby: 480 to 860 kg/m\u00b3 (bulk), FLIR tables: paper (surface)");

bool hasOrigin(const Material& material) {
    return !originText(material).empty();
}

} // namespace

const std::vector<MaterialPreset>& materialPresets() {
    static const std::vector<MaterialPreset> presets{
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, painted"), 0.9, 904.0, 2700.0, kPaper),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, painted black"), 0.97, 903.0, 2702.0,
               kBlackAluminium),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, anodised"), 0.84, 903.0, 2702.0, kAnodised),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, bare"), 0.09, 903.0, 2702.0, kSheet),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "aluminium, polished"), 0.04, 904.0, 2700.0, kPolished),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "copper, polished"), 0.03, 385.0, 8933.0, kCopper),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "copper, oxidised"), 0.65, 385.0, 8933.0, kCopper),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "steel, painted black"), 0.97, 448.0, 7870.0, kSteel),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "stainless steel, polished"), 0.16, 500.0, 7900.0,
               kStainless),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "stainless steel, oxidised"), 0.6, 500.0, 7900.0,
               kHeatedStainless),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 30 % infill"), 0.9, 1800.0, 1240.0, kPla, 0.3),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, 50 % infill"), 0.9, 1800.0, 1240.0, kPla, 0.5),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "PLA, solid"), 0.9, 1800.0, 1240.0, kPla),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "ABS, 30 % infill"), 0.9, 1470.0, 1050.0, kAbs, 0.3),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "ABS, solid"), 0.9, 1470.0, 1050.0, kAbs),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "glass"), 0.84, 800.0, 2500.0, kGlass),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "graphite"), 0.85, 720.0, 1750.0, kGraphite),
        preset(QT_TRANSLATE_NOOP("MaterialPreset", "cardboard"), 0.9, 1370.0, 700.0, kCardboard),
    };
    return presets;
}

QString materialPresetLabel(std::size_t index) {
    return QCoreApplication::translate("MaterialPreset", materialPresets().at(index).label);
}

std::optional<std::size_t> matchingPreset(const Material& material) {
    const auto& presets = materialPresets();
    for (std::size_t i = 0; i < presets.size(); ++i) {
        if (areOneMaterial(presets[i].material, material))
            return i;
    }
    return std::nullopt;
}

QString materialPresetSource(std::size_t index) {
    return QCoreApplication::translate("MaterialPreset", materialPresets().at(index).source);
}

Material withTrueName(Material material, const MaterialLibrary& library) {
    const Material* own = materialNamed(library, material.name);
    if (hasOrigin(material) || (own != nullptr && areOneMaterial(*own, material)))
        return material;
    const auto& presets = materialPresets();
    const auto named = std::ranges::find(presets, material.name, &MaterialPreset::label);
    if (named != presets.end() && matchingPreset(material) != named - presets.begin())
        material.name.clear();
    return material;
}

Material withTypedValues(const Material& before, Material after, const MaterialLibrary& library) {
    const bool isNamed =
        hasOrigin(before) || materialNamed(library, before.name) != nullptr || !before.uncertainties.empty();
    if (isNamed && !areOneMaterial(before, after)) {
        after.name.clear();
        after.source.clear();
        after.date.clear();
        after.uncertainties.clear();
    }
    if (after.thickness_m != before.thickness_m)
        after.uncertainties.erase("thickness");
    return after;
}

std::optional<std::size_t> listedMaterial(const Material& material, const MaterialLibrary& library) {
    const std::size_t presets = materialPresets().size();
    const Material* own = materialNamed(library, material.name);
    if (own != nullptr && areOneMaterial(*own, material))
        return presets + static_cast<std::size_t>(own - library.data());
    if (hasOrigin(material))
        return std::nullopt;
    if (const auto preset = matchingPreset(material))
        return preset;
    const auto alike =
        std::ranges::find_if(library, [&](const Material& m) { return areOneMaterial(m, material); });
    return alike == library.end()
               ? std::nullopt
               : std::optional(presets + static_cast<std::size_t>(alike - library.begin()));
}

Material withListed(const Material& material, const MaterialLibrary& library, std::size_t index) {
    const auto& presets = materialPresets();
    Material result = index < presets.size() ? presets[index].material : library.at(index - presets.size());
    if (result.thickness_m != material.thickness_m)
        result.uncertainties.erase("thickness"); // that of the sample
    result.thickness_m = material.thickness_m;
    return result;
}

QString uncertaintyText(const Material& material) {
    QStringList parts;
    for (const Parameter<Material>& value : materialParameters()) {
        const auto found = material.uncertainties.find(value.name);
        if (found == material.uncertainties.end())
            continue;
        parts << parameterLabel(value).toLower() + QChar(0x00a0) + parameterText(value, found->second, 4);
    }
    return parts.isEmpty() ? QString()
                           : QCoreApplication::translate("MaterialPreset", "Standard uncertainty: %1")
                                 .arg(parts.join(listSeparator()));
}

} // namespace bask
