#pragma once
// The program's side of plots in windows of their own: their places on the screens, the state in their
// titles.

#include "app/settings_store.h"
#include "engine/runtime/snapshot.h"

#include <QList>
#include <QObject>

class QWidget;

namespace bask {

class PlotPlace;

/// They close with the main window: then the plots are back in their pages.
class PlotWindowsControl : public QObject {
    Q_OBJECT

public:
    /// For the plots that `window` has now.
    explicit PlotWindowsControl(QWidget* window);

    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void tell();

    QWidget* m_window;
    SettingsStore m_settings; ///< its own: the main window's is gone before this is
    QList<PlotPlace*> m_places;
    bool m_isTold = false; ///< a snapshot has come
    bool m_isAnswering = true;
    bool m_isSimulated = true;
    RunState m_state = RunState::Idle;
};

} // namespace bask
