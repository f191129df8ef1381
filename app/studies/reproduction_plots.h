#pragma once
// The plots that expected.json may ask for.

#include <array>
#include <string_view>

namespace bask {

struct ReportPlot {
    std::string_view name;
    bool showsExperiments = true; ///< false: it needs no experiments
};

/// Returns all plots; reportPictures() describes them.
constexpr std::array<ReportPlot, 8> reportPlots() {
    return {{{"overlay"},
             {"errors"},
             {"norm"},
             {"paths"},
             {"subsets", false},
             {"panels", false},
             {"surfaces"},
             {"methods", false}}};
}

} // namespace bask
