#include "app/deaf_keys.h"

#include <QAction>
#include <QShortcut>
#include <QWidget>

namespace bask {

DeafKeys::DeafKeys(QWidget* window) : QObject(window), m_window(window) {}

/// One key of two that are on would do nothing: the shortcut is on while that of the action is off.
void DeafKeys::watch(QAction* action) {
    for (const QKeySequence& keys : action->shortcuts()) {
        auto* shortcut = new QShortcut(keys, m_window);
        shortcut->setAutoRepeat(false);
        shortcut->setEnabled(!action->isEnabled());
        connect(action, &QAction::enabledChanged, shortcut,
                [shortcut](bool isEnabled) { shortcut->setEnabled(!isEnabled); });
        connect(shortcut, &QShortcut::activated, this, [this, action] { emit pressed(action); });
    }
}

} // namespace bask
