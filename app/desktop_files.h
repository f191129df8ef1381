#pragma once
// Files that were written, opened by the desktop's programs and shown in its file manager.

#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QThreadPool>

#include <functional>

class QUrl;

namespace bask {

/// Disk and file manager are asked on a thread of its own: neither may answer for long.
class DesktopFiles : public QObject {
    Q_OBJECT

public:
    using Opener = std::function<bool(const QUrl&)>;

    DesktopFiles();
    /// Opens by `opener` and asks the file manager at the D-Bus of an address; empty: that of the desktop.
    DesktopFiles(Opener opener, const QString& bus);

    /// Opens a file with the program of its kind; of several their folder.
    void open(const QStringList& files);
    /// Selects the files in the file manager; where none can do that, opens their folder.
    void showInFolder(const QStringList& files);

signals:
    void problem(const QString& sentence);

private:
    void openPath(const QString& path);

    Opener m_opener;
    QString m_bus;
    QThreadPool m_pool;
    LatestJob<bool> m_look{m_pool}, m_ask{m_pool};
};

} // namespace bask
