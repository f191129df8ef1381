#include "app/monitor_dialog.h"

#include "app/error_text.h"
#include "engine/monitor/monitor.h"
#include "widgets/common/dialog_frame.h"
#include "widgets/common/display.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPromise>
#include <QPushButton>
#include <QVBoxLayout>

#include <thread>
#include <utility>

namespace bask {
namespace {

constexpr int kMonitorFieldWidth = 320;

std::string textOf(const QLineEdit* field) {
    return field->text().trimmed().toStdString();
}

} // namespace

MonitorDialog::MonitorDialog(const MonitorSettings& settings, Ask ask, QWidget* parent)
    : QDialog(parent), m_ask(std::move(ask)), m_broker(new QGroupBox(tr("Publish to an MQTT broker"), this)),
      m_files(new QGroupBox(tr("Write status files"), this)), m_answer(new QLabel(this)),
      m_clear(new QLabel(this)) {
    setObjectName(QStringLiteral("monitorDialog"));
    setWindowTitle(tr("Monitoring"));
    setAttribute(Qt::WA_DeleteOnClose);

    const BrokerSettings& broker = settings.broker;
    m_address = field("brokerAddress", broker.address);
    m_address->setPlaceholderText(QStringLiteral("mqtt.example.org:8883"));
    m_tls = new QCheckBox(tr("Encrypted (TLS)"), this);
    m_tls->setObjectName(QStringLiteral("brokerTls"));
    m_tls->setChecked(broker.usesTls);
    m_ca = field("brokerCa", broker.caFile);
    m_ca->setPlaceholderText(tr("those of the system"));
    m_user = field("brokerUser", broker.user);
    m_password = field("brokerPasswordFile", broker.passwordFile);
    m_password->setToolTip(tr("Its first line is the password; nobody else may read the file."));
    m_topic = field("brokerTopic", broker.topic);
    m_topic->setToolTip(
        tr("In front of all topics, with a slash: lab2/bask becomes lab2/bask/status and so on."));
    m_folder = field("statusFolder", settings.statusFolder);

    m_broker->setObjectName(QStringLiteral("monitorBroker"));
    m_broker->setCheckable(true);
    m_broker->setChecked(settings.usesBroker);
    auto* form = new QFormLayout(m_broker);
    form->addRow(tr("Address"), m_address);
    form->addRow(QString(), m_tls);
    form->addRow(tr("Trusted certificates"), withBrowse(m_ca, tr("Trusted certificates"), false));
    form->addRow(tr("User"), m_user);
    form->addRow(tr("File with the password"), withBrowse(m_password, tr("File with the password"), false));
    m_clear->setObjectName(QStringLiteral("clearPassword"));
    m_clear->setText(tr("Without TLS the password goes over the network in clear text."));
    m_clear->setWordWrap(true);
    form->addRow(QString(), m_clear);
    form->addRow(tr("Topic"), m_topic);
    m_files->setObjectName(QStringLiteral("monitorFiles"));
    m_files->setCheckable(true);
    m_files->setChecked(settings.usesFiles);
    auto* files = new QFormLayout(m_files);
    files->addRow(tr("Folder"), withBrowse(m_folder, tr("Folder of the status files"), true));

    auto* meaning =
        new QLabel(tr("Bask publishes only: nobody can give it an order this way, and it opens no port. "
                      "The setting belongs to this computer; no experiment can switch it on."),
                   this);
    meaning->setWordWrap(true);
    m_answer->setObjectName(QStringLiteral("monitorAnswer"));
    m_answer->setWordWrap(true);

    QVBoxLayout* column = dialogColumn(*this);
    column->addWidget(m_broker);
    column->addWidget(m_files);
    column->addWidget(meaning);
    column->addWidget(m_answer);
    const DialogButtons buttons = addDialogButtons(*this, tr("OK"));
    m_take = buttons.take;
    m_take->setObjectName(QStringLiteral("takeMonitor"));
    m_try = buttons.box->addButton(tr("Test"), QDialogButtonBox::ActionRole);
    m_try->setObjectName(QStringLiteral("tryMonitor"));
    connect(m_try, &QPushButton::clicked, this, &MonitorDialog::test);
    connect(&m_test, &QFutureWatcherBase::finished, this, &MonitorDialog::showAnswer);
    for (QGroupBox* group : {m_broker, m_files})
        connect(group, &QGroupBox::toggled, this, &MonitorDialog::check);
    for (QLineEdit* each : {m_address, m_ca, m_user, m_password, m_topic, m_folder})
        connect(each, &QLineEdit::textChanged, this, &MonitorDialog::check);
    connect(m_tls, &QCheckBox::toggled, this, &MonitorDialog::check);
    check();
}

QLineEdit* MonitorDialog::field(const char* name, const std::string& text) {
    auto* made = new QLineEdit(QString::fromStdString(text), this);
    made->setObjectName(QLatin1String(name));
    made->setMinimumWidth(kMonitorFieldWidth);
    return made;
}

QWidget* MonitorDialog::withBrowse(QLineEdit* field, const QString& title, bool isFolder) {
    auto* both = new QWidget(this);
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* browse = new QPushButton(tr("Choose\u2026"), both);
    browse->setAutoDefault(false);
    browse->setAccessibleName(title);
    field->setAccessibleName(title); // the row's caption belongs to both together
    row->addWidget(field, 1);
    row->addWidget(browse);
    connect(browse, &QPushButton::clicked, this, [this, field, title, isFolder] {
        if (const QString chosen = m_ask(title, isFolder); !chosen.isEmpty())
            field->setText(chosen);
    });
    return both;
}

MonitorSettings MonitorDialog::settings() const {
    MonitorSettings out;
    out.usesBroker = m_broker->isChecked();
    out.broker = {textOf(m_address), m_tls->isChecked(), textOf(m_ca),
                  textOf(m_user),    textOf(m_password), textOf(m_topic)};
    out.usesFiles = m_files->isChecked();
    out.statusFolder = textOf(m_folder);
    return out;
}

/// What is ticked and empty is not set up, and is said by the field alone.
void MonitorDialog::check() {
    const MonitorSettings now = settings();
    const bool isWhole =
        (!now.usesBroker || !now.broker.address.empty()) && (!now.usesFiles || !now.statusFolder.empty());
    const auto valid = validate(now);
    m_try->setEnabled(isWhole && valid.ok() && now.isOn() && !m_test.isRunning());
    m_take->setEnabled(isWhole && valid.ok());
    m_clear->setVisible(!now.broker.passwordFile.empty() && !now.broker.usesTls);
    say(valid || !isWhole ? QString() : asSentence(sentence(valid.error().message)));
}

void MonitorDialog::test() {
    say(tr("Trying\u2026"));
    m_tried = settings();
    // On a thread that nobody waits for, also not the program's end: network and disk may hang.
    const auto promise = std::make_shared<QPromise<std::shared_ptr<Result<void>>>>();
    m_test.setFuture(promise->future());
    promise->start();
    m_try->setEnabled(false);
    std::thread([promise, tried = m_tried] {
        promise->addResult(std::make_shared<Result<void>>(tryMonitor(tried)));
        promise->finish();
    }).detach();
}

/// Not of what has been changed since.
void MonitorDialog::showAnswer() {
    check();
    if (settings() != m_tried)
        return;
    const Result<void> done = *m_test.result();
    say(done ? tr("It works: everything that is ticked has taken a message.")
             : asSentence(sentence(done.error())));
}

void MonitorDialog::say(const QString& text) {
    m_answer->setText(text);
    m_answer->setVisible(!text.isEmpty());
}

} // namespace bask
