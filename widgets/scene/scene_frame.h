#pragma once
// What every scene shows of an experiment: the box its axes measure, outlines for labels, colours of the
// palette.

#include "engine/model/experiment.h"
#include "widgets/scene/camera_fit.h"
#include "widgets/scene/scene_props.h"

#include <QPalette>

namespace bask {

/// Workspace and source, wherever that is moved: what the axes measure and the presets show.
Box frameOf(const Experiment& experiment);

/// Few points of an outline, in its own frame: what a label stands beside.
std::vector<Eigen::Vector3d> labelOutline(const Shape& shape);

SceneColours sceneColours(const QPalette& palette);

} // namespace bask
