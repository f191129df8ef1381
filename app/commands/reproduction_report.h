#pragma once
// The report of `bask reproduce` as one HTML text that needs no other file and no network.

#include "app/commands/reproduction_figures.h"

#include <string>
#include <vector>

namespace bask {

/// Near the beginning of every file of the report: what holds it may be replaced.
inline constexpr const char* kReproductionMark = "Bask reproduction";

struct ReportFigure {
    const PaperFigure* figure = nullptr;
    std::vector<const ReproducedExperiment*> experiments; ///< its own
    std::vector<ReportPicture> pictures;
};

/// Summary, table of all experiments, a section a figure. UTF-8.
std::string reproductionHtml(const std::vector<ReportFigure>& figures);

} // namespace bask
