#pragma once
// Mnemonics that two entries of one menu, or of the menu bar, have: Alt and the letter chooses neither.

#include <QAction>
#include <QKeySequence>
#include <QMap>
#include <QMenu>
#include <QStringList>

namespace bask::test {

/// Returns "Alt+S: &Save, Save &session" for each letter that is there twice, also in the menus under it.
inline QStringList mnemonicsTwice(const QList<QAction*>& entries) {
    QMap<QString, QStringList> byLetter;
    QStringList twice;
    for (const QAction* entry : entries) {
        if (const QKeySequence keys = QKeySequence::mnemonic(entry->text()); !keys.isEmpty())
            byLetter[keys.toString()] << entry->text();
        if (const QMenu* menu = entry->menu())
            twice << mnemonicsTwice(menu->actions());
    }
    for (auto it = byLetter.cbegin(); it != byLetter.cend(); ++it)
        if (it->size() > 1)
            twice << it.key() + QStringLiteral(": ") + it->join(QStringLiteral(", "));
    return twice;
}

} // namespace bask::test
