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

/// A quantity against time; empty: the trajectories.
using RunFigure = std::optional<Quantity>;
/// All, in the order of the report.
std::vector<RunFigure> runFigures();

/// "temperatures": a file's name without its ending, the same in every language.
std::string runFigureStem(RunFigure figure);
/// What is to be seen, in a sentence or two.
QString runFigureCaption(RunFigure figure, const SessionRecord& session, TemperatureUnit unit);

/// What every figure file holds as its description, so that an export replaces its own files and no others.
inline const QString kRunFigureMark = QStringLiteral("Bask figure of a run");

/// Draws figures of one record in the window's language; numbers at dotted lines are those of the record's
/// events that are marked. Needs a QApplication and its thread, no display.
class RunFigures {
public:
    RunFigures(const SessionRecord& session, TemperatureUnit unit);
    ~RunFigures();

    /// Without samples: empty axes.
    QByteArray draw(RunFigure figure, FigureFormat format) const;

    RunFigures(const RunFigures&) = delete;
    RunFigures& operator=(const RunFigures&) = delete;

private:
    struct Impl;
    std::unique_ptr<Impl> m_impl;
};

/// Number of an event in figures and tables, from 1; 0: it is not marked. All alarms, holds, changes and the
/// end, the first kMaxMarked of them.
std::vector<int> markedEvents(const std::vector<TraceEvent>& events);
inline constexpr int kMaxMarked = 30;

} // namespace bask
