#pragma once
// The figures of a recorded run: quantities against time, trajectories.

#include "engine/base/units.h"
#include "engine/recording/session_file.h"
#include "engine/recording/trace_overview.h"
#include "widgets/plots/figure_format.h"

#include <QByteArray>
#include <QString>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// A quantity over time; empty for the trajectories.
using RunFigure = std::optional<Quantity>;
/// Returns all figures of a run in the order of the report; that of the shade where there can be some.
std::vector<RunFigure> runFigures(const SessionRecord& session);

/// Returns "temperatures": a file name without its suffix, the same in every language.
std::string runFigureStem(RunFigure figure);
/// Returns what the figure shows, in one or two sentences.
QString runFigureCaption(RunFigure figure, const SessionRecord& session, TemperatureUnit unit);

/// The description in every figure file, so that an export replaces only its own files.
inline const QString kRunFigureMark = QStringLiteral("Bask figure of a run");

/// Draws figures of one record in the window's language; numbers at dotted lines are those of the marked
/// events, and need the heading. Needs a QApplication and its thread, but no display.
class RunFigures {
public:
    /// `namesMoments`: the heading says what the numbers of events are, as no list beside the figure does.
    RunFigures(const SessionRecord& session, TemperatureUnit unit, const FigureLayout& layout = {},
               bool namesMoments = false);
    ~RunFigures();

    /// Draws a figure; without samples, empty axes.
    QByteArray draw(RunFigure figure, FigureFormat format) const;

    RunFigures(const RunFigures&) = delete;
    RunFigures& operator=(const RunFigures&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Returns the number of each event in figures and tables, from 1; 0 if it is not marked. Alarms, holds,
/// changes and the end are marked, the first kMaxMarked of them.
std::vector<int> markedEvents(const std::vector<TraceEvent>& events);
inline constexpr int kMaxMarked = 30;

} // namespace bask
