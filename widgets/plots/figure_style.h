#pragma once
// The common style of all figures for reports: text, axes, title and the PNG. Only for widgets/plots.

#include "widgets/plots/figure_format.h"

#include <QFont>
#include <QImage>
#include <QList>

#include <qcustomplot.h>

namespace bask {

inline constexpr double kFigureScale = 2.0; ///< pixels a unit of letters and lines
inline constexpr int kFigureDots = 300;     ///< pixels an inch of paper
inline constexpr QColor kBandColor(0, 0, 0, 22);

QFont figureFont(int size, bool bold = false);
/// Sets label, text, colours and grid of an axis on a light background.
void styleAxis(QCPAxis* axis, const QString& label);
/// Adds title and note above the present content of the plot.
void addHead(QCustomPlot& plot, const QString& title, const QString& note);
/// Adds the names of the graphs below the present content of the plot, in rows of so many.
void addLegend(QCustomPlot& plot, int columns = 3);
/// Adds a name to the legend for what is no graph, or many: a line, or a patch of a brush.
void addLegendEntry(QCustomPlot& plot, const QString& name, const QPen& pen,
                    const QBrush& brush = Qt::NoBrush);
/// Marker of a series; any of shape, colour and dashes tells series apart.
QCPScatterStyle figureMarker(int index, const QColor& color);
/// Dashes of a series on a right axis: two dots for the first object, three for the second, which none of the
/// dashes on the left are.
QList<qreal> dotGroups(int index);
/// Returns the text with line breaks where it would be wider than `width`.
QString inLines(const QString& text, const QFont& font, double width);
/// Shades the linear y-axis from -`band` to `band` in grey over the whole width; nothing for 0.
void shadeAboutZero(QCustomPlot& plot, double band);
/// `comment` is stored as the picture's description, and its size on paper by kFigureDots.
QByteArray pngOf(QImage image, const QString& comment);
/// Returns the plot drawn at this size (kFigureScale pixels per unit) in any format.
QByteArray pictureOf(QCustomPlot& plot, QSize size_px, FigureFormat format, const QString& comment);

} // namespace bask
