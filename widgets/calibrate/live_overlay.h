#pragma once
// What is drawn over a camera's picture: markers, axes, a board's corners, where corners were seen so far.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"

#include <QString>
#include <QTransform>

class QPainter;

namespace bask {

/// `map` leads from pixels of the picture (their centres at whole numbers) to the painter's.
struct OverlayPlace {
    QTransform map;
    QRectF picture; ///< the painter's
};

QString partWord(Part part); ///< "source"

void paintHeatMap(QPainter& painter, const OverlayPlace& place, const HeatMap& map);
/// `columns`: corners in a row; each row has its colour.
void paintBoard(QPainter& painter, const OverlayPlace& place, const BoardView& board, int columns);
/// Outline, first corner, id and residual; axes where the camera and the marker's side are known.
void paintMarkers(QPainter& painter, const OverlayPlace& place, const std::vector<ViewedMarker>& markers,
                  const std::optional<CameraModel>& camera);
/// Axes of a frame, each as long as that, with its letter.
void paintAxes(QPainter& painter, const OverlayPlace& place, const Pose& X_CF, double length_m,
               const CameraModel& camera, bool isUncertain);

} // namespace bask
