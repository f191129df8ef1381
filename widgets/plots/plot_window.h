#pragma once
// The window of a plot that was taken out of its page, as for a second screen.

#include <QWidget>

namespace bask {

class ElidedLabel;
class TracePlot;

/// Made by PlotPlace, without a parent: a child would stay above the main window, and be minimised with it.
/// F11 makes it fill the screen, F11 or Esc ends that; then its title stands over the plot. Else Esc closes
/// it. Object name "plotWindow." and the name of the plot; the title over the plot "plotWindowTitle".
class PlotWindow : public QWidget {
    Q_OBJECT
public:
    explicit PlotWindow(TracePlot& plot);

    void setTitle(const QString& title);

signals:
    /// The plot is to go back to its place now, before this window is gone.
    void closed();

protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    ElidedLabel* m_title;
};

} // namespace bask
