#pragma once
// Parts that can be scrolled if the window is too small for them.

#include <QElapsedTimer>
#include <QObject>

#include <chrono>

class QScrollArea;
class QWheelEvent;
class QWidget;

namespace bask {

/// A property of what the wheel zooms, such as a plot: in a part that can be scrolled up and down it zooms
/// with Ctrl, or once it has the keyboard; else the part is scrolled.
inline constexpr const char* kZoomsByWheel = "zoomsByWheel";

/// Its content does not enlarge the window. Object name: "partScroll".
QScrollArea* scrolled(QWidget* content);

/// In the scroll areas of a window, a control that gets the keyboard focus is scrolled into view, and
/// scrolling by the wheel changes no value under the pointer and zooms nothing that comes under it.
class ScrollHabits : public QObject {
    Q_OBJECT

public:
    /// Turns of the wheel that follow one another faster belong together: they go on with what they began.
    static constexpr std::chrono::milliseconds kGesture{400};

    explicit ScrollHabits(QWidget* window, std::chrono::milliseconds gesture = kGesture);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void show(QWidget* focused);
    bool isForWhatIsAround(QWidget* widget, const QWheelEvent& event);

    QWidget* m_window;
    const std::chrono::milliseconds m_gesture;
    QElapsedTimer m_sinceScroll; ///< since the last turn that was for a scroll area
};

} // namespace bask
