#include "widgets/plots/quantity_words.h"

#include "widgets/common/display.h"
#include "widgets/plots/trace_plot.h"

#include <QCoreApplication>
#include <QLocale>

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

QString numberOf(double si, const Shown& shown) {
    if (!std::isfinite(si))
        return kNoValue;
    const double value = si * shown.unit->symbolPerSi;
    return shown.decimals < 0 ? QLocale().toString(value, 'g', 3)
                              : QLocale().toString(value, 'f', shown.decimals);
}

} // namespace

std::vector<Quantity> furtherQuantities() {
    std::vector<Quantity> out{Quantity::Error, Quantity::ViewFactor, Quantity::Speed, Quantity::Rate,
                              Quantity::Strength};
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
    const auto withUnit = [&](const QString& symbol) {
        return TracePlot::tr("%1 (%2)", "quantity and unit").arg(columnWord(shown->label), symbol);
    };
    switch (shown->as) {
    case ShownAs::Temperature:
        return withUnit(temperatureUnitSymbol(unit));
    case ShownAs::Difference:
        return withUnit(differenceUnitSymbol(unit));
    case ShownAs::RatePerMinute:
        return withUnit(differenceUnitSymbol(unit) + QStringLiteral("/min"));
    case ShownAs::Number:
        break;
    }
    const QString symbol = QString::fromUtf8(shown->unit->symbol);
    return symbol.isEmpty() ? columnWord(shown->label) : withUnit(symbol);
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
    const auto shown = shownOf(quantity);
    if (!shown) {
        if (!std::isfinite(si))
            return kNoValue;
        return series == 0 ? TracePlot::tr("%1 cm/s").arg(QLocale().toString(si * 100.0, 'f', 2))
                           : TracePlot::tr("%1 °/s").arg(QLocale().toString(degFromRad(si), 'f', 2));
    }
    switch (shown->as) {
    case ShownAs::Temperature:
        return formatTemperature(si, unit);
    case ShownAs::Difference:
        return formatDifference(si, unit);
    case ShownAs::RatePerMinute:
        return formatRate(si, unit);
    case ShownAs::Number:
        break;
    }
    const QString symbol = QString::fromUtf8(shown->unit->symbol), text = numberOf(si, *shown);
    return symbol.isEmpty() || !std::isfinite(si) ? text : text + QStringLiteral("\u00a0") + symbol;
}

QString quantityChange(double si, Quantity quantity, std::size_t series, TemperatureUnit unit) {
    switch (quantityShownAs(quantity)) {
    case ShownAs::Temperature:
    case ShownAs::Difference:
        return formatDifference(si, unit);
    case ShownAs::RatePerMinute:
        return formatRate(si, unit);
    case ShownAs::Number:
        break;
    }
    const QString text = quantityText(si, quantity, series, unit);
    return si > 0.0 ? u'+' + text : text;
}

} // namespace bask
