#include "engine/recording/csv_columns.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace bask {
namespace {

constexpr const char* kTraces = "traces.csv";
constexpr const char* kPrediction = "prediction.csv";

// What is not in the tables of columns.
struct FixedColumn {
    const char *file, *column, *unit, *meaning;
};
constexpr std::array kFixedColumns{
    FixedColumn{"*.csv", "time_s", "s", "since Start, on the rig's clock; negative before it"},
    FixedColumn{"*.csv", "object", "", "name of the object"},
    FixedColumn{kPrediction, "temperature_K", "K", "of the run as it was predicted before Start"},
    FixedColumn{
        kPrediction, "lowest_K", "K",
        "the least of it and of runs with other sensor noise; not with other material, air or source"},
    FixedColumn{kPrediction, "highest_K", "K", "the greatest of these"},
    FixedColumn{"pose.csv", "x_m", "m", "origin of the end-effector E in the robot's base R; so y_m, z_m"},
    FixedColumn{"pose.csv", "qw", "1", "unit quaternion of E in R, qw not negative; with qx, qy, qz"},
    FixedColumn{"source_pose.csv", "x_m", "m", "origin of the source S in the robot's base R; so y_m, z_m"},
    FixedColumn{"source_pose.csv", "qw", "1", "unit quaternion of S in R; with qx, qy, qz"},
    FixedColumn{
        "meta.csv", "created", "",
        "when the recording was opened, at Arm: ISO 8601, UTC, by the computer's clock. Start, the zero "
        "of all times, comes later"},
    FixedColumn{"meta.csv", "finished", "", "when it was closed, by the same clock"},
    FixedColumn{"meta.csv", "simulated", "", "true, false"},
    FixedColumn{"meta.csv", "outcome", "", "how the run ended"},
    FixedColumn{"meta.csv", "verification", "",
                "whether the recording is as it was made, with the head of its hash chain"},
    FixedColumn{"meta.csv", "simulation_pace", "",
                "how fast it was simulated; only where that was not the pace of the computer's clock"},
};

constexpr std::array<const char*, 6> kCoordinateMeanings{
    "origin of the end-effector E in the robot's base R, along x of R",
    "the same along y of R",
    "the same along z of R",
    "angle of E in R, whose rotation is Rz(theta_z) Ry(theta_y) Rx(theta_x)",
    "the same about y",
    "the same about z"};

template <class Row> std::string meaningOf(const SampleColumn<Row>& column) {
    return column.nexus ? column.nexus->description : column.stored.place == 0 ? "measured minus target" : "";
}

template <class Columns>
void addStored(std::vector<CsvColumn>& out, const Columns& columns, const RecordedRig& rig) {
    for (const auto& column : columns)
        if (column.stored.place > 0 && rig.has(column.needs))
            out.push_back({std::string(column.stored.view) + ".csv", column.nameInView(), siUnit(column.unit),
                           meaningOf(column)});
}

/// The unit of a stored column; none if there is no such column in the table.
template <class Columns>
std::optional<Unit> storedUnit(const Columns& columns, const std::string& table, const std::string& name) {
    const auto found = std::ranges::find_if(columns, [&](const auto& column) {
        return column.stored.place > 0 && column.stored.view == table && column.nameInView() == name;
    });
    return found == columns.end() ? std::nullopt : std::optional(found->unit);
}

std::optional<CsvRounding> roundingOf(const std::string& table, const std::string& column) {
    constexpr int kQuaternionDecimals = 7; // for angles to 1e-6 rad
    if ((table == "pose" || table == "source_pose") && column.starts_with('q'))
        return CsvRounding{std::chars_format::fixed, kQuaternionDecimals};
    if ((table == "pose" || table == "source_pose") && column.ends_with("_m"))
        return csvRounding(unit::kMillimetres);
    if (table == "prediction" && column.ends_with("_K"))
        return csvRounding(unit::kCelsius);
    auto unit = storedUnit(kObjectColumns, table, column);
    if (!unit)
        unit = storedUnit(kRunColumns, table, column);
    return unit ? std::optional(csvRounding(*unit)) : std::nullopt;
}

} // namespace

double CsvRounding::operator()(double value) const {
    if (value == std::trunc(value)) // a count keeps its units
        return value + 0.0;         // no minus zero
    std::array<char, 32> text{};    // of a fraction: below 2^53
    char* const end = std::to_chars(text.data(), text.data() + text.size(), value, format, digits).ptr;
    (void)std::from_chars(text.data(), end, value);
    return value + 0.0;
}

CsvRounding csvRounding(const Unit& unit) {
    constexpr int kKelvinDecimals = 3, kDecimals = 6, kVelocityDecimals = 7;
    const std::string_view suffix = unit.suffix;
    const auto isAnyOf = [&](std::initializer_list<std::string_view> suffixes) {
        return std::ranges::find(suffixes, suffix) != suffixes.end();
    };
    if (isAnyOf({"degC", "K"}))
        return {std::chars_format::fixed, kKelvinDecimals};
    if (isAnyOf({"cm_s", "rad_s"}))
        return {std::chars_format::fixed, kVelocityDecimals};
    if (isAnyOf({"", "s", "cm", "mm", "rad", "deg"}))
        return {std::chars_format::fixed, kDecimals};
    return {};
}

std::vector<std::optional<CsvRounding>> csvRoundings(const std::string& table,
                                                     const std::vector<std::string>& columns) {
    std::vector<std::optional<CsvRounding>> out;
    out.reserve(columns.size());
    for (const std::string& column : columns)
        out.push_back(roundingOf(table, column));
    return out;
}

std::string csvCoordinateHeader(std::size_t coordinate) {
    return std::string(kCoordinateNames[coordinate]) + (coordinate < 3 ? " (m)" : " (rad)");
}

std::vector<CsvColumn> csvColumns(const SessionRecord& facts) {
    const RecordedRig rig = facts.rig();
    std::vector<CsvColumn> out{{kTraces, "time (s)", "s", "since Start, on the rig's clock"}};
    const auto unitIn = [](const std::string& header) {
        const std::size_t bracket = header.rfind('(');
        return header.substr(bracket + 1, header.size() - bracket - 2);
    };
    const auto add = [&](const std::string& header, const std::string& meaning) {
        out.push_back({kTraces, header, unitIn(header), meaning});
    };
    for (const RunColumn& column : kRunColumns)
        if (column.csv != nullptr)
            add(csvHeader(column), meaningOf(column));
    for (std::size_t k = 0; k < kCoordinateNames.size(); ++k)
        add(csvCoordinateHeader(k), kCoordinateMeanings[k]);
    for (const ObjectSpec& object : facts.experiment.objects)
        for (const ObjectColumn& column : kObjectColumns)
            if (column.csv != nullptr && rig.has(column.needs))
                add(object.name + ' ' + csvHeader(column), meaningOf(column));
    for (const FixedColumn& fixed : kFixedColumns)
        if (fixed.file != std::string_view(kPrediction) || !facts.prediction.samples.empty())
            out.push_back({fixed.file, fixed.column, fixed.unit, fixed.meaning});
    addStored(out, kObjectColumns, rig);
    addStored(out, kRunColumns, rig);
    return out;
}

} // namespace bask
