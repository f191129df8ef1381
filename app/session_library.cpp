#include "app/session_library.h"

#include "app/error_text.h"
#include "engine/base/message_code.h"
#include "engine/base/thread_priority.h"
#include "engine/recording/session_store.h"
#include "widgets/review/session_list.h"
#include "widgets/review/verification_words.h"

#include <QDateTime>
#include <QFileInfo>
#include <QFuture>
#include <QtConcurrentRun>

#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

namespace bask {
namespace {

constexpr qint64 kMaxChecked_bytes = 64 << 20; // a third of a second; a longer run is read when it is opened
constexpr int kIdle_ms = 300;                  // between two runs that nobody asked for

/// Puts a verdict down; returns whether that is new.
bool put(const SessionVerdict& verdict, const std::string& where, SessionHeader& header) {
    if (verdict.isDamaged) {
        const bool isNew = !header.error && !header.damage;
        if (isNew)
            header.damage = Error(MessageCode::SessionDamaged, where, {kNotWhole});
        return isNew;
    }
    if (isAltered(verdict))
        return !std::exchange(header.alteration, verdict);
    return verdict.isIntact() && !std::exchange(header.isVerified, true);
}

/// Differs when a file or its log was written to.
std::string stampOf(const std::string& path) {
    std::string stamp;
    for (const char* suffix : {"", "-wal"}) {
        const QFileInfo file(QString::fromStdString(path) + QLatin1String(suffix));
        stamp += file.exists() ? std::to_string(file.size()) + '@' +
                                     std::to_string(file.lastModified().toMSecsSinceEpoch()) + ' '
                               : "- ";
    }
    return stamp;
}

} // namespace

SessionLibrary::SessionLibrary(SessionList& list) : m_list(list) {
    m_pool.setMaxThreadCount(1);
    connect(&m_list, &SessionList::tagsEdited, this, &SessionLibrary::writeTags);
    connect(&m_list, &SessionList::closeRequested, this, &SessionLibrary::close);
    connect(&m_list, &SessionList::compareRequested, this, &SessionLibrary::readOverlay);
    connect(&m_list, &SessionList::selectionChanged, this, &SessionLibrary::check);
    m_idle.setSingleShot(true);
    m_idle.setInterval(kIdle_ms);
    connect(&m_idle, &QTimer::timeout, this, &SessionLibrary::verifyNext);
}

SessionLibrary::~SessionLibrary() {
    *m_isOver = true;
    m_stopVerifying.request_stop();
    m_pool.waitForDone();
}

template <class Work, class Done> void SessionLibrary::run(Work work, Done done) {
    m_stopVerifying.request_stop();
    queue(std::move(work), std::move(done));
}

template <class Work, class Done> void SessionLibrary::queue(Work work, Done done) {
    const auto nicely = [work = std::move(work)] {
        giveWay();
        return work();
    };
    QtConcurrent::run(&m_pool, nicely).then(this, std::move(done));
}

void SessionLibrary::setFolder(const QString& folder) {
    m_folder = folder;
    m_list.setFolder(folder);
    refresh();
}

void SessionLibrary::refresh() {
    if (m_folder.isEmpty())
        return;
    ++m_listings;
    m_list.setReading();
    run([folder = m_folder.toStdString(), known = m_known,
         isOver = m_isOver] { return read(folder, *known, *isOver); },
        [this](const std::vector<SessionHeader>& headers) {
            if (--m_listings > 0) // a newer list is on its way
                return;
            m_list.setSessions(headers);
            m_idle.start();
        });
}

std::vector<SessionHeader> SessionLibrary::read(const std::string& folder, Headers& known,
                                                const std::atomic<bool>& isOver) {
    std::vector<SessionHeader> headers;
    Headers now;
    for (const std::string& path : sessionFiles(folder)) {
        if (isOver)
            return {};
        std::string stamp = stampOf(path);
        const auto before = known.find(path);
        const bool isSame = before != known.end() && before->second.stamp == stamp;
        headers.push_back(isSame ? before->second.header : readSessionHeader(path));
        now[path] = {std::move(stamp), headers.back(), isSame && before->second.isChecked,
                     isSame && before->second.isTried};
    }
    std::erase_if(
        known, [](const auto& each) { return !each.second.header.damage && !each.second.header.alteration; });
    now.merge(known); // the bad ones of other folders
    known = std::move(now);
    return headers;
}

void SessionLibrary::writeTags(const QString& path, const QStringList& tags) {
    std::vector<std::string> wanted;
    for (const QString& tag : tags)
        wanted.push_back(tag.toStdString());
    run([file = path.toStdString(), wanted] { return writeSessionTags(file, wanted); },
        [this](const Result<void>& written) {
            if (!written)
                emit problem(sentence(written.error()));
            refresh();
        });
}

void SessionLibrary::close(const QString& path) {
    emit closing(path);
    run([file = path.toStdString()] { return closeInterrupted(file); },
        [this, path](const Result<void>& done) {
            emit closed(path, done.ok());
            if (!done)
                emit problem(sentence(done.error()));
            refresh();
        });
}

void SessionLibrary::takeDamage(const Error& error) {
    if (error.code() != MessageCode::SessionDamaged)
        return;
    take(error.where, [error](SessionHeader& header) {
        const bool isNew = !header.error && !header.damage;
        if (isNew)
            header.damage = error;
        return isNew;
    });
}

void SessionLibrary::takeVerdict(const QString& path, const SessionVerdict& verdict) {
    take(path.toStdString(), [verdict, where = path.toStdString()](SessionHeader& header) {
        return put(verdict, where, header);
    });
}

void SessionLibrary::setPaused(bool isPaused) {
    if (isPaused == m_isPaused)
        return;
    m_isPaused = isPaused;
    if (isPaused)
        m_stopVerifying.request_stop();
    else
        m_idle.start();
}

/// One at a time, so that nothing waits for more.
void SessionLibrary::verifyNext() {
    if (m_isPaused || m_isVerifying || m_listings > 0 || m_findings > 0)
        return;
    m_isVerifying = true;
    m_stopVerifying = std::stop_source();
    queue([known = m_known, stop = m_stopVerifying.get_token()] { return verifyOne(*known, stop); },
          [this](const Verified& verified) {
              m_isVerifying = false;
              if (verified.isGood)
                  m_list.setVerified(verified.path);
              if (verified.isBad)
                  refresh();
              else if (!verified.path.empty())
                  m_idle.start();
          });
}

/// One that is being recorded has no outcome, whoever records it.
SessionLibrary::Verified SessionLibrary::verifyOne(Headers& known, const std::stop_token& stop) {
    auto next = known.end();
    for (auto each = known.begin(); each != known.end(); ++each) {
        const SessionHeader& header = each->second.header;
        const bool isSettled = each->second.isTried || header.error || header.damage || header.alteration ||
                               header.isVerified || header.outcome.empty();
        if (!isSettled && (next == known.end() || header.created > next->second.header.created) &&
            QFileInfo(QString::fromStdString(each->first)).size() <= kMaxChecked_bytes)
            next = each;
    }
    if (next == known.end())
        return {};
    Verified out{next->first};
    const auto verdict = verifyOpenSession(next->first, stop);
    Known& file = next->second;
    if (stop.stop_requested() || stampOf(next->first) != file.stamp)
        return out; // another time
    file.isTried = true;
    if (!verdict)
        return out;
    out.isBad = put(*verdict, next->first, file.header) && !file.header.isVerified;
    out.isGood = file.header.isVerified;
    return out;
}

void SessionLibrary::take(const std::string& where, Finding put) {
    ++m_findings;
    run(
        [where, put = std::move(put), known = m_known] {
            std::set<std::string> paths{where};
            std::error_code failed;
            for (const auto& [path, listed] : *known)
                if (std::filesystem::equivalent(path, where, failed)) // opened through a link, too
                    paths.insert(path);
            bool isNew = false;
            for (const std::string& path : paths) {
                Known& file = (*known)[path];
                if (std::string stamp = stampOf(path); file.stamp != stamp) {
                    file = {std::move(stamp), readSessionHeader(path)};
                    isNew = true;
                }
                file.isChecked = true;
                isNew = put(file.header) || isNew;
            }
            return isNew;
        },
        [this](bool isNew) {
            m_isFindingNew = m_isFindingNew || isNew;
            if (--m_findings == 0 && std::exchange(m_isFindingNew, false)) // else more is looked at
                refresh();
        });
}

/// The outcome of a run can be read where its samples cannot. One that is no longer selected is passed over.
void SessionLibrary::check(const QString& path) {
    run(
        [path, known = m_known, number = ++*m_selections, last = m_selections]() -> Result<void> {
            const auto found = known->find(path.toStdString());
            if (number != *last || found == known->end() || found->second.header.outcome.empty() ||
                QFileInfo(path).size() > kMaxChecked_bytes || std::exchange(found->second.isChecked, true))
                return {};
            return checkSession(path.toStdString());
        },
        [this](const Result<void>& checked) {
            if (!checked)
                takeDamage(checked.error());
        });
}

void SessionLibrary::readOverlay(const QString& path) {
    run([file = path.toStdString()] { return RecordedSession::open(file); },
        [this](const Result<std::shared_ptr<RecordedSession>>& session) {
            if (!session)
                emit problem(sentence(session.error()));
            else
                emit overlayRead(*session);
        });
}

} // namespace bask
