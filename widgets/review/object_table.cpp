#include "widgets/review/object_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QScrollBar>

#include <algorithm>

namespace bask {

void styleObjectTable(QTableWidget& table) {
    table.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setShowGrid(false);
    table.setWordWrap(false);
    table.setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    table.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    table.setTabKeyNavigation(false);
    QHeaderView& rows = *table.verticalHeader();
    rows.hide();
    rows.setSectionResizeMode(QHeaderView::Fixed);
    rows.setDefaultSectionSize(table.fontMetrics().height() + 12);
    QHeaderView& columns = *table.horizontalHeader();
    columns.setSectionResizeMode(QHeaderView::ResizeToContents);
    columns.setSectionResizeMode(0, QHeaderView::Stretch);
    columns.setMinimumSectionSize(70);
    columns.setDefaultAlignment(Qt::AlignRight | Qt::AlignVCenter);
    columns.setHighlightSections(false);
}

void copyTable(const QTableWidget& table) {
    const bool hasNames = !table.verticalHeader()->isHidden();
    QStringList lines, header(hasNames ? 1 : 0);
    for (int column = 0; column < table.columnCount(); ++column)
        if (!table.isColumnHidden(column))
            header << table.horizontalHeaderItem(column)->text();
    lines << header.join(u'\t');
    for (int row = 0; row < table.rowCount(); ++row) {
        QStringList cells;
        if (hasNames)
            cells << table.verticalHeaderItem(row)->text();
        for (int column = 0; column < table.columnCount(); ++column) {
            if (table.isColumnHidden(column))
                continue;
            const QTableWidgetItem* item = table.item(row, column);
            cells << (item != nullptr ? item->text() : QString());
        }
        lines << cells.join(u'\t');
    }
    QApplication::clipboard()->setText(lines.join(u'\n'));
}

void fitHeightToRows(QTableWidget& table) {
    const int rows = std::clamp(table.rowCount(), 1, 6);
    table.setFixedHeight(table.horizontalHeader()->sizeHint().height() +
                         rows * table.verticalHeader()->defaultSectionSize() + 2 * table.frameWidth() +
                         table.horizontalScrollBar()->sizeHint().height());
}

} // namespace bask
