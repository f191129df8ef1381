#pragma once
// A file that keeps unsaved edits over a crash.

#include "engine/base/result.h"
#include "engine/model/experiment.h"

#include <QDateTime>
#include <QString>

#include <memory>
#include <vector>

namespace bask {

/// An experiment with what its file does not have.
struct UnsavedEdits {
    Experiment experiment;
    QString path; ///< of its file; empty: it has none yet
    QString name; ///< as the window calls it
};

/// A line of JSON (format, version, pid, path, name), then the experiment as in its own file. A lock beside
/// it is held by the process that owns it and ends with it, however it ends. Any thread, one at a time.
class UnsavedFile {
public:
    /// Of this process, under a name of its own; made with the first write.
    explicit UnsavedFile(const QString& folder);
    ~UnsavedFile(); ///< lets the lock go; the file stays
    UnsavedFile(const UnsavedFile&) = delete;
    UnsavedFile& operator=(const UnsavedFile&) = delete;

    /// Those of processes that are gone, newest first; they are this one's from now on.
    static std::vector<std::shared_ptr<UnsavedFile>> left(const QString& folder);

    /// Whole or not at all.
    Result<void> write(const UnsavedEdits& edits);
    Result<UnsavedEdits> read() const;
    void remove();

    QString name() const; ///< of what is in it
    QDateTime time() const;

private:
    UnsavedFile(QString path, int lock) : m_path(std::move(path)), m_lock(lock) {}
    QString lockPath() const { return m_path + QStringLiteral(".lock"); }

    QString m_path;
    int m_lock = -1; ///< file descriptor
};

} // namespace bask
