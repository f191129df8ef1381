#pragma once
// A figure for a report: labelled series against each other, drawn to a PNG. Needs a QApplication, no
// display.

#include "widgets/plots/figure_format.h"

#include <QByteArray>
#include <QList>
#include <QPointF>
#include <QSize>
#include <QString>

#include <optional>

namespace bask {

inline constexpr int kFigureWidth_px = 1800;
inline constexpr int kFigureHeight_px = 1200;

/// One series: its points, with markers, joined by a line, or both.
struct FigureSeries {
    QString name;
    QList<QPointF> points;
    bool isJoined = true;
    bool hasMarkers = true;
};

/// Minimum and maximum on an axis.
struct FigureRange {
    double min = 0.0, max = 1.0;
};

/// The content of a figure. Logarithmic axes take positive numbers; `smallest` is the end of a logarithmic
/// y-axis, and smaller numbers are drawn there, so that zero can be shown.
struct Figure {
    QString title;
    QString note; ///< one line below the title, in smaller letters
    QString xLabel, yLabel;
    bool isXLogarithmic = true;
    bool isYLogarithmic = true;
    int xBase = 10; ///< base of the ticks of a logarithmic x-axis
    double smallest = 1e-16;
    std::optional<FigureRange> xRange, yRange;        ///< ranges of linear axes; empty: from the points
    double band = 0.0;                                ///< shades the linear y-axis from -band to band
    QSize size_px{kFigureWidth_px, kFigureHeight_px}; ///< at kFigureDots
    QList<FigureSeries> series;                       ///< at most 5 have colours of their own
};

/// Returns a PNG of the figure on a light background; `comment` is stored in the file as its description
/// (Latin-1, short).
QByteArray figurePng(const Figure& figure, const QString& comment);

} // namespace bask
