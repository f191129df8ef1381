#pragma once
// The version of VTK that writes the files.

#include <string>

namespace bask {

std::string versionOfVtk(); ///< "9.1.0"

} // namespace bask
