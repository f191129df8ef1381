#pragma once
// The window's side of monitoring: its settings, their dialog, and how it goes.

#include "engine/monitor/monitor.h"

#include <QObject>
#include <QString>

class QWidget;

namespace bask {

class SessionActions;

class MonitorControl : public QObject {
    Q_OBJECT

public:
    /// The settings are read from, and kept in, this file.
    MonitorControl(const QString& file, SessionActions& files, QWidget* window);

    /// Takes the snapshots, on any thread.
    EngineWatch inlet() const { return m_monitor.inlet(); }
    /// Publishes as it was set up.
    void begin();
    void askSettings();

signals:
    /// Once a second while it is on, and once after.
    void stateTold(const bask::MonitorState& state);
    void problem(const QString& sentence);

private:
    void use(const MonitorSettings& settings);

    QString m_file;
    SessionActions& m_files;
    QWidget* m_window;
    MonitorSettings m_settings;
    Monitor m_monitor;
};

} // namespace bask
