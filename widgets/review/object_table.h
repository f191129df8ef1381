#pragma once
// The look that the page's tables of objects share.

#include <QTableWidget>

namespace bask {

/// Columns as wide as their contents, the first one (names) taking the rest; nothing to edit.
void styleObjectTable(QTableWidget& table);

/// As high as its rows, one to six of them.
void fitHeightToRows(QTableWidget& table);

/// The whole table onto the clipboard, as tab-separated text with its header.
void copyTable(const QTableWidget& table);

} // namespace bask
