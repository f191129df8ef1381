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

enum IdentifiedColumn { kPart, kIdentified, kController, kMaterial, kIdentifiedColumns };

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
    setHorizontalHeaderLabels({tr("Object"), tr("Identified"), tr("Controller"), tr("Material")});
    horizontalHeaderItem(kPart)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeaderItem(kIdentified)
        ->setToolTip(tr("\u03bb\u2081 by least squares on the whole record, with its standard error"));
    horizontalHeaderItem(kController)->setToolTip(tr("\u03bb\u2081 that the controller believed at the end"));
    horizontalHeaderItem(kMaterial)->setToolTip(tr("\u03bb\u2081 of the experiment's material and source"));
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
                                number(value.controller), number(value.material)};
        for (int column = 0; column < kIdentifiedColumns; ++column) {
            auto* item = new QTableWidgetItem(texts[column]);
            item->setTextAlignment((column == kPart ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
            if (column == kPart)
                item->setIcon(QIcon(seriesSwatch(row, isDark(this), {20, 12}, devicePixelRatioF())));
            if (column == kIdentified)
                item->setToolTip(others);
            setItem(row, column, item);
        }
    }
}

void IdentifiedTable::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        refresh();
    QTableWidget::changeEvent(event);
}

} // namespace bask
