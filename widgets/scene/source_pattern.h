#pragma once
// How an uneven source is shown: where it radiates how strongly; private to widgets/scene.

#include "engine/model/experiment.h"

#include <Eigen/Geometry>

#include <vector>

namespace bask {

/// Returns how strongly the source radiates, relative to itself (the weights of SourceEmission), on `n` x `n`
/// cells of `box` (S, m), rows of growing y: 0 where nothing does. For an uneven source.
std::vector<double> sourcePattern(const Experiment& experiment, const Eigen::AlignedBox2d& box, int n);

/// Returns the outlines of the parts and their holes, projected on the xy-plane of S.
std::vector<std::vector<Eigen::Vector2d>> partRings(const Unevenness& uneven, int points);

} // namespace bask
