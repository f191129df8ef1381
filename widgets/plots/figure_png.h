#pragma once
// A figure for a report: labelled series against each other, drawn to a PNG. Needs a QApplication, no
// display.

#include <QByteArray>
#include <QList>
#include <QPointF>
#include <QString>

namespace bask {

/// One series: its points, with markers, joined by a line, or both.
struct FigureSeries {
    QString name;
    QList<QPointF> points;
    bool isJoined = true;
    bool hasMarkers = true;
};

/// What a figure shows. Logarithmic axes take positive numbers; `smallest` is where the y-axis ends and where
/// numbers below it are drawn, so that a zero has a place.
struct Figure {
    QString title;
    QString note; ///< one line below the title, in smaller letters
    QString xLabel, yLabel;
    bool isXLogarithmic = true; ///< the y-axis is logarithmic always
    int xBase = 10;             ///< ticks of a logarithmic x-axis stand at its powers
    double smallest = 1e-16;
    QList<FigureSeries> series; ///< at most 5 have colours of their own
};

inline constexpr int kFigureWidth_px = 1800;
inline constexpr int kFigureHeight_px = 1200;

/// PNG of the figure on a light ground; `comment` is stored in the file as its description (Latin-1, short).
QByteArray figurePng(const Figure& figure, const QString& comment);

} // namespace bask
