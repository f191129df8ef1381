#pragma once
// The recorded runs of a folder, for the list on the Review page: read, tagged, closed, overlaid on another.

#include "engine/recording/recorded_session.h"
#include "engine/recording/session_header.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace bask {

class SessionList;

/// All file work is done on one thread, in the order of the requests, so that a written change is read next.
/// A header is read again only if its file has changed.
class SessionLibrary : public QObject {
    Q_OBJECT

public:
    /// Fills and serves the list, which must outlive it.
    explicit SessionLibrary(SessionList& list);
    ~SessionLibrary() override;

    void setFolder(const QString& folder);
    void refresh();
    /// Reads a run that is to be laid over the open one.
    void readOverlay(const QString& path);
    /// Lists the file that an error is about as damaged, if that is what the error says, in whichever folder
    /// and until it changes. Of many at once the list is read anew for the last.
    void takeDamage(const Error& error);
    /// Lists a file as damaged, altered or verified in the same way, by what was found of all its rows.
    void takeVerdict(const QString& path, const SessionVerdict& verdict);
    /// While something else is to be done, such as a run or the verification of the open one, listed runs are
    /// not verified. Otherwise they are, the newest first, long ones left out.
    void setPaused(bool isPaused);

signals:
    void problem(const QString& sentence);
    /// An interrupted recording is about to be closed: its readers must release it. It has its end now, or
    /// stays without one.
    void closing(const QString& path);
    void closed(const QString& path, bool isDone);
    void overlayRead(std::shared_ptr<bask::RecordedSession> session);

private:
    struct Known {
        std::string stamp; ///< sizes and times of file and log
        SessionHeader header;
        bool isChecked = false; ///< its structure was looked at
        bool isTried = false;   ///< and so was every row, whatever came of it
    };
    /// A listed run that was verified.
    struct Verified {
        std::string path; ///< empty: none is left
        bool isGood = false, isBad = false;
    };
    using Headers = std::map<std::string, Known>; ///< of the folder, and bad ones of others

    /// Puts what was found down for a file; returns whether it is new.
    using Finding = std::function<bool(SessionHeader& header)>;

    template <class Work, class Done> void run(Work work, Done done);
    template <class Work, class Done> void queue(Work work, Done done);
    void take(const std::string& where, Finding put);
    void verifyNext();
    static Verified verifyOne(Headers& known, const std::stop_token& stop);
    void writeTags(const QString& path, const QStringList& tags);
    void close(const QString& path);
    void check(const QString& path);
    static std::vector<SessionHeader> read(const std::string& folder, Headers& known,
                                           const std::atomic<bool>& isOver);

    SessionList& m_list;
    QString m_folder;
    int m_listings = 0;          ///< number of requested lists that are not answered yet
    int m_findings = 0;          ///< number of damaged and altered files that are not looked at yet
    bool m_isFindingNew = false; ///< one that was looked at is not listed as such yet
    std::shared_ptr<Headers> m_known = std::make_shared<Headers>(); ///< used by the pool's thread
    std::shared_ptr<std::atomic<int>> m_selections = std::make_shared<std::atomic<int>>(0); ///< until now
    std::shared_ptr<std::atomic<bool>> m_isOver = std::make_shared<std::atomic<bool>>(false);
    bool m_isPaused = false, m_isVerifying = false;
    std::stop_source m_stopVerifying; ///< other requests do not wait for a run that nobody asked for
    QTimer m_idle;
    QThreadPool m_pool;
};

} // namespace bask
