#include "app/session_library.h"

#include "app/error_text.h"
#include "engine/base/message_code.h"
#include "engine/base/thread_priority.h"
#include "widgets/review/session_list.h"

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
}

SessionLibrary::~SessionLibrary() {
    *m_isOver = true;
    m_pool.waitForDone();
}

template <class Work, class Done> void SessionLibrary::run(Work work, Done done) {
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
            if (--m_listings == 0) // else a newer list is on its way
                m_list.setSessions(headers);
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
        now[path] = {std::move(stamp), headers.back(), isSame && before->second.isChecked};
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

void SessionLibrary::takeAlteration(const QString& path, const SessionVerdict& verdict) {
    take(path.toStdString(),
         [verdict](SessionHeader& header) { return !std::exchange(header.alteration, verdict); });
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
