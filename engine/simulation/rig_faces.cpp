#include "engine/simulation/rig_faces.h"

#include "engine/simulation/board_script.h"
#include "engine/simulation/simulated_camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr float kPlate = 165.0F, kPlateBehind = 120.0F, kHot = 48.0F;
constexpr float kObjectBehind = 140.0F, kObjectHeated = 75.0F;
constexpr float kPaper = 228.0F, kPaperBehind = 205.0F, kInk = 24.0F, kSkin = 178.0F;

Ring rectangle(double x, double y, double width, double height) {
    return {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
}

Ring square(double side) {
    return rectangle(-0.5 * side, -0.5 * side, side, side);
}

// Side of the plate that the source and the markers beside it sit on.
double plateSide_m(const SimulatedCameraConfig& config) {
    constexpr double kRim_m = 0.02;
    double half = shapeRadius(config.source);
    for (const PlacedMarker& marker : config.markers.markers)
        if (marker.part == Part::Source)
            for (const Eigen::Vector3d& p_S : marker.corners())
                half = std::max(half, p_S.head<2>().cwiseAbs().maxCoeff());
    return 2.0 * (half + kRim_m);
}

double cardSide_m(const MarkerLayout& layout, const PlacedMarker& marker) {
    const auto modules = static_cast<double>(markerCells(layout.dictionary, marker.id).size());
    return marker.side_m * (modules + 2.0) / modules;
}

SceneFace cardOf(const MarkerLayout& layout, const PlacedMarker& marker) {
    SceneFace card{{square(cardSide_m(layout, marker))}, kPaper, kPaperBehind, {}, kInk, 2};
    const double half = 0.5 * marker.side_m;
    for (const DarkSquare& cell : darkSquares(layout.dictionary, marker.id, marker.side_m))
        card.marks.push_back(rectangle(cell.corner_m.x() - half, half - cell.corner_m.y() - cell.side_m,
                                       cell.side_m, cell.side_m));
    return card;
}

// The back of a hand, about as large as that from the wrist to the knuckles.
Ring handOutline(double radius_m) {
    constexpr int kPoints = 60;
    Ring ring;
    for (int k = 0; k < kPoints; ++k) {
        const double phi = 2.0 * std::numbers::pi * k / kPoints;
        const double r = radius_m * (1.1 + 0.06 * std::cos(2.0 * phi + 0.4) + 0.03 * std::cos(5.0 * phi));
        ring.emplace_back(r * std::cos(phi), r * std::sin(phi));
    }
    return ring;
}

} // namespace

std::vector<Ring> ringsOf(const Shape& shape) {
    constexpr int kPoints = 180;
    std::vector<Ring> rings = shapeRings(shape, kPoints);
    for (std::size_t k = 1; k < rings.size(); ++k)
        std::ranges::reverse(rings[k]);
    return rings;
}

std::vector<PartFace> rigFaces(const SimulatedCameraConfig& config) {
    std::vector<PartFace> faces;
    const Pose none = Pose::Identity();
    faces.push_back({Part::Source, none, {{square(plateSide_m(config))}, kPlate, kPlateBehind, {}, 0.0F, 0}});
    faces.push_back({Part::Source, none, {ringsOf(config.source), kHot, kPlateBehind, {}, 0.0F, 1}});
    for (const auto& object : config.objects)
        faces.push_back({Part::EndEffector,
                         object.X_EO,
                         {ringsOf(object.shape), kObjectBehind, kObjectHeated, {}, 0.0F, 1}});
    for (const PlacedMarker& marker : config.markers.markers)
        faces.push_back({marker.part, marker.X_PM, cardOf(config.markers, marker)});
    return faces;
}

std::vector<PartFace> handFaces(const MarkerLayout& markers) {
    constexpr double kBefore_m = 0.004;
    std::vector<PartFace> faces;
    for (const PlacedMarker& marker : markers.markers)
        if (marker.part == Part::Source)
            faces.push_back({Part::Source,
                             marker.X_PM * Eigen::Translation3d(0, 0, kBefore_m),
                             {{handOutline(0.71 * cardSide_m(markers, marker))}, kSkin, kSkin, {}, 0.0F, 3}});
    return faces;
}

SceneFace boardFace(const Board& board) {
    const double margin = boardMargin_m(board), width = squareColumns(board) * board.square_m + 2.0 * margin,
                 height = squareRows(board) * board.square_m + 2.0 * margin;
    SceneFace face{{rectangle(-margin, margin - height, width, height)}, kPaper, kPaperBehind, {}, kInk, 0};
    for (const DarkSquare& dark : darkSquares(board))
        face.marks.push_back(
            rectangle(dark.corner_m.x(), -dark.corner_m.y() - dark.side_m, dark.side_m, dark.side_m));
    return face;
}

} // namespace bask
