#pragma once
// A figure for a report: a quantity of all objects of a run over time, with targets, band and marked moments,
// further runs over it and a second quantity. Needs a QApplication, no display.

#include "engine/base/units.h"
#include "widgets/plots/figure_format.h"
#include "widgets/plots/figure_png.h"
#include "widgets/plots/trace_store.h"

#include <QStringList>

namespace bask {

/// A vertical line with a short text above it.
struct FigureMoment {
    double time_s = 0.0;
    QString label;
};

/// Another run over the one of a figure, both from their Start.
struct FigureOverlay {
    QString run;         ///< its name, in the legend
    QStringList objects; ///< names of its objects
    const TraceStore* traces = nullptr;
};

/// The predicted run behind the measured one.
struct FigurePrediction {
    QString name;                ///< in the legend
    QList<QList<QPointF>> lines; ///< (s, shown unit), one for each object
};

struct TraceFigure {
    FigureLayout layout{};
    double aspect = 0.36; ///< height of the lines' place as a part of the width; 35 mm at least
    QString title, note;  ///< the heading
    QString corner{};     ///< small words at the upper right where there is no heading
    Quantity quantity = Quantity::Temperature;
    QStringList names; ///< names of the objects
    TemperatureUnit unit = TemperatureUnit::Celsius;
    SpeedLimits limits{};
    double band_K = kSettledBand_K;      ///< band around the targets, for temperatures and errors
    std::optional<FigureRange> time_s{}; ///< shown time; empty: all
    std::optional<FigureRange> yRange{}; ///< in the shown unit; empty: from the values
    QString run{};                       ///< name of the run in the legend, if others are over it
    QList<FigureOverlay> overlays{};
    std::optional<Quantity> right{}; ///< a second quantity of the run, on an axis of its own
    FigurePrediction prediction{};
    QList<FigureMoment> moments{};
};

/// Returns the figure. A black-and-white print tells its lines apart: those of one run by their dashes, those
/// of several by dashes for each run and markers for each object, those on the right axis by dots. Names and
/// units of the axes are in the window's language. Invalid readings leave gaps. `comment` is stored in the
/// file as its description. Long runs keep their extremes.
QByteArray traceFigure(const TraceFigure& figure, const TraceStore& traces, FigureFormat format,
                       const QString& comment);

} // namespace bask
