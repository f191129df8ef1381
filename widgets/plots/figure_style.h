#pragma once
// What all figures for reports have in common: letters, axes, head and the PNG. For widgets/plots alone.

#include "widgets/plots/figure_format.h"

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
/// Names of the graphs below everything that the plot has so far, in rows of three.
void addLegend(QCustomPlot& plot);
/// Grey from minus `band` to `band` of the linear y-axis, over the whole width; nothing for 0.
void shadeAboutZero(QCustomPlot& plot, double band);
/// `comment` is stored as the picture's description.
QByteArray pngOf(QImage image, const QString& comment);
/// The plot drawn at this size (kFigureScale pixels a unit) in any format.
QByteArray pictureOf(QCustomPlot& plot, QSize size_px, FigureFormat format, const QString& comment);

} // namespace bask
