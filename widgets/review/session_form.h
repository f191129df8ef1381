#pragma once
// The forms that a recorded session is exported in.

namespace bask {

enum class SessionForm { Csv, Nexus, Vtk, Figures, Report };

} // namespace bask
