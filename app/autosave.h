#pragma once
// Keeps what is edited and not saved in a file, so that a crash loses the last seconds at most.

#include "app/document.h"
#include "app/unsaved_file.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <chrono>
#include <memory>

namespace bask {

/// Follows the document: written kDelay after an edit, removed when all is saved or undone. The disk is not
/// waited for but at the end.
class Autosave : public QObject {
    Q_OBJECT

public:
    static constexpr std::chrono::milliseconds kDelay{2000};

    Autosave(Document& document, const QString& folder, QObject* parent = nullptr);
    /// What is not saved then is written and stays: nobody was asked.
    ~Autosave() override;

    /// The person has saved or given up what there was: removes the file, and writes no other.
    void end();
    /// What was unsaved in this file is opened next; it is kept there from now on.
    void adopt(std::shared_ptr<UnsavedFile> file);

signals:
    /// Once, until it can be written again.
    void failed(const bask::Error& error);

private:
    void follow();
    void write();

    Document& m_document;
    QString m_folder;
    std::shared_ptr<UnsavedFile> m_file; ///< used in the pool only, but by the last of its owners
    QTimer m_timer;
    QThreadPool m_pool; ///< one thread: writing and removing in their order
    std::atomic_bool m_failing = false;
    bool m_kept = false; ///< the file is there, or on its way
    bool m_ended = false;
};

} // namespace bask
