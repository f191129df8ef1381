#pragma once
// What is painted over a camera's picture so that it reads on any of its colours, in either theme.

#include <QPolygonF>
#include <QRectF>
#include <QString>

class QColor;
class QFont;
class QPainter;
class QPen;
class QWidget;

namespace bask {

/// Paints a line with a dark casing.
void paintCased(QPainter& painter, const QPolygonF& line, const QPen& pen);

QSizeF plateSize(const QFont& font, const QString& text);
/// Paints white text on a dark plate of plateSize() with a coloured edge.
void paintPlate(QPainter& painter, const QRectF& box, const QString& text, const QColor& edge);

/// Dims and hatches a picture that is not to be taken for a live one.
void paintDimmed(QPainter& painter, const QRectF& picture);
/// Paints a sentence in a box in the middle of `place`, in the colours of the widget; a problem has the mark
/// of an alarm.
void paintNotice(QPainter& painter, const QRectF& place, const QString& sentence, bool isProblem,
                 const QWidget& widget);

} // namespace bask
