#pragma once
// The common style of the page's tables of objects.

#include <QTableWidget>

namespace bask {

/// Makes the columns as wide as their contents, with the first one (names) taking the rest; read-only.
void styleObjectTable(QTableWidget& table);

/// Makes the table as high as its rows, for one to six of them.
void fitHeightToRows(QTableWidget& table);

/// Copies the whole table to the clipboard, as tab-separated text with its header.
void copyTable(const QTableWidget& table);

} // namespace bask
