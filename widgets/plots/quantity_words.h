#pragma once
// How plots and figures show a quantity: its words, and its values in the chosen unit.

#include "engine/base/units.h"
#include "engine/recording/trace_overview.h"

#include <QString>

#include <vector>

namespace bask {

/// Returns all quantities except the temperatures, in the order of the tabs.
std::vector<Quantity> furtherQuantities();
/// Returns the name that is the same in every language: the column's key, or "speed".
QString quantityKey(Quantity quantity);
QString quantityTitle(Quantity quantity);                      ///< "View factors"
QString quantityAxis(Quantity quantity, TemperatureUnit unit); ///< "Rate (\u00b0C/min)"
/// Returns only its unit, as in it; empty for a number without one.
QString quantityAxisUnit(Quantity quantity, TemperatureUnit unit);
/// name of a series of the run; empty for a quantity of objects
QString quantitySeries(Quantity quantity, std::size_t series);
/// Returns the caption for the report, with its "%1" if it has one; empty if the report has no such figure.
QString quantityCaption(Quantity quantity);

ShownAs quantityShownAs(Quantity quantity);
/// Converts from SI to the shown unit; a speed stays in SI.
double displayedQuantity(double si, Quantity quantity, TemperatureUnit unit);
/// Returns the value with its unit; that of a speed depends on the series.
QString quantityText(double si, Quantity quantity, std::size_t series, TemperatureUnit unit);
/// Two values and their difference, each with its unit.
struct QuantityChange {
    QString first, then, by; ///< `by` has a sign
};
/// Returns them with decimals by which the printed difference is that of the printed values.
QuantityChange quantityChange(double first, double then, Quantity quantity, std::size_t series,
                              TemperatureUnit unit);

} // namespace bask
