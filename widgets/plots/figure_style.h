#pragma once
// The common style of all figures for reports: text, axes, title and the PNG. Only for widgets/plots.

#include "widgets/plots/figure_format.h"

#include <QFont>
#include <QImage>

#include <qcustomplot.h>

namespace bask {

inline constexpr double kFigureScale = 2.0; ///< pixels a unit of letters and lines

QFont figureFont(int size, bool bold = false);
/// Sets label, text, colours and grid of an axis on a light background.
void styleAxis(QCPAxis* axis, const QString& label);
/// Adds title and note above the present content of the plot.
void addHead(QCustomPlot& plot, const QString& title, const QString& note);
/// Adds the names of the graphs below the present content of the plot, in rows of three.
void addLegend(QCustomPlot& plot);
/// Shades the linear y-axis from -`band` to `band` in grey over the whole width; nothing for 0.
void shadeAboutZero(QCustomPlot& plot, double band);
/// `comment` is stored as the picture's description.
QByteArray pngOf(QImage image, const QString& comment);
/// Returns the plot drawn at this size (kFigureScale pixels per unit) in any format.
QByteArray pictureOf(QCustomPlot& plot, QSize size_px, FigureFormat format, const QString& comment);

} // namespace bask
