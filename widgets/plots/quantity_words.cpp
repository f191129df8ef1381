#include "widgets/plots/quantity_words.h"

#include "widgets/common/display.h"
#include "widgets/plots/trace_plot.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

QString columnWord(const char* text) {
    return QCoreApplication::translate("Column", text);
}

/// What a column says of how it is shown; null: the speed.
struct Shown {
    const char* key;
    const char* label;
    const char* title;
    const char* caption;
    const Unit* unit;
    ShownAs as;
    int decimals;
};

std::optional<Shown> shownOf(Quantity quantity) {
    const auto of = [](const auto& c) {
        return Shown{c.key, c.label, c.title, c.caption, &c.unit, c.shownAs, c.decimals};
    };
    if (const ObjectColumn* column = plottedColumn(quantity))
        return of(*column);
    if (const RunColumn* column = plottedRunColumn(quantity))
        return of(*column);
    return std::nullopt;
}

constexpr int kSignificant = 3; // digits of a number without decimals of its own

/// With the usual decimals if `wanted` is negative.
QString numberOf(double value, int usual, int wanted) {
    const int decimals = wanted < 0 ? usual : wanted;
    if (!std::isfinite(value))
        return kNoValue;
    return decimals < 0 ? QLocale().toString(value, 'g', kSignificant)
                        : QLocale().toString(roundedTo(value, decimals), 'f', decimals);
}

constexpr int kSpeedDecimals = 2;

/// In the unit of quantityText().
double shownNumber(double si, Quantity quantity, std::size_t series, TemperatureUnit unit) {
    if (shownOf(quantity))
        return displayedQuantity(si, quantity, unit);
    return series == 0 ? si * 100.0 : degFromRad(si);
}

/// The decimals of quantityText() for numbers up to `max`; -1 if so small ones are shown with an exponent.
int usualDecimals(Quantity quantity, double max) {
    constexpr int kMaxDecimals = 6;
    const auto shown = shownOf(quantity);
    if (!shown)
        return kSpeedDecimals;
    if (shown->as != ShownAs::Number)
        return 1;
    if (shown->decimals >= 0)
        return shown->decimals;
    if (!(max > 0.0) || !std::isfinite(max))
        return -1;
    const int decimals = kSignificant - 1 - static_cast<int>(std::floor(std::log10(max)));
    return decimals > kMaxDecimals ? -1 : std::max(0, decimals);
}

/// With the usual decimals if `decimals` is negative.
QString textWith(int decimals, double si, Quantity quantity, std::size_t series, TemperatureUnit unit) {
    const auto shown = shownOf(quantity);
    if (!shown) {
        if (!std::isfinite(si))
            return kNoValue;
        const QString number = numberOf(shownNumber(si, quantity, series, unit), kSpeedDecimals, decimals);
        return series == 0 ? TracePlot::tr("%1 cm/s").arg(number) : TracePlot::tr("%1 °/s").arg(number);
    }
    const int temperatureDecimals = decimals < 0 ? 1 : decimals;
    switch (shown->as) {
    case ShownAs::Temperature:
        return formatTemperature(si, unit, temperatureDecimals);
    case ShownAs::Difference:
        return formatDifference(si, unit, temperatureDecimals);
    case ShownAs::RatePerMinute:
        return formatRate(si, unit, temperatureDecimals);
    case ShownAs::Number:
        break;
    }
    const QString symbol = QString::fromUtf8(shown->unit->symbol),
                  text = numberOf(si * shown->unit->symbolPerSi, shown->decimals, decimals);
    return symbol.isEmpty() || !std::isfinite(si) ? text : text + QStringLiteral("\u00a0") + symbol;
}

} // namespace

std::vector<Quantity> furtherQuantities() {
    std::vector<Quantity> out{Quantity::Error, Quantity::ViewFactor, Quantity::Shade,
                              Quantity::Speed, Quantity::Rate,       Quantity::Strength};
    for (std::size_t q = out.size() + 1; q < quantityCount(); ++q)
        out.push_back(static_cast<Quantity>(q));
    return out;
}

