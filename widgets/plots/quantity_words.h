#pragma once
// How plots and figures show a quantity: its words, and its values in the unit that a reader chose.

#include "engine/base/units.h"
#include "engine/recording/trace_overview.h"

#include <QString>

#include <vector>

namespace bask {

/// All but that of the temperatures, in the order of tabs.
std::vector<Quantity> furtherQuantities();
/// Plain name, the same in every language: the column's key, "speed".
QString quantityKey(Quantity quantity);
QString quantityTitle(Quantity quantity);                      ///< "View factors"
QString quantityAxis(Quantity quantity, TemperatureUnit unit); ///< "Rate (\u00b0C/min)"
QString quantitySeries(Quantity quantity, std::size_t series); ///< of one of the run; empty: one of objects
/// For the report, with its "%1" where it has one; empty: the report has no such figure.
QString quantityCaption(Quantity quantity);

ShownAs quantityShownAs(Quantity quantity);
/// From SI; a speed stays in SI.
double displayedQuantity(double si, Quantity quantity, TemperatureUnit unit);
/// With its unit; a speed by its series.
QString quantityText(double si, Quantity quantity, std::size_t series, TemperatureUnit unit);
/// Digits after the point of a difference between two displayed values.
int quantityDecimals(Quantity quantity);

} // namespace bask
