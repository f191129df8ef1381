#pragma once
// The temperature of a source over its radius, from a CSV file.

#include "engine/base/result.h"
#include "engine/model/experiment.h"

#include <string>
#include <vector>

namespace bask {

/// Reads a radial profile. The first line names the columns: radius_mm, radius_cm or radius_m, and
/// temperature_ratio, temperature_offset_K or both; others are skipped. Columns are separated by commas,
/// semicolons or tabs; empty lines and lines that begin with # are skipped. What numbers are valid is for
/// checkUnevenness(). Errors: those of readTextFile (1 MiB at most), ProfileHeader, ProfileLine.
Result<std::vector<ProfilePoint>> readRadialProfile(const std::string& path);
/// The same from a text; `where` names it in errors.
Result<std::vector<ProfilePoint>> radialProfile(const std::string& text, const std::string& where);

} // namespace bask
