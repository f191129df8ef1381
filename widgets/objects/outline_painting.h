#pragma once
// Pieces shared by the two drawings of outlines: polygons in millimetres, a fitted view with y up, and the
// scale bar.

#include "engine/shape/shape.h"

#include <QColor>
#include <QPainterPath>
#include <QPolygonF>
#include <QRectF>
#include <QString>
#include <QTransform>

class QPainter;

namespace bask {

/// Returns the outline of a shape as a polygon in mm; `n` points for curved ones.
QPolygonF outline_mm(const Shape& shape, int n = 400);
QPolygonF polygon_mm(const Contour& contour);
/// Returns an outline and its holes as one face in mm, to be filled by the odd-even rule.
QPainterPath face_mm(const std::vector<std::vector<Eigen::Vector2d>>& rings_m);

/// Maps mm (y up) into `view` pixels (y down): same scale both ways, content centred.
QTransform fitted(const QRectF& content_mm, const QRectF& view);

/// Returns the largest of 1, 2, 5 x 10^k that is not above `value`.
double niceLength(double value);

/// "1 harmonic", "5 harmonics".
QString harmonicsText(int harmonics);

/// "1 hole", "2 holes".
QString holesText(std::size_t holes);

/// Length with its unit, "20 mm".
QString lengthText_mm(double length_mm);

/// Paints a scale bar of about a fifth of `view`'s width in its lower left corner.
void paintScaleBar(QPainter& painter, const QRectF& view, double pixelsPerMm);

} // namespace bask
