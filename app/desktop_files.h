#pragma once
// Files that were written, and addresses, opened by the desktop's programs; files shown in its file manager.

#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>

#include <functional>
#include <utility>

class QUrl;

namespace bask {

/// Disks and file manager are asked on a thread of its own: neither may answer for long.
class DesktopFiles : public QObject {
    Q_OBJECT

public:
    using Opener = std::function<bool(const QUrl&)>;

    /// Asks the file manager at the D-Bus of an address; empty: that of the desktop.
    explicit DesktopFiles(const QString& bus = {});

    /// Replaces what opens a file or an address, for tests; it is called on that thread.
    void setOpener(Opener opener) { m_opener = std::move(opener); }
    void openAddress(const QUrl& address);
    /// Opens a file with the program of its kind; of several their folder.
    void open(const QStringList& files);
    /// Selects the files in the file manager; where none can do that, opens their folder.
    void showInFolder(const QStringList& files);

signals:
    void problem(const QString& sentence);

private:
    enum class Opening { Begun, NotThere, NoProgram };
    void openPath(const QString& path);
    void tell(Opening opening, const QString& what);

    Opener m_opener;
    QString m_bus;
    QThreadPool m_pool;
    LatestJob<Opening> m_open{m_pool};
    LatestJob<bool> m_ask{m_pool};
};

} // namespace bask
