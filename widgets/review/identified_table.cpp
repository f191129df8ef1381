#include "widgets/review/identified_table.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"
#include "widgets/review/object_table.h"

#include <QEvent>
#include <QHeaderView>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

enum LossColumn { kLossPart, kWorking, kLoss, kConvection, kLossColumns };
enum IdentifiedColumn { kPart, kIdentified, kController, kMaterial, kBegun, kIdentifiedColumns };

QString number(double value, int digits = 4) {
    return std::isfinite(value) ? QLocale().toString(value, 'g', digits) : QString(kNoValue);
}

/// Both with as many digits as make two of the error.
QString withError(const IdentifiedRow::Value& value) {
    if (!std::isfinite(value.value))
        return kNoValue;
    const QString between = QStringLiteral(" \u00b1 ");
    const double error = value.standardError;
    if (std::abs(value.value) < 1e-3 || !(error > 0.0))
        return number(value.value) + between + number(error, 2);
    const int decimals = std::clamp(1 - static_cast<int>(std::floor(std::log10(error))), 0, 6);
    return QLocale().toString(value.value, 'f', decimals) + between +
           QLocale().toString(error, 'f', decimals);
}

/// A number, or with its object's line the name in the first column.
QTableWidgetItem* objectCell(QTableWidget& table, int row, int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setTextAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (column == 0)
        item->setIcon(QIcon(seriesSwatch(row, isDark(&table), {20, 12}, table.devicePixelRatioF())));
    table.setItem(row, column, item);
    return item;
}

} // namespace

IdentifiedTable::IdentifiedTable(QWidget* parent) : QTableWidget(0, kIdentifiedColumns, parent) {
    styleObjectTable(*this);
    refresh();
}

void IdentifiedTable::setRows(std::vector<IdentifiedRow> rows) {
    m_rows = std::move(rows);
    refresh();
}

void IdentifiedTable::refresh() {
    setAccessibleName(tr("Heat rates from the record"));
    setHorizontalHeaderLabels(
        {tr("Object"), tr("Identified"), tr("Controller"), tr("Material"), tr("At Start")});
    horizontalHeaderItem(kPart)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(kIdentified)
        ->setToolTip(tr("\u03bb\u2081 by least squares on the whole record, with its standard error"));
    horizontalHeaderItem(kController)->setToolTip(tr("\u03bb\u2081 that the controller believed at the end"));
    horizontalHeaderItem(kMaterial)->setToolTip(tr("\u03bb\u2081 of the experiment's material and source"));
    horizontalHeaderItem(kBegun)->setToolTip(tr("\u03bb\u2081 with which the controller began"));
    setRowCount(static_cast<int>(m_rows.size()));
    fitHeightToRows(*this);
    for (int row = 0; row < rowCount(); ++row) {
        const IdentifiedRow& value = m_rows[static_cast<std::size_t>(row)];
        const QString others = value.unusable.isEmpty()
                                   ? tr("\u03bb\u2082 = %1 1/(K\u00b3 s), \u03bb\u2083 = %2 K/s")
                                         .arg(withError(value.lambda2), withError(value.lambda3))
                                   : value.unusable;
        const QStringList texts{value.name,
                                value.unusable.isEmpty() ? withError(value.lambda1) : tr("not usable"),
                                number(value.controller), number(value.material), number(value.begun)};
        for (int column = 0; column < kIdentifiedColumns; ++column) {
            auto* item = objectCell(*this, row, column, texts[column]);
            if (column == kIdentified)
                item->setToolTip(others);
        }
    }
}

IdentifiedLosses::IdentifiedLosses(QWidget* parent) : QTableWidget(0, kLossColumns, parent) {
    styleObjectTable(*this);
    refresh();
}

void IdentifiedLosses::setRows(std::vector<IdentifiedRow> rows) {
    m_rows = std::move(rows);
    refresh();
}

void IdentifiedLosses::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    refresh();
}

void IdentifiedLosses::refresh() {
    setAccessibleName(tr("Losses from the record"));
    setHorizontalHeaderLabels({tr("Object"), tr("At"), tr("Loss, K/s"), QStringLiteral("h, W/(m\u00b2 K)")});
    horizontalHeaderItem(kLossPart)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(kWorking)->setToolTip(tr("Median temperature of the record's second half"));
    horizontalHeaderItem(kLoss)->setToolTip(
        tr("What radiation and air take together, less what the room gives, with its standard error"));
    horizontalHeaderItem(kConvection)
        ->setToolTip(tr("Convection of the air, from the curvature of the radiation's fourth power"));
    setRowCount(static_cast<int>(m_rows.size()));
    fitHeightToRows(*this);
    for (int row = 0; row < rowCount(); ++row) {
        const IdentifiedRow& value = m_rows[static_cast<std::size_t>(row)];
        const QStringList texts{value.name, formatTemperature(value.working_K, m_unit), withError(value.loss),
                                value.hUntold.isEmpty() ? withError(value.convection) : tr("not told")};
        for (int column = 0; column < kLossColumns; ++column) {
            auto* item = objectCell(*this, row, column, texts[column]);
            if (column == kLoss)
                item->setToolTip(
                    tr("Its change with the object's temperature: %1 1/s").arg(withError(value.lossSlope)));
            if (column == kConvection)
                item->setToolTip(value.hUntold);
        }
    }
}

void IdentifiedLosses::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QTableWidget::changeEvent(event);
}

void IdentifiedTable::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QTableWidget::changeEvent(event);
}

} // namespace bask
