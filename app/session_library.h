#pragma once
// The recorded runs of a folder, for the list on the Review page: read, tagged, closed, laid over another.

#include "engine/recording/recorded_session.h"
#include "engine/recording/session_header.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace bask {

class SessionList;

/// All work on files is done on one thread, in the order in which it was asked for: what is written is what
/// is read next. A header is read again only when its file has changed.
class SessionLibrary : public QObject {
    Q_OBJECT

public:
    /// Fills and serves the list, which outlives it.
    explicit SessionLibrary(SessionList& list);
    ~SessionLibrary() override;

    void setFolder(const QString& folder);
    void refresh();

signals:
    void problem(const QString& sentence);
    /// An interrupted recording is to be given its end: who reads it lets it go. It has it now, or keeps
    /// none.
    void closing(const QString& path);
    void closed(const QString& path, bool isDone);
    void overlayRead(std::shared_ptr<bask::RecordedSession> session);

private:
    struct Known {
        std::string stamp; ///< of file and log
        SessionHeader header;
    };
    using Headers = std::map<std::string, Known>;

    template <class Work, class Done> void run(Work work, Done done);
    void writeTags(const QString& path, const QStringList& tags);
    void close(const QString& path);
    void readOverlay(const QString& path);
    static std::vector<SessionHeader> read(const std::string& folder, Headers& known,
                                           const std::atomic<bool>& isOver);

    SessionList& m_list;
    QString m_folder;
    int m_listings = 0;                                             ///< asked for and not answered yet
    std::shared_ptr<Headers> m_known = std::make_shared<Headers>(); ///< the pool's
    std::shared_ptr<std::atomic<bool>> m_isOver = std::make_shared<std::atomic<bool>>(false);
    QThreadPool m_pool;
};

} // namespace bask
