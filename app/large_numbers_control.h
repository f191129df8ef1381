#pragma once
// The window's side of the large numbers: their window, made when it is first wanted, and where it was.

#include "app/settings_store.h"

#include <QObject>

#include <memory>

class QWidget;

namespace bask {

class LargeNumbers;
class RunPage;

/// Shows what the Run page shows, and closes with the main window. Closing it alone does nothing else.
class LargeNumbersControl : public QObject {
    Q_OBJECT

public:
    /// `run` must outlive this object.
    LargeNumbersControl(RunPage& run, QWidget* window);
    ~LargeNumbersControl() override;

    /// One that is minimised is not closed but shown: nobody sees that it is open.
    void setOpen(bool isOpen);
    void setAnswering(bool answering);

signals:
    void stopRequested();
    void openChanged(bool isOpen); ///< also when a person has closed the window

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void make();

    RunPage& m_run;
    QWidget* m_window;
    SettingsStore m_settings; ///< its own: the main window's is gone before this is
    std::unique_ptr<LargeNumbers> m_view;
    bool m_isAnswering = true;
};

} // namespace bask
