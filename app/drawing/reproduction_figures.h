#pragma once
// The paper's figures from the runs, as PNG pictures. Needs a QApplication, no display.

#include "app/drawing/reproduction.h"

#include <QByteArray>
#include <QString>

namespace bask {

struct ReportPicture {
    QByteArray png;
    QString words;       ///< description for those who cannot see the picture
    bool isWide = false; ///< uses the full width of the page instead of half
};

/// The pictures of a plot of expected.json:
///   "overlay"   error over time, all experiments of the figure in one picture, one picture a controller
///   "errors"    error of each object over time, one picture an experiment and controller
///   "norm"      norm of the error over time, both controllers in one picture an experiment
///   "paths"     the objects' paths from the paper's two sides, one picture an experiment and controller
///   "subsets"   surfaces of equal view factor over the translations and over the rotations
///   "panels"    the same at three inclinations, heights and distances aside
///   "surfaces"  surfaces on which the objects are steady at the targets, with the objects' paths
///   "methods"   the study of view-factor methods
/// `plot` is one of reportPlots(), `all` are the experiments of the figure and of its `with`, at least one
/// where the plot shows experiments. Errors: what the field sampler and the study say.
Result<std::vector<ReportPicture>> reportPictures(const std::string& plot,
                                                  const std::vector<const ReproducedExperiment*>& all);

} // namespace bask
