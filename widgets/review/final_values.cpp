#include "widgets/review/final_values.h"

#include "widgets/common/display.h"
#include "widgets/common/metric_words.h"
#include "widgets/common/theme.h"
#include "widgets/review/object_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kDecimalsOfTruth = 2;
constexpr int kDecimalsInKelvin = 2; // of a target typed in tenths of a degree Celsius, at least

enum Column { kName, kTarget, kFinal, kTrue, kError, kSettling, kColumns };

} // namespace

std::vector<FinalValue> finalValues(const QStringList& names, const RunMetrics& metrics,
                                    TemperatureUnit unit) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const int least = unit == TemperatureUnit::Kelvin ? kDecimalsInKelvin : 0;
    std::vector<FinalValue> values;
    for (std::size_t i = 0; i < metrics.objects.size(); ++i) {
        const ObjectMetrics& object = metrics.objects[i];
        const bool hasTruth = i < metrics.trueObjects.size();
        values.push_back(
            {names.value(static_cast<qsizetype>(i)), object.target_K, object.final_K.value_or(kUnknown),
             hasTruth ? metrics.trueObjects[i].final_K.value_or(kUnknown) : kUnknown, object.settledFrom_s,
             std::max(least, metricDecimals({ObjectMetric::Final}, metrics, i, unit))});
    }
    return values;
}

FinalValuesTable::FinalValuesTable(QWidget* parent) : QTableWidget(0, kColumns, parent) {
    styleObjectTable(*this);
    refresh();
}

void FinalValuesTable::setRun(const QStringList& names, const RunMetrics& metrics) {
    m_names = names;
    m_metrics = metrics;
    refresh();
}

void FinalValuesTable::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

void FinalValuesTable::refresh() {
    const std::vector<FinalValue> values = finalValues(m_names, m_metrics, m_unit);
    setAccessibleName(tr("Final values"));
    setHorizontalHeaderLabels(
        {tr("Object"), tr("Target"), tr("Final"), tr("True"), tr("Error"), tr("Settled at")});
    setColumnHidden(kTrue, std::ranges::none_of(
                               values, [](const FinalValue& value) { return std::isfinite(value.true_K); }));
    horizontalHeaderItem(kName)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(kFinal)->setToolTip(tr("What the thermometer read when the run was stopped"));
    horizontalHeaderItem(kTrue)->setToolTip(
        tr("The simulated object's own temperature when the run was stopped, which no sensor tells"));
    horizontalHeaderItem(kSettling)->setToolTip(
        tr("Time of the run from which the object stays within %1 of its target until the end")
            .arg(QStringLiteral("\u00b1") + formatDifference(kSettledBand_K, m_unit).mid(1)));
    setRowCount(static_cast<int>(values.size()));
    fitHeightToRows(*this);
    for (int row = 0; row < rowCount(); ++row) {
        const FinalValue& value = values[static_cast<std::size_t>(row)];
        const QString settling = value.settling_s
                                     ? tr("%1 s").arg(QLocale().toString(*value.settling_s, 'f', 0))
                                     : tr("not settled");
        const QStringList texts{
            value.name,
            formatTemperature(value.target_K, m_unit, value.decimals),
            formatTemperature(value.final_K, m_unit, value.decimals),
            formatTemperature(value.true_K, m_unit, kDecimalsOfTruth),
            formatPrintedDifference(value.final_K, value.target_K, m_unit, value.decimals),
            settling};
        for (int column = 0; column < kColumns; ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment((column == kName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            if (column == kName)
                item->setIcon(QIcon(seriesSwatch(row, isDark(this), {20, 12}, devicePixelRatioF())));
            if (column == kSettling && !value.settling_s)
                item->setIcon(QIcon(alarmPixmap(3, isDark(this), 16, devicePixelRatioF())));
            setItem(row, column, item);
        }
    }
}

void FinalValuesTable::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QTableWidget::changeEvent(event);
}

void FinalValuesTable::keyPressEvent(QKeyEvent* event) {
    if (!event->matches(QKeySequence::Copy))
        return QTableWidget::keyPressEvent(event);
    copyTable(*this);
}

} // namespace bask
