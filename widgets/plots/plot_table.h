#pragma once
// What a plot shows, as a table for other programs: a value, from which another thread makes the text.

#include "engine/base/result.h"
#include "engine/model/trace.h"

#include <QString>
#include <QStringList>

#include <stop_token>
#include <string>
#include <vector>

namespace bask {

class TraceStore;

struct PlotTable {
    struct Column {
        QString header;
        Quantity quantity = Quantity::Temperature;
        std::size_t series = 0;
        bool isTarget = false;        ///< of the object `series`
        std::vector<double> values{}; ///< degC, or else SI; NaN if unknown
    };
    /// Its columns have no values yet if it is a recorded one.
    struct Run {
        QString name;     ///< before its headers; empty if it is alone
        std::string path; ///< its recording; empty for a live run
        std::vector<double> times_s{};
        std::vector<Column> columns{};
    };
    double from_s = 0.0, to_s = 0.0; ///< the shown time
    bool isCut = false;              ///< the first samples of a live run are not kept any more
    std::vector<Run> runs{};
    QString mark; ///< header of a last column without values
};

/// Adds columns of a quantity: one for each object, or those of the run.
void addQuantity(PlotTable::Run& run, const TraceStore& traces, const QStringList& objects,
                 Quantity quantity);
/// Adds the objects' targets.
void addTargets(PlotTable::Run& run, const TraceStore& traces, const QStringList& objects);
/// Copies times and values of a live run.
void addLiveRows(PlotTable::Run& run, const TraceStore& traces, double from_s, double to_s);

/// Reads each recording once and returns the table as CSV, runs beside each other; what is unknown, and the
/// rows after the end of a shorter run, are empty. Any thread; seconds for a long run. Incomplete once `stop`
/// is requested. Errors: those of readSamples.
Result<std::string> plotTableCsv(PlotTable table, const std::stop_token& stop);

} // namespace bask
