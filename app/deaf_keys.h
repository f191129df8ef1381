#pragma once
// The keys of actions that are not possible now: pressed, they are told instead of doing nothing.

#include <QObject>

class QAction;
class QWidget;

namespace bask {

class DeafKeys : public QObject {
    Q_OBJECT

public:
    explicit DeafKeys(QWidget* window);

    /// Hears the action's keys, also other ones later but no more of them, while it is disabled.
    void watch(QAction* action);

signals:
    void pressed(QAction* action);

private:
    QWidget* m_window;
};

} // namespace bask
