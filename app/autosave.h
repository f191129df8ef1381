#pragma once
// Keeps unsaved edits in a file, so that a crash loses only the last seconds.

#include "app/document.h"
#include "app/unsaved_file.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <memory>

namespace bask {

/// Follows the document: the file is written kDelay after an edit, and removed when everything is saved or
/// undone. Only the destructor waits for the disk.
class Autosave : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kDelay{2000};

    Autosave(Document& document, const QString& folder, QObject* parent = nullptr);
    /// Writes unsaved edits and keeps the file, since nobody was asked.
    ~Autosave() override;

    /// Call when the person has saved or given up all edits: removes the file, and writes no other.
    void end();
    /// Call before the edits of this file are opened; they are kept in this file from then on.
    void adopt(std::shared_ptr<UnsavedFile> file);

signals:
    /// The file cannot be written; sent once, until writing succeeds again.
    void failed(const bask::Error& error);

private:
    void follow();
    void write();

    Document& m_document;
    QString m_folder;
    std::shared_ptr<UnsavedFile> m_file; ///< used by the pool's thread only, and destroyed by its last owner
    QTimer m_timer;
    QThreadPool m_pool; ///< one thread, so that writing and removing stay in order
    std::atomic_bool m_failing = false;
    bool m_kept = false; ///< the file exists or is being written
    bool m_ended = false;
};

} // namespace bask
