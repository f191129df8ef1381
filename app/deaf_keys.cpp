#include "app/deaf_keys.h"

#include <QAction>
#include <QShortcut>
#include <QWidget>

namespace bask {

DeafKeys::DeafKeys(QWidget* window) : QObject(window), m_window(window) {}

/// One key of two that are on would do nothing: the shortcut is on while that of the action is off.
void DeafKeys::watch(QAction* action) {
    const QList<QKeySequence> all = action->shortcuts();
    for (qsizetype i = 0; i < all.size(); ++i) {
        auto* shortcut = new QShortcut(all[i], m_window);
        shortcut->setAutoRepeat(false);
        shortcut->setEnabled(!action->isEnabled());
        connect(action, &QAction::enabledChanged, shortcut,
                [shortcut](bool isEnabled) { shortcut->setEnabled(!isEnabled); });
        connect(action, &QAction::changed, shortcut, [shortcut, action, i] {
            if (const QKeySequence keys = action->shortcuts().value(i); keys != shortcut->key())
                shortcut->setKey(keys);
        });
        connect(shortcut, &QShortcut::activated, this, [this, action] { emit pressed(action); });
    }
}

} // namespace bask
