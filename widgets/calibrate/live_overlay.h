#pragma once
// Drawings over a camera's picture: markers, axes, a board's corners, where corners were found so far.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"

#include <QString>
#include <QTransform>

class QPainter;

namespace bask {

/// `map` converts pixels of the picture (centres at whole numbers) to the painter's coordinates.
struct OverlayPlace {
    QTransform map;
    QRectF picture; ///< in the painter's coordinates
};

QString partWord(Part part); ///< "source"

void paintHeatMap(QPainter& painter, const OverlayPlace& place, const HeatMap& map);
/// `columns` is the number of corners in a row; each row has its colour.
void paintBoard(QPainter& painter, const OverlayPlace& place, const BoardView& board, int columns);
/// Paints outline, first corner, id and residual; axes if the camera and the marker's side are known.
void paintMarkers(QPainter& painter, const OverlayPlace& place, const std::vector<ViewedMarker>& markers,
                  const std::optional<CameraModel>& camera);
/// Paints the axes of a frame with this length and their letters.
void paintAxes(QPainter& painter, const OverlayPlace& place, const Pose& X_CF, double length_m,
               const CameraModel& camera, bool isUncertain);

} // namespace bask
