#include "widgets/thermal/thermal_object_list.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kCellPad = 14;
enum ThermalColumn { kThermalName, kThermalReading, kThermalSpread, kThermalColumns };

QString spreadText(double spread_K, TemperatureUnit unit) {
    if (!std::isfinite(spread_K))
        return kNoValue;
    return QLocale().toString(displayDifference(spread_K, unit), 'f', 1) + QChar(0x00a0) +
           differenceUnitSymbol(unit);
}

} // namespace

ThermalObjectList::ThermalObjectList(QWidget* parent) : QTableWidget(1, kThermalColumns, parent) {
    setObjectName(QStringLiteral("thermalObjects"));
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionBehavior(QAbstractItemView::SelectRows);
    setSelectionMode(QAbstractItemView::SingleSelection);
    setShowGrid(false);
    setTabKeyNavigation(false);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(fontMetrics().height() + 6);
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    setRows();
    selectRow(0);
    connect(this, &QTableWidget::itemSelectionChanged, this, &ThermalObjectList::chosenChanged);
}

QSize ThermalObjectList::sizeHint() const {
    int height = horizontalHeader()->sizeHint().height() + 2 * frameWidth();
    for (int row = 0; row < rowCount(); ++row)
        height += rowHeight(row);
    return {280, std::min(height, 260)};
}

void ThermalObjectList::setNames(const std::vector<QString>& names) {
    m_names = names;
    setRows();
}

void ThermalObjectList::setRows() {
    setAccessibleName(tr("Temperatures by the thermal camera"));
    setHorizontalHeaderLabels({tr("Object"), tr("Temperature"), tr("Spread")});
    horizontalHeaderItem(kThermalName)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(kThermalReading)
        ->setToolTip(tr("Reflections and emittance are taken into account; with two standard deviations."));
    horizontalHeaderItem(kThermalSpread)->setToolTip(tr("Largest difference across the object."));
    setRowCount(1 + static_cast<int>(m_names.size()));
    setCell(0, kThermalName, tr("Whole picture"));
    for (int row = 1; row < rowCount(); ++row) {
        setCell(row, kThermalName, m_names[static_cast<std::size_t>(row - 1)]);
        item(row, kThermalName)
            ->setIcon(QIcon(seriesSwatch(row - 1, isDark(this), {20, 12}, devicePixelRatioF())));
    }
    if (selectedItems().isEmpty())
        selectRow(0);
    updateGeometry();
}

void ThermalObjectList::setCell(int row, int column, const QString& text, const QString& toolTip) {
    if (item(row, column) == nullptr) {
        setItem(row, column, new QTableWidgetItem);
        item(row, column)
            ->setTextAlignment((column == kThermalName ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    }
    if (item(row, column)->text() != text)
        item(row, column)->setText(text);
    item(row, column)->setToolTip(toolTip);
}

// Over both columns of values, in as many lines as it needs.
void ThermalObjectList::showReason(int row, const QString& reason) {
    const QTableWidgetItem* shown = item(row, kThermalReading);
    if (shown != nullptr && shown->text() == reason && columnSpan(row, kThermalReading) == 2)
        return;
    setSpan(row, kThermalReading, 1, 2);
    setCell(row, kThermalReading, reason, reason);
    item(row, kThermalReading)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
}

void ThermalObjectList::fitRow(int row) {
    const QTableWidgetItem* shown = item(row, kThermalReading);
    int height = verticalHeader()->defaultSectionSize();
    if (shown != nullptr && columnSpan(row, kThermalReading) == 2) {
        const int room = columnWidth(kThermalReading) + columnWidth(kThermalSpread) - kCellPad;
        height += fontMetrics().boundingRect(0, 0, room, 1000, Qt::TextWordWrap, shown->text()).height() -
                  fontMetrics().height();
    }
    if (height == rowHeight(row))
        return;
    setRowHeight(row, height);
    updateGeometry();
}

// As wide as the readings, not as the reasons; the names have the rest.
void ThermalObjectList::fitColumns() {
    int widths[kThermalColumns] = {};
    for (const int column : {kThermalReading, kThermalSpread}) {
        widths[column] = fontMetrics().horizontalAdvance(horizontalHeaderItem(column)->text());
        for (int row = 0; row < rowCount(); ++row)
            if (item(row, column) != nullptr && columnSpan(row, column) == 1)
                widths[column] =
                    std::max(widths[column], fontMetrics().horizontalAdvance(item(row, column)->text()));
        widths[column] += kCellPad;
    }
    widths[kThermalName] =
        std::max(60, viewport()->width() - widths[kThermalReading] - widths[kThermalSpread]);
    for (int column = 0; column < kThermalColumns; ++column)
        if (columnWidth(column) != widths[column])
            setColumnWidth(column, widths[column]);
    for (int row = 0; row < rowCount(); ++row)
        fitRow(row);
}

void ThermalObjectList::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitColumns();
}

void ThermalObjectList::showReading(int row, const ThermalObjectView& object, bool isCurrent,
                                    TemperatureUnit unit) {
    if (columnSpan(row, kThermalReading) != 1) {
        setSpan(row, kThermalReading, 1, 1);
        item(row, kThermalReading)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    const bool isShown = isCurrent && object.T_K;
    const QString reading =
        isShown ? formatReading(*object.T_K, object.uncertainty_K, unit) : QString(kNoValue);
    if (isShown && object.isPartlyOutside)
        setCell(row, kThermalReading, tr("%1 (part)").arg(reading),
                tr("A part of the object is outside of the picture: the reading is that of the rest."));
    else
        setCell(row, kThermalReading, reading);
    setCell(row, kThermalSpread, isShown ? spreadText(object.spread_K, unit) : QString(kNoValue));
}

void ThermalObjectList::showView(const ThermalView& view, const std::optional<ThermalRange>& range,
                                 bool isCurrent, TemperatureUnit unit) {
    QString whole = kNoValue;
    if (range && isCurrent)
        whole = tr("%1 to %2")
                    .arg(formatTemperatureNumber(range->min_K, unit), formatTemperature(range->max_K, unit));
    setCell(0, kThermalReading, whole, tr("Apparent temperatures of all but the 0.5 % at either end."));
    setCell(0, kThermalSpread, QString());
    for (int row = 1; row < rowCount(); ++row) {
        const auto i = static_cast<std::size_t>(row - 1);
        const ThermalObjectView object = i < view.objects.size() ? view.objects[i] : ThermalObjectView{};
        if (isCurrent && !object.T_K && object.reason != Message{})
            showReason(row, sentenceText(object.reason, unit));
        else
            showReading(row, object, isCurrent, unit);
    }
    fitColumns();
}

std::optional<std::size_t> ThermalObjectList::chosen() const {
    const int row = selectedItems().isEmpty() ? 0 : selectedItems().front()->row();
    return row > 0 ? std::optional(static_cast<std::size_t>(row - 1)) : std::nullopt;
}

QString ThermalObjectList::chosenName() const {
    return item(chosen() ? static_cast<int>(*chosen()) + 1 : 0, kThermalName)->text();
}

void ThermalObjectList::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        setRows();
}

} // namespace bask
