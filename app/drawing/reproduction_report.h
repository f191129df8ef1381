#pragma once
// The report of `bask reproduce` as one HTML text that needs no other file and no network.

#include "app/drawing/reproduction_figures.h"

#include <string>
#include <vector>

namespace bask {

/// Mark near the beginning of every file of the report; a file with it may be replaced.
inline constexpr const char* kReproductionMark = "Bask reproduction";

struct ReportFigure {
    const PaperFigure* figure = nullptr;
    std::vector<const ReproducedExperiment*> experiments; ///< experiments of this figure
    std::vector<ReportPicture> pictures;
};

/// Returns a summary, a table of all experiments and one section for each figure, in UTF-8.
std::string reproductionHtml(const std::vector<ReportFigure>& figures);

} // namespace bask
