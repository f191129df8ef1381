#pragma once
// Parts that can be scrolled if the window is too small for them.

#include <QObject>

class QScrollArea;
class QWidget;

namespace bask {

/// Its content does not enlarge the window. Object name: "partScroll".
QScrollArea* scrolled(QWidget* content);

/// In the scroll areas of a window, a control that gets the keyboard focus is scrolled into view, and
/// scrolling by the wheel changes no value under the pointer.
class ScrollHabits : public QObject {
    Q_OBJECT

public:
    explicit ScrollHabits(QWidget* window);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(QWidget* focused);

    QWidget* m_window;
};

} // namespace bask
