#pragma once
// Parts that are scrolled where the window has not the room they need.

#include <QObject>

class QScrollArea;
class QWidget;

namespace bask {

/// What it holds does not make its window larger. Object name: "partScroll".
QScrollArea* scrolled(QWidget* content);

/// In the scroll areas of one window, what gets the keyboard comes into view, and a wheel that scrolls
/// changes no value it happens to pass over.
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
