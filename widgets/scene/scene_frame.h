#pragma once
// The common content of all scenes of an experiment: the box for the axes, outlines for labels, colours of
// the palette.

#include "engine/model/experiment.h"
#include "widgets/scene/camera_fit.h"
#include "widgets/scene/scene_props.h"

#include <QPalette>

namespace bask {

/// Returns the box around the workspace and all positions of the source, for the axes and the presets.
Box frameOf(const Experiment& experiment);

/// Returns a few points of an outline in its own frame, for placing a label beside it.
std::vector<Eigen::Vector3d> labelOutline(const Shape& shape);

SceneColours sceneColours(const QPalette& palette);

} // namespace bask
