#pragma once
// The paper's surfaces of equal view factor and of equal steady temperature as pictures.

#include "app/drawing/reproduction_figures.h"

namespace bask {

/// Surfaces over the translations and over the rotations, for a disk of 1.5 cm over the source of 10 cm.
Result<std::vector<ReportPicture>> subsetPictures();
/// Translations at three inclinations; rotations at three heights and at three distances aside.
Result<std::vector<ReportPicture>> panelPictures();
/// For two objects that move parallel to the source: surfaces of 30, 40 and 50 degC for each and for both;
/// then, for each experiment and controller, the surfaces of the targets and the paths of the centres.
Result<std::vector<ReportPicture>> steadySurfacePictures(const std::vector<const ReproducedExperiment*>& all);

} // namespace bask
