#pragma once
// Sets up where a run can be watched from elsewhere, and tries it.

#include "engine/monitor/monitor_settings.h"
#include <QDialog>
#include <QFutureWatcher>

#include <functional>
#include <memory>

class QCheckBox;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace bask {

/// Not modal, so that STOP stays reachable. Object names: "monitorDialog", "monitorBroker" (group with a
/// tick), "brokerAddress", "brokerTls", "brokerCa", "brokerUser", "brokerPasswordFile", "brokerTopic",
/// "monitorFiles" (group with a tick), "statusFolder", "tryMonitor", "monitorAnswer", "takeMonitor".
class MonitorDialog : public QDialog {
    Q_OBJECT

public:
    /// `ask` returns a chosen file, or folder; empty if cancelled.
    using Ask = std::function<QString(const QString& title, bool isFolder)>;
    MonitorDialog(const MonitorSettings& settings, Ask ask, QWidget* parent);

    MonitorSettings settings() const;

private:
    QLineEdit* field(const char* name, const std::string& text);
    QWidget* withBrowse(QLineEdit* field, const QString& title, bool isFolder);
    void check();
    void test();
    void showAnswer();
    void say(const QString& text);

    Ask m_ask;
    QGroupBox *m_broker, *m_files;
    QLineEdit *m_address, *m_ca, *m_user, *m_password, *m_topic, *m_folder;
    QCheckBox* m_tls;
    QLabel* m_answer;
    QPushButton *m_try, *m_take;
    QLabel* m_clear;
    MonitorSettings m_tried;
    QFutureWatcher<std::shared_ptr<Result<void>>> m_test;
};

} // namespace bask
