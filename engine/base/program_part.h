#pragma once
// The files that belong to the program besides its executable, and the computer that it runs on.

#include <string>

namespace bask {

/// Returns the path of a part of the program, by its file name: beside the executable, where the package has
/// it, or in the folder `built`, where tests have it; empty if it is in none of them.
std::string programPart(const std::string& name, const std::string& built);

/// Returns a function of a module, which is loaded once and stays; null, and why, if there is none.
void* moduleFunction(const char* module, const std::string& built, const char* name, std::string& problem);

/// Returns the computer's name; empty if it has none.
std::string hostName();

} // namespace bask
