#pragma once
// What the columns of exported tables are: unit, meaning, frame, digits.

#include "engine/model/trace_sample.h"
#include "engine/recording/session_file.h"

#include <charconv>
#include <optional>
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

/// The digits of a column that mean something.
struct CsvRounding {
    std::chars_format format = std::chars_format::general;
    int digits = 9; ///< of `fixed` its decimals, of `general` all

    /// Returns a number of the column without the other digits; a whole number as it is.
    double operator()(double value) const;
};

/// Returns that of a column in this unit, whose numbers are in SI or in degC.
CsvRounding csvRounding(const Unit& unit);
/// Returns those of a session's table; none for a column that stays as it is: texts, times, and what Bask
/// does not make.
std::vector<std::optional<CsvRounding>> csvRoundings(const std::string& table,
                                                     const std::vector<std::string>& columns);

/// Returns the header of a value in traces.csv: "measured (degC)".
template <class Row> std::string csvHeader(const SampleColumn<Row>& column) {
    const bool isTemperature = column.unit.edge == EdgeUnit::Temperature;
    return std::string(column.csv) + " (" + (isTemperature ? "degC" : siUnit(column.unit)) + ')';
}
/// Returns that of a coordinate of the end-effector: "x (m)".
std::string csvCoordinateHeader(std::size_t coordinate);

} // namespace bask
