#pragma once
// Ctrl+C, a log-out, a closed terminal: the window's program ends as after its own Quit, with a rig made
// safe.

#include <QObject>
#include <QSocketNotifier>

namespace bask {

/// Takes SIGINT, SIGTERM and SIGHUP while it lives, and ends the application's event loop for them without a
/// question. One at a time.
class EndSignals : public QObject {
public:
    EndSignals();
    ~EndSignals() override;

private:
    QSocketNotifier* m_notifier = nullptr;
};

} // namespace bask
