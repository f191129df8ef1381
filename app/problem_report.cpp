#include "app/problem_report.h"

#include "app/exact_version.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "widgets/common/device_words.h"

#include <QDateTime>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QSysInfo>
#include <QTextStream>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr std::size_t kMaxEvents = 200;

QString words(const Message& message) {
    return message.code == MessageCode::None ? QStringLiteral("-")
                                             : QString::fromStdString(describe(message));
}

void putProgram(QTextStream& out) {
    out << "Bask " << exactVersion() << ", Qt " << qVersion() << ", " << QSysInfo::prettyProductName() << ", "
        << QSysInfo::kernelType() << ' ' << QSysInfo::kernelVersion() << ", "
        << QSysInfo::currentCpuArchitecture() << '\n';
    out << "Window system " << QGuiApplication::platformName() << ", locale " << QLocale().name();
    for (const QScreen* screen : QGuiApplication::screens())
        out << ", screen " << screen->size().width() << " x " << screen->size().height() << " at "
            << screen->devicePixelRatio();
    out << "\nTaken " << QDateTime::currentDateTimeUtc().toString(Qt::ISODate) << "\n\n";
}

void putState(QTextStream& out, const Snapshot& snapshot) {
    out << "== Engine\n"
        << runStateName(snapshot.state) << (snapshot.simulated ? ", simulated" : ", LIVE") << ", "
        << snapshot.runTime_s << " s of run " << snapshot.runId << ", loop " << snapshot.loopRate_Hz
        << " Hz, late " << snapshot.lateSteps << ", heat " << (snapshot.heatOn ? "on" : "off") << '\n';
    for (const Message& reason : snapshot.reasons)
        out << "reason: " << words(reason) << '\n';
    for (const Alarm& alarm : snapshot.alarms)
        out << "alarm " << alarm.priority << (alarm.isActive ? ", active" : ", over")
            << (alarm.isAcknowledged ? ", seen" : ", new") << ", " << alarm.count
            << " x: " << words(alarm.message) << '\n';
    for (const RigDeviceState& device : snapshot.devices)
        out << roleName(device.role) << " at " << QString::fromStdString(device.port) << ": "
            << (device.status.link == LinkState::Live ? "live" : "not live") << ", \""
            << QString::fromStdString(device.status.identity) << "\", " << device.status.rate_Hz
            << " Hz, age " << device.age_s << " s, discarded " << device.status.discarded << ", "
            << words(device.status.problem) << ", last discarded: " << words(device.status.lastDiscarded)
            << '\n';
    out << '\n';
}

} // namespace

QString problemReport(const Snapshot& snapshot, const std::vector<TraceEvent>& events,
                      const Experiment& experiment) {
    QString text;
    QTextStream out(&text);
    putProgram(out);
    putState(out, snapshot);
    out << "== Events\n";
    const std::size_t from = events.size() > kMaxEvents ? events.size() - kMaxEvents : 0;
    for (std::size_t i = from; i < events.size(); ++i)
        out << events[i].time_s << " s: " << words(events[i].message) << '\n';
    out << "\n== Experiment\n" << QString::fromStdString(experimentToJson(experiment)) << '\n';
    return text;
}

ProblemDialog::ProblemDialog(const QString& report, QWidget* parent)
    : QDialog(parent), m_text(new QPlainTextEdit) {
    setObjectName(QStringLiteral("problemDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Report a problem"));
    auto* what = new QLabel(tr("This is all that the report has. Write at the top what happened and what you "
                               "expected, take out what nobody should see, save it, and give it to whoever "
                               "looks after your Bask. Nothing is sent."));
    what->setWordWrap(true);
    m_text->setObjectName(QStringLiteral("problemText"));
    m_text->setAccessibleName(tr("The report"));
    m_text->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    m_text->setLineWrapMode(QPlainTextEdit::NoWrap);
    m_text->setPlainText(tr("What happened:") + QStringLiteral("\n\n") + tr("What was expected:") +
                         QStringLiteral("\n\n") + report);
    m_text->setTabChangesFocus(true);
    auto* buttons = new QDialogButtonBox;
    QPushButton* save = buttons->addButton(tr("Save…"), QDialogButtonBox::ActionRole);
    QPushButton* shut = buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
    save->setObjectName(QStringLiteral("problemSave"));
    shut->setObjectName(QStringLiteral("problemClose"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(what);
    column->addWidget(m_text, 1);
    column->addWidget(buttons);
    connect(save, &QPushButton::clicked, this, [this] { emit saveWanted(m_text->toPlainText()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    resize(820, 640);
}

} // namespace bask
