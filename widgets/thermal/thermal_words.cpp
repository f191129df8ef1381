#include "widgets/thermal/thermal_words.h"

#include "widgets/common/display.h"

#include <QLocale>

namespace bask {

QString thermalReadingText(double T_K, double uncertainty_K, TemperatureUnit unit) {
    const double expanded = displayDifference(2.0 * uncertainty_K, unit);
    const int decimals = expanded < 0.095 ? 2 : 1;
    return formatTemperature(T_K, unit, decimals) + QStringLiteral(" \u00b1 ") +
           QLocale().toString(expanded, 'f', decimals) + QChar(0x00a0) + differenceUnitSymbol(unit);
}

} // namespace bask
