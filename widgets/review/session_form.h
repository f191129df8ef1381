#pragma once
// The forms that a recorded session is exported in.

namespace bask {

enum class SessionForm { ReportPdf, ReportHtml, Figures, Csv, CsvAllDigits, Nexus, Vtk };

} // namespace bask
