#include "app/cut_off_run.h"

#include "app/error_text.h"
#include "app/file_lock.h"
#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace bask {
namespace {

constexpr qint64 kLongestPath = 64 << 10;

} // namespace

CutOffRun::CutOffRun(MessageBar& bar, QString folder, QObject* parent)
    : QObject(parent), m_bar(bar), m_folder(std::move(folder)) {
    connect(&m_bar, &MessageBar::actionClicked, this, [this] {
        const QString session = QString::fromStdString(m_told.path);
        forget();
        emit openWanted(session);
    });
    connect(&m_bar, &MessageBar::closed, this, &CutOffRun::forget);
}

CutOffRun::~CutOffRun() {
    for (const Mark& mark : m_left)
        ::close(mark.lock);
    if (m_own.lock >= 0)
        ::close(m_own.lock);
}

void CutOffRun::remove(Mark& mark) {
    QFile::remove(mark.path);
    ::close(std::exchange(mark.lock, -1));
}

std::vector<CutOffRun::Mark> CutOffRun::left(const QString& folder) {
    std::vector<Mark> marks;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.run")}, QDir::Files, QDir::Time)) {
        Mark mark{dir.filePath(name), -1};
        mark.lock = openLocked(mark.path, 0);
        if (mark.lock >= 0 && QFile::exists(mark.path)) // its owner may have removed it meanwhile
            marks.push_back(mark);
        else if (mark.lock >= 0)
            ::close(mark.lock);
    }
    return marks;
}

void CutOffRun::begin() {
    m_left = left(m_folder);
    if (m_left.empty())
        return;
    std::vector<std::string> paths;
    for (const Mark& mark : m_left) {
        QFile file(mark.path);
        paths.push_back(file.open(QIODevice::ReadOnly) ? file.read(kLongestPath).toStdString() : "");
    }
    m_read.run(
        [paths] {
            std::vector<SessionHeader> headers(paths.size());
            for (std::size_t i = 0; i < paths.size(); ++i)
                if (!paths[i].empty()) // else nothing but that there was a run is known
                    headers[i] = readSessionHeader(paths[i]);
            return headers;
        },
        [this](const std::vector<SessionHeader>& headers) { take(headers); });
}

/// Of several that of a real rig, else the newest.
void CutOffRun::take(const std::vector<SessionHeader>& headers) {
    const SessionHeader* told = nullptr;
    std::vector<Mark> marks;
    for (std::size_t i = 0; i < headers.size(); ++i) {
        if (!headers[i].outcome.empty()) { // it has its end: the mark alone outlived its process
            remove(m_left[i]);
            continue;
        }
        marks.push_back(m_left[i]);
        if (told == nullptr || (told->simulated && !headers[i].simulated))
            told = &headers[i];
    }
    m_left = std::move(marks);
    if (told != nullptr) {
        m_told = *told;
        tell();
    }
}

void CutOffRun::tell() {
    const auto began =
        QDateTime::fromString(QString::fromStdString(m_told.created), Qt::ISODate).toLocalTime();
    const QString when =
        began.isValid() ? formatDate(began) : QFileInfo(QString::fromStdString(m_told.path)).fileName();
    const QString what =
        m_told.simulated
            ? tr("Bask ended in the middle of a simulated run (%1).").arg(when)
            : tr("Bask ended in the middle of a run (%1) and could not stop the rig: look at the "
                 "robot and the source before you go on.")
                  .arg(when.isEmpty() ? QStringLiteral("?") : when);
    if (m_told.path.empty())
        m_bar.say(MessageBar::Kind::Problem, what);
    else if (m_told.error)
        m_bar.say(MessageBar::Kind::Problem, what + u' ' + sentence(*m_told.error));
    else
        m_bar.say(MessageBar::Kind::Problem, what + u' ' + tr("What it had recorded is kept."),
                  tr("Show in Review"));
}

void CutOffRun::forget() {
    m_bar.clear();
    m_told = {};
    std::ranges::for_each(m_left, remove);
    m_left.clear();
}

/// A recorder that fails in a run names no recording any more: the run goes on all the same.
void CutOffRun::apply(const Snapshot& snapshot) {
    if (!isRunOn(snapshot.state))
        return end();
    if (m_own.lock >= 0 || snapshot.recordingPath.empty())
        return;
    QDir().mkpath(m_folder);
    m_own.path = QDir(m_folder).filePath(QStringLiteral("%1-%2.run")
                                             .arg(QCoreApplication::applicationPid())
                                             .arg(QDateTime::currentMSecsSinceEpoch()));
    m_own.lock = openLocked(m_own.path);
    QFile file;
    if (m_own.lock >= 0 && file.open(m_own.lock, QIODevice::WriteOnly))
        file.write(QByteArray::fromStdString(snapshot.recordingPath));
}

void CutOffRun::end() {
    if (m_own.lock >= 0)
        remove(m_own);
}

void CutOffRun::retranslate() {
    if (!m_bar.isHidden())
        tell();
}

} // namespace bask
