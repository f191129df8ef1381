#pragma once
// What the columns of exported tables are: unit, meaning, frame.

#include "engine/model/trace_sample.h"
#include "engine/recording/session_file.h"

#include <string>
#include <vector>

namespace bask {

struct CsvColumn {
    std::string file;   ///< "traces.csv"; "*.csv": all that have it
    std::string column; ///< its header; in meta.csv the key of a row
    std::string unit;   ///< empty: none
    std::string meaning;
};

/// Returns the columns of traces.csv and of the tables of a session, in English.
std::vector<CsvColumn> csvColumns(const SessionRecord& facts);

/// Returns the header of a value in traces.csv: "measured (degC)".
template <class Row> std::string csvHeader(const SampleColumn<Row>& column) {
    const bool isTemperature = column.unit.edge == EdgeUnit::Temperature;
    return std::string(column.csv) + " (" + (isTemperature ? "degC" : siUnit(column.unit)) + ')';
}
/// Returns that of a coordinate of the end-effector: "x (m)".
std::string csvCoordinateHeader(std::size_t coordinate);

} // namespace bask
