#pragma once
// The place of a plot in its page, out of which a person can take it into a window of its own.

#include <QWidget>

#include <memory>

class QAction;
class QLabel;
class QMenu;
class QPushButton;
class QVBoxLayout;

namespace bask {

/// What the shown part of a plot can be written to.
enum class PlotForm { Pdf, Svg, Png, Csv };

class PlotWindow;
class TracePlot;

/// Holds a plot, whose menu (right click, menu key) and key W take it out and put it back; closing its window
/// puts it back, too. M measures from the cursor. It is the same plot in either: with its data, cursor and
/// stretch of time. Meanwhile the place says where it is. The menu also chooses a second quantity for the
/// right axis, and exports what is shown. Object names: "plotOwnWindow", "plotMeasure" and "plotCursorAway"
/// in its menu "plotMenu", "plotRight." and the key of a quantity or "none" in that menu's "plotRightMenu",
/// "plotExport.pdf" and so on in its "plotExportMenu"; "plotPutBack".
class PlotPlace : public QWidget {
    Q_OBJECT
public:
    explicit PlotPlace(TracePlot* plot, QWidget* parent = nullptr); ///< owns the plot
    ~PlotPlace() override;

    TracePlot* plot() const { return m_plot; }
    bool isOut() const { return m_plotWindow != nullptr; }
    void takeOut();
    void putBack();

    /// For the window's title: which run the plot shows, and the rig with its state now.
    void setRun(const QString& words);
    void setState(const QString& words);
    /// Returns these words, the rig's state first.
    QString words() const;

    /// Adds an action for each form that the plot can be exported to.
    void addExports(QMenu& menu);

signals:
    void exportRequested(bask::PlotForm form);
    /// The window is made and not shown yet.
    void takenOut(bask::PlotWindow* window);

protected:
    void changeEvent(QEvent* event) override;

private:
    void openMenu(const QPoint& at);
    void addRightMenu(QMenu& menu);
    void takeBack();
    void showTitle();
    void retranslate();

    TracePlot* m_plot;
    QVBoxLayout* m_layout;
    QWidget* m_note; ///< in the plot's place while it is out
    QLabel* m_noteText;
    QPushButton* m_putBack;
    QAction* m_ownWindow;
    QString m_run, m_state;
    std::unique_ptr<PlotWindow> m_plotWindow; ///< null while the plot is here
};

} // namespace bask
