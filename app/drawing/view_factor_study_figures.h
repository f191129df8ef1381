#pragma once
// The figures of the view-factor study: error against elements, harmonics, quadrature points and time.

#include "app/drawing/view_factor_study.h"

#include "widgets/plots/figure_png.h"

#include <vector>

namespace bask {

std::vector<Figure> viewFactorStudyFigures(const ViewFactorStudy& study);

} // namespace bask
