#pragma once
// A figure for a report: a quantity of all objects of a run over time, with targets, band and marked moments.
// Needs a QApplication, no display.

#include "engine/base/units.h"
#include "widgets/plots/figure_format.h"
#include "widgets/plots/figure_png.h"
#include "widgets/plots/trace_store.h"

#include <QStringList>

namespace bask {

/// A vertical line with a short text at its top.
struct FigureMoment {
    double time_s = 0.0;
    QString label;
};

struct TraceFigure {
    QString title, note;
    Quantity quantity = Quantity::Temperature;
    QStringList names; ///< names of the objects
    TemperatureUnit unit = TemperatureUnit::Celsius;
    SpeedLimits limits{};
    double band_K = kSettledBand_K;      ///< band around the targets, for temperatures and errors
    std::optional<FigureRange> yRange{}; ///< in the shown unit; empty: from the values
    QList<FigureMoment> moments{};
    QSize size_px{kFigureWidth_px, 900};
};

/// Returns the figure. Names and units of the axes are in the window's language. Invalid readings leave gaps.
/// `comment` is stored in the file as its description. Long runs keep their extremes.
QByteArray traceFigure(const TraceFigure& figure, const TraceStore& traces, FigureFormat format,
                       const QString& comment);

} // namespace bask