QString quantityKey(Quantity quantity) {
    const auto shown = shownOf(quantity);
    return QLatin1String(shown ? shown->key : "speed");
}

QString quantityCaption(Quantity quantity) {
    const auto shown = shownOf(quantity);
    return shown && shown->caption != nullptr ? columnWord(shown->caption) : QString();
}

QString quantityTitle(Quantity quantity) {
    const auto shown = shownOf(quantity);
    return shown ? columnWord(shown->title) : TracePlot::tr("Command speed");
}

QString quantityAxis(Quantity quantity, TemperatureUnit unit) {
    const auto shown = shownOf(quantity);
    if (!shown)
        return TracePlot::tr("Speed (% of limit)");
    const QString symbol = quantityAxisUnit(quantity, unit);
    return symbol.isEmpty()
               ? columnWord(shown->label)
               : TracePlot::tr("%1 (%2)", "quantity and unit").arg(columnWord(shown->label), symbol);
}

QString quantityAxisUnit(Quantity quantity, TemperatureUnit unit) {
    const auto shown = shownOf(quantity);
    if (!shown)
        return QStringLiteral("%");
    switch (shown->as) {
    case ShownAs::Temperature:
        return temperatureUnitSymbol(unit);
    case ShownAs::Difference:
        return differenceUnitSymbol(unit);
    case ShownAs::RatePerMinute:
        return differenceUnitSymbol(unit) + QStringLiteral("/min");
    case ShownAs::Number:
        break;
    }
    return QString::fromUtf8(shown->unit->symbol);
}

QString quantitySeries(Quantity quantity, std::size_t series) {
    if (plottedColumn(quantity) != nullptr)
        return {};
    if (const RunColumn* column = plottedRunColumn(quantity))
        return columnWord(column->label);
    return series == 0 ? TracePlot::tr("translation") : TracePlot::tr("rotation");
}

ShownAs quantityShownAs(Quantity quantity) {
    const auto shown = shownOf(quantity);
    return shown ? shown->as : ShownAs::Number;
}

double displayedQuantity(double si, Quantity quantity, TemperatureUnit unit) {
    const auto shown = shownOf(quantity);
    if (!shown)
        return si;
    switch (shown->as) {
    case ShownAs::Temperature:
        return displayTemperature(si, unit);
    case ShownAs::Difference:
        return displayDifference(si, unit);
    case ShownAs::RatePerMinute:
        return displayDifference(si, unit) * 60.0;
    case ShownAs::Number:
        break;
    }
    return si * shown->unit->symbolPerSi;
}

QString quantityText(double si, Quantity quantity, std::size_t series, TemperatureUnit unit) {
    return textWith(-1, si, quantity, series, unit);
}

QuantityChange quantityChange(double first, double then, Quantity quantity, std::size_t series,
                              TemperatureUnit unit) {
    const double from = shownNumber(first, quantity, series, unit),
                 to = shownNumber(then, quantity, series, unit);
    int decimals = usualDecimals(quantity, std::max(std::abs(from), std::abs(to)));
    double by = then - first;
    if (decimals >= 0) {
        decimals = decimalsWithDifferences({&to, 1}, from, decimals);
        const double perSi =
            shownNumber(1.0, quantity, series, unit) - shownNumber(0.0, quantity, series, unit);
        by = (roundedTo(to, decimals) - roundedTo(from, decimals)) / perSi;
    }
    const auto text = [&](double si) { return textWith(decimals, si, quantity, series, unit); };
    QuantityChange out{text(first), text(then), {}};
    const ShownAs as = quantityShownAs(quantity);
    if (as == ShownAs::Temperature || as == ShownAs::Difference)
        out.by = formatDifference(by, unit, decimals);
    else
        out.by = as == ShownAs::Number && by > 0.0 ? u'+' + text(by) : text(by);
    return out;
}

} // namespace bask
