#pragma once
// A figure for a report: paths over a source seen from above and from the side, coloured by temperature.
// Needs a QApplication, no display.

#include "widgets/plots/figure_format.h"

#include <QByteArray>
#include <QList>
#include <QPointF>
#include <QSize>
#include <QString>

namespace bask {

/// A point of a path in the source's frame.
struct PathPoint {
    double x_cm = 0.0, y_cm = 0.0, z_cm = 0.0;
    double temperature_degC = 0.0;
};

struct FigurePath {
    QString name; ///< name at its start
    QList<PathPoint> points;
};

/// Two views beside each other, several paths with a marker for each along it and in the legend: against the
/// source's normal (x to the right, y up; the source's outline is true) and along its x (y to the left, z up;
/// the source is a line).
struct PathsFigure {
    QString title, note;
    bool hasHeading = true; ///< title and note
    QString corner;         ///< small words at the upper right where there is no heading
    QList<FigurePath> paths;
    QList<QPointF> source_cm;                        ///< outline of the source
    double coldest_degC = 0.0, hottest_degC = 100.0; ///< ends of the colours, blue and red
    QSize size_px{1800, 900};                        ///< at kFigureDots
    // Texts, in English unless set
    QString above = QStringLiteral("seen along -z of the source");
    QString aside = QStringLiteral("seen along x of the source");
    QString temperature = QStringLiteral("Temperature (\u00b0C)");
};

QByteArray pathsPng(const PathsFigure& figure, const QString& comment);
QByteArray pathsPicture(const PathsFigure& figure, FigureFormat format, const QString& comment);

} // namespace bask
