#pragma once
// The common style of all figures for reports: text, axes, title and the PNG. Only for widgets/plots.

#include "widgets/plots/figure_format.h"

#include <QFont>
#include <QImage>
#include <QList>

#include <qcustomplot.h>

namespace bask {

inline constexpr double kFigureUnits = 144.0; ///< of letters and lines an inch of paper: half a point each
inline constexpr double kFigureScale = kFigureDots / kFigureUnits; ///< pixels a unit
// Letters on paper: 7, 7.5 and 9 points.
inline constexpr int kSmallLetters = 14, kLabelLetters = 15, kTitleLetters = 18;
inline constexpr int kMarkersOfLine = 12;
inline constexpr QColor kBandColor(0, 0, 0, 22);

QFont figureFont(int size, bool bold = false);
/// Sets label, text, colours and grid of an axis on a light background.
void styleAxis(QCPAxis* axis, const QString& label);
/// Adds title and note above the present content of a plot of this width. Returns their height.
int addHead(QCustomPlot& plot, const QString& title, const QString& note, int width);
/// Adds small words at the upper right corner, above the present content of a plot. Returns their height.
int addCorner(QCustomPlot& plot, const QString& words, int width);
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
/// Units of a length on paper: whole points, which is all that a page of a PDF can have.
int figureUnits(double mm);
/// The same of a picture with kFigureDots.
QSize figureUnits(QSize size_px);
/// Returns the plot drawn at this size, in units, in any format.
QByteArray pictureOf(QCustomPlot& plot, QSize size, FigureFormat format, const QString& comment);

} // namespace bask
