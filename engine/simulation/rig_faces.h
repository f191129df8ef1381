#pragma once
// The parts of the rig that a camera sees, as flat faces: source, objects, markers on cards, a hand, a board.

#include "engine/calibration/board.h"
#include "engine/calibration/marker_layout.h"
#include "engine/shape/shape.h"
#include "engine/simulation/scene_renderer.h"

#include <vector>

namespace bask {

struct SimulatedCameraConfig;

struct PartFace {
    Part part = Part::Base;
    Pose X_PF = Pose::Identity();
    SceneFace face;
};

/// Returns the outline and the holes of a shape as they are painted.
std::vector<Ring> ringsOf(const Shape& shape);
/// Returns the source's plate and hot face, the objects, and every marker on a card with a light margin of
/// one module.
std::vector<PartFace> rigFaces(const SimulatedCameraConfig& config);
/// Returns a hand in front of each of the source's markers.
std::vector<PartFace> handFaces(const MarkerLayout& markers);
/// Returns the board in the frame of scriptedBoardPose, with z turned towards the camera: x right, y up.
SceneFace boardFace(const Board& board);

} // namespace bask
