#include "engine/recording/csv_columns.h"

#include <array>

namespace bask {
namespace {

constexpr const char* kTraces = "traces.csv";

// What is not in the tables of columns.
struct FixedColumn {
    const char *file, *column, *unit, *meaning;
};
constexpr std::array kFixedColumns{
    FixedColumn{"*.csv", "time_s", "s", "since Start, on the rig's clock; negative before it"},
    FixedColumn{"*.csv", "object", "", "name of the object"},
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

} // namespace

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
        out.push_back({fixed.file, fixed.column, fixed.unit, fixed.meaning});
    addStored(out, kObjectColumns, rig);
    addStored(out, kRunColumns, rig);
    return out;
}

} // namespace bask
