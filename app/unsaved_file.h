#pragma once
// A file that keeps unsaved edits across a crash.

#include "engine/base/result.h"
#include "engine/model/experiment.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <vector>

namespace bask {

/// An experiment with edits that are not in its file.
struct UnsavedEdits {
    Experiment experiment;
    QString path; ///< path of its file; empty if it has none yet
    QString name; ///< name in the window
};

/// A line of JSON (format, version, pid, path, name), then the experiment as in its own file. The owning
/// process keeps a lock beside it, which ends with the process in whatever way. Any thread, one at a time.
class UnsavedFile {
public:
    /// A file of this process with a unique name; it is created with the first write.
    explicit UnsavedFile(const QString& folder);
    ~UnsavedFile(); ///< releases the lock; the file stays
    UnsavedFile(const UnsavedFile&) = delete;
    UnsavedFile& operator=(const UnsavedFile&) = delete;

    /// Returns the files of processes that have ended, the newest first; this process owns them from then on.
    static std::vector<std::shared_ptr<UnsavedFile>> left(const QString& folder);

    /// Writes all or nothing.
    Result<void> write(const UnsavedEdits& edits);
    Result<UnsavedEdits> read() const;
    void remove();

    QString name() const; ///< name of the experiment in it
    QDateTime time() const;

private:
    UnsavedFile(QString path, int lock) : m_path(std::move(path)), m_lock(lock) {}
    QString lockPath() const { return m_path + QStringLiteral(".lock"); }

    QString m_path;
    int m_lock = -1; ///< file descriptor
};

} // namespace bask
