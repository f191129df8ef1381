#pragma once
// What all figures for reports have in common: letters, axes, head and the PNG. For widgets/plots alone.

#include <QFont>
#include <QImage>

#include <qcustomplot.h>

namespace bask {

inline constexpr double kFigureScale = 2.0; ///< pixels a unit of letters and lines

QFont figureFont(int size, bool bold = false);
/// Label, letters, colours and grid of an axis on a light ground.
void styleAxis(QCPAxis* axis, const QString& label);
/// Title and note above everything that the plot has so far.
void addHead(QCustomPlot& plot, const QString& title, const QString& note);
/// `comment` is stored as the picture's description.
QByteArray pngOf(QImage image, const QString& comment);

} // namespace bask
