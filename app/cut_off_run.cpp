#include "app/cut_off_run.h"

#include "app/error_text.h"
#include "app/file_lock.h"
#include "widgets/common/message_bar.h"

#include <QDateTime>

#include <utility>

namespace bask {
namespace {

constexpr qint64 kLongestPath = 64 << 10;

bool isRun(RunState state) {
    return state == RunState::Running || state == RunState::Holding || state == RunState::Settled ||
           state == RunState::Stopping;
}

} // namespace

CutOffRun::CutOffRun(MessageBar& bar, QString markFile, QObject* parent)
    : QObject(parent), m_bar(bar), m_markFile(std::move(markFile)) {
    connect(&m_bar, &MessageBar::actionClicked, this, [this] {
        const QString session = QString::fromStdString(m_left.path);
        forget();
        emit openWanted(session);
    });
    connect(&m_bar, &MessageBar::closed, this, &CutOffRun::forget);
}

CutOffRun::~CutOffRun() {
    mark({});
}

void CutOffRun::begin() {
    QFile file(m_markFile);
    if (!file.exists())
        return;
    const int lock = openLocked(m_markFile);
    if (lock < 0) // the run of another Bask is on
        return;
    ::close(lock);
    if (!file.open(QIODevice::ReadOnly))
        return;
    const std::string path = file.read(kLongestPath).toStdString();
    if (path.empty())
        return;
    m_read.run([path] { return readSessionHeader(path); },
               [this](const SessionHeader& header) {
                   m_left = header;
                   if (header.outcome.empty()) // of one that has its end the mark alone outlived the process
                       tell();
               });
}

void CutOffRun::tell() {
    const auto began =
        QDateTime::fromString(QString::fromStdString(m_left.created), Qt::ISODate).toLocalTime();
    const QString when = began.isValid() ? began.toString(QStringLiteral("yyyy-MM-dd HH:mm"))
                                         : QString::fromStdString(m_left.path);
    const QString what =
        m_left.simulated
            ? tr("Bask ended in the middle of a simulated run (%1).").arg(when)
            : tr("Bask ended in the middle of a run (%1) and could not stop the rig: look at the "
                 "robot and the source before you go on.")
                  .arg(when);
    if (m_left.error)
        m_bar.say(MessageBar::Kind::Problem, what + u' ' + sentence(*m_left.error));
    else
        m_bar.say(MessageBar::Kind::Problem, what + u' ' + tr("What it had recorded is kept."),
                  tr("Show in Review"));
}

void CutOffRun::forget() {
    m_bar.clear();
    m_left = {};
    if (m_lock < 0) // else it is this process' run
        QFile::remove(m_markFile);
}

void CutOffRun::apply(const Snapshot& snapshot) {
    mark(isRun(snapshot.state) ? QString::fromStdString(snapshot.recordingPath) : QString());
}

void CutOffRun::mark(const QString& recording) {
    if (recording == m_recording)
        return;
    m_recording = recording;
    if (m_lock >= 0) {
        QFile::remove(m_markFile);
        ::close(std::exchange(m_lock, -1));
    }
    if (recording.isEmpty())
        return;
    m_lock = openLocked(m_markFile);
    QFile file;
    if (m_lock >= 0 && file.open(m_lock, QIODevice::WriteOnly)) {
        file.resize(0);
        file.write(recording.toUtf8());
    }
}

void CutOffRun::retranslate() {
    if (!m_bar.isHidden())
        tell();
}

} // namespace bask
