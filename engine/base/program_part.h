#pragma once
// The files that belong to the program besides its executable.

#include <string>

namespace bask {

/// Returns the path of a part of the program, by its file name: beside the executable, where the package has
/// it, or in the folder `built`, where tests have it; empty if it is in none of them.
std::string programPart(const std::string& name, const std::string& built);

} // namespace bask
