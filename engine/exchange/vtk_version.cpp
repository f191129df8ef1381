#include "engine/exchange/vtk_version.h"

#include <vtkVersion.h>

namespace bask {

std::string versionOfVtk() {
    return vtkVersion::GetVTKVersion();
}

} // namespace bask
