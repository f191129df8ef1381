#include "engine/model/material_library.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/model/checker.h"
#include "engine/model/experiment_parameters.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <set>

namespace bask {
namespace {

bool isDate(const std::string& text) {
    int number[3]{};
    constexpr std::size_t kFirst[]{0, 5, 8}, kDigits[]{4, 2, 2};
    if (text.size() != 10 || text[4] != '-' || text[7] != '-')
        return false;
    for (int k = 0; k < 3; ++k) {
        const char* first = text.data() + kFirst[k];
        const char* last = first + kDigits[k];
        const auto [end, code] = std::from_chars(first, last, number[k]);
        if (code != std::errc() || end != last || number[k] < 1)
            return false;
    }
    return std::chrono::year_month_day(std::chrono::year(number[0]),
                                       std::chrono::month(static_cast<unsigned>(number[1])),
                                       std::chrono::day(static_cast<unsigned>(number[2])))
        .ok();
}

void checkUncertainties(Checker& check, const std::string& path, const Material& material) {
    for (const Parameter<Material>& value : materialParameters()) {
        const auto found = material.uncertainties.find(value.name);
        if (found == material.uncertainties.end())
            continue;
        ParameterFacts facts = value; // an uncertainty may be 0, and is no larger than the value can be
        facts.range = {0.0, value.range.max};
        check.parameter(path, facts, found->second);
    }
}

bool isNearlySame(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max(std::abs(a), std::abs(b));
}

/// "glass (2)"; a long name is shortened, so that it stays a valid one.
std::string numberedName(std::string name, int number) {
    const std::string end = " (" + std::to_string(number) + ')';
    while (!name.empty() && characterCount(name) + end.size() > Checker::kMaxNameLength) {
        while (name.size() > 1 && (static_cast<unsigned char>(name.back()) & 0xc0U) == 0x80U)
            name.pop_back(); // the rest of a character
        name.pop_back();
    }
    return name + end;
}

} // namespace

void checkMaterial(Checker& check, const std::string& path, const Material& material) {
    check.parameters(path, materialParameters(), material);
    check.name(path + "name", material.name, kMaxSourceLength); // a library's are shorter
    check.line(path + "source", material.source, kMaxSourceLength);
    if (!material.date.empty() && !isDate(material.date))
        check.fail(MessageCode::DateWrong, path + "date", {plainWords(material.date)});
    checkUncertainties(check, path + "uncertainty.", material);
}

Result<void> validate(const MaterialLibrary& library) {
    Checker check;
    std::set<std::string> names;
    check.range("materials", static_cast<double>(library.size()), 0.0, static_cast<double>(kMaxMaterials));
    for (std::size_t i = 0; i < library.size() && !check.failed(); ++i) {
        const std::string path = "materials[" + std::to_string(i) + "].";
        const std::string& name = library[i].name;
        if (name.empty())
            check.range(path + "name", 0.0, 1.0, Checker::kMaxNameLength, "characters");
        check.name(path + "name", name);
        if (!check.failed() && !names.insert(name).second)
            check.fail(MessageCode::MaterialNameTwice, path + "name", {name});
        checkMaterial(check, path, library[i]);
    }
    return check.result();
}

bool haveSameValues(const Material& a, const Material& b) {
    return std::ranges::all_of(
        materialParameters(), [&](const Parameter<Material>& value) { return value.get(a) == value.get(b); });
}

bool areOneMaterial(const Material& a, const Material& b) {
    Material sameThickness = b;
    sameThickness.thickness_m = a.thickness_m;
    return std::ranges::all_of(materialParameters(), [&](const Parameter<Material>& value) {
        return isNearlySame(value.get(a).value(), value.get(sameThickness).value());
    });
}

std::string originText(const Material& material) {
    const bool hasBoth = !material.source.empty() && !material.date.empty();
    return material.source + (hasBoth ? ", " : "") + material.date;
}

const Material* materialNamed(const MaterialLibrary& library, const std::string& name) {
    const auto found = std::ranges::find(library, name, &Material::name);
    return found == library.end() ? nullptr : &*found;
}

void putMaterial(MaterialLibrary& library, const Material& material) {
    for (Material& existing : library) {
        if (existing.name == material.name) {
            existing = material;
            return;
        }
    }
    library.push_back(material);
}

MergedMaterials merged(const MaterialLibrary& own, const MaterialLibrary& other) {
    MergedMaterials out{own, 0, 0, 0};
    for (const Material& material : other) {
        Material named = material;
        for (int number = 1;; ++number) {
            if (number > 1)
                named.name = numberedName(material.name, number);
            const Material* taken = materialNamed(out.library, named.name);
            if (taken != nullptr && !(*taken == named))
                continue;
            if (taken != nullptr) {
                ++out.known;
            } else {
                out.library.push_back(named);
                ++out.added;
                out.renamed += number > 1 ? 1 : 0;
            }
            break;
        }
    }
    return out;
}

} // namespace bask
