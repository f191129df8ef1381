#pragma once
// Materials of a lab's own: their values, where these are from, when they were found and how good they are.

#include "engine/base/result.h"
#include "engine/thermal/heat_balance.h"

#include <string>
#include <vector>

namespace bask {

class Checker;

/// In the order in which they are listed; no two have the same name. A material's thickness is that of the
/// sample, since a plate's thickness belongs to the object.
using MaterialLibrary = std::vector<Material>;

inline constexpr std::size_t kMaxSourceLength = 300; ///< characters
inline constexpr std::size_t kMaxMaterials = 2000;   ///< of a library

/// Checks values, their uncertainties, source and date; `path` ends with a dot.
void checkMaterial(Checker& check, const std::string& path, const Material& material);
/// Errors: those of the values, of names, MaterialNameTwice, DateWrong; each with its place in the file.
Result<void> validate(const MaterialLibrary& library);

/// Returns whether all values are the very same, whatever name, source, date and uncertainties are.
bool haveSameValues(const Material& a, const Material& b);
/// Returns whether all values but the thickness are the same to nine digits.
bool areOneMaterial(const Material& a, const Material& b);

/// Returns source and date, as far as they are told: "data sheet, 2026-11-23".
std::string originText(const Material& material);

/// Returns the material of that name; null if there is none.
const Material* materialNamed(const MaterialLibrary& library, const std::string& name);
/// Replaces the material of the same name, or adds it at the end.
void putMaterial(MaterialLibrary& library, const Material& material);

/// A library to which another was added, and what became of the other's materials.
struct MergedMaterials {
    MaterialLibrary library;
    int added = 0;
    int known = 0;   ///< were there already, the same in all
    int renamed = 0; ///< of those added: got another name, "glass (2)", since theirs was taken
};
/// Adds the materials of another library; nothing of `own` is changed.
MergedMaterials merged(const MaterialLibrary& own, const MaterialLibrary& other);

} // namespace bask
