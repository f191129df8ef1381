#include "app/monitor_control.h"

#include "app/error_text.h"
#include "app/monitor_dialog.h"
#include "app/session_actions.h"

#include <QTimer>

namespace bask {

MonitorControl::MonitorControl(const QString& file, SessionActions& files, QWidget* window)
    : QObject(window), m_file(file), m_files(files), m_window(window) {
    auto* second = new QTimer(this);
    connect(second, &QTimer::timeout, this, [this] {
        if (m_settings.isOn())
            emit stateTold(m_monitor.state());
    });
    second->start(std::chrono::seconds(1));
}

void MonitorControl::begin() {
    const auto read = readMonitorSettings(m_file.toStdString());
    if (read)
        use(*read);
    else
        emit problem(tr("Monitoring is off: %1").arg(sentence(read.error())));
}

void MonitorControl::use(const MonitorSettings& settings) {
    m_settings = settings;
    m_monitor.use(settings);
    emit stateTold(m_monitor.state());
}

void MonitorControl::askSettings() {
    delete m_window->findChild<MonitorDialog*>();
    const auto ask = [this](const QString& title, bool isFolder) {
        FileQuestion question;
        question.kind = isFolder ? FileQuestion::Kind::Folder : FileQuestion::Kind::OpenFile;
        question.title = title;
        question.folder = m_files.lastFolder(FileFolder::Exports);
        question.place = FileFolder::Exports;
        return m_files.ask(question);
    };
    auto* dialog = new MonitorDialog(m_settings, ask, m_window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        use(dialog->settings());
        if (const auto kept = writeMonitorSettings(m_settings, m_file.toStdString()); !kept)
            emit problem(sentence(kept.error()));
    });
    dialog->show();
}

} // namespace bask
