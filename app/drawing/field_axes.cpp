#include "app/drawing/field_axes.h"

#include "app/commands/experiment_arguments.h"
#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <QString>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bask {
namespace {

constexpr double kSlack = 1e-6; // of a step

Result<Coordinate> parseCoordinate(const std::string& name, const std::string& where) {
    const auto found = std::ranges::find(kCoordinateNames, name);
    if (found == kCoordinateNames.end())
        return Error(MessageCode::ValueUnknown, where, {name, "x, y, z, theta_x, theta_y, theta_z"});
    return static_cast<Coordinate>(found - kCoordinateNames.begin());
}

/// "name=rest", the name a coordinate.
struct Item {
    Coordinate coordinate;
    QString rest;
};

Result<Item> parseItem(const QString& text, const std::string& where, const char* expected) {
    const auto equals = text.indexOf(u'=');
    if (equals < 0)
        return Error(MessageCode::JsonWrongType, where, {expected, '"' + text.toStdString() + '"'});
    const auto coordinate = parseCoordinate(text.left(equals).trimmed().toStdString(), where);
    if (!coordinate)
        return coordinate.error();
    return Item{*coordinate, text.mid(equals + 1)};
}

Result<FieldAxis> parseAxis(const QString& text) {
    constexpr const char* kExpected = "an axis such as x=-0.2:0.2:0.01 (first:last:step)";
    const auto item = parseItem(text, "--axes", kExpected);
    if (!item)
        return item.error();
    const QStringList parts = item->rest.split(u':');
    if (parts.size() != 3)
        return Error(MessageCode::JsonWrongType, "--axes", {kExpected, '"' + text.toStdString() + '"'});
    const std::string where = std::string("--axes: ") + kCoordinateNames[item->coordinate] + ": ";
    const auto first = finiteNumber(parts[0], where + "first");
    if (!first)
        return first.error();
    const auto last = finiteNumber(parts[1], where + "last");
    if (!last)
        return last.error();
    const auto step = finiteNumber(parts[2], where + "step");
    if (!step)
        return step.error();
    if (!(*step > 0.0))
        return Error(MessageCode::ValueNotPositive, where + "step", {formatNumber(*step)});
    if (*last < *first)
        return Error(MessageCode::LimitsReversed, where + "first:last",
                     {formatNumber(*first), formatNumber(*last)});
    const double count = std::floor((*last - *first) / *step + kSlack) + 1.0;
    if (count > kMaxAxisSamples)
        return Error(MessageCode::FieldTooLarge, "--axes: " + text.toStdString(),
                     {formatNumber(count, 12), std::to_string(kMaxAxisSamples)});
    return FieldAxis{item->coordinate, *first, *step, static_cast<int>(count)};
}

FieldAxis degrees(Coordinate coordinate) {
    return {coordinate, radFromDeg(-90.0), radFromDeg(2.0), 90};
}

bool hasAxis(const std::vector<FieldAxis>& axes, Coordinate coordinate) {
    return std::ranges::find(axes, coordinate, &FieldAxis::coordinate) != axes.end();
}

} // namespace

Result<std::vector<FieldAxis>> parseFieldAxes(const std::string& text) {
    std::vector<FieldAxis> axes;
    for (const QString& part : QString::fromStdString(text).split(u',')) {
        const auto axis = parseAxis(part);
        if (!axis)
            return axis.error();
        if (hasAxis(axes, axis->coordinate))
            return Error(MessageCode::AxisTwice, "--axes", {kCoordinateNames[axis->coordinate]});
        axes.push_back(*axis);
    }
    return axes;
}

Result<void> parseFixed(const std::string& text, const std::vector<FieldAxis>& axes, Vector6d& fixed,
                        const std::string& option) {
    std::vector<Coordinate> seen;
    for (const QString& part : QString::fromStdString(text).split(u',')) {
        const auto item = parseItem(part, option, "a coordinate such as theta_x=0.1");
        if (!item)
            return item.error();
        const std::string name = kCoordinateNames[item->coordinate];
        if (hasAxis(axes, item->coordinate))
            return Error(MessageCode::HeldIsAxis, option, {name});
        if (std::ranges::find(seen, item->coordinate) != seen.end())
            return Error(MessageCode::JsonDuplicateKey, option, {name});
        const auto value = finiteNumber(item->rest, option + ": " + name);
        if (!value)
            return value.error();
        seen.push_back(item->coordinate);
        fixed[item->coordinate] = *value;
    }
    return {};
}

Result<PresetGrid> presetGrid(const std::string& name) {
    PresetGrid grid;
    if (name == "paper-translation") {
        grid.axes = {{kX, -0.20, 0.01, 40}, {kY, -0.20, 0.01, 40}, {kZ, 0.01, 0.01, 30}};
    } else if (name == "paper-rotation") {
        grid.axes = {degrees(kThetaX), degrees(kThetaY), degrees(kThetaZ)};
        grid.fixed[kZ] = 0.05;
    } else {
        return Error(MessageCode::ValueUnknown, "--preset", {name, "paper-translation, paper-rotation"});
    }
    return grid;
}

Shape presetSource() {
    return Disk{0.10};
}

Shape presetObject() {
    return Disk{0.015};
}

} // namespace bask
