#include "app/autosave.h"

#include <utility>

namespace bask {

Autosave::Autosave(Document& document, const QString& folder, QObject* parent)
    : QObject(parent), m_document(document), m_folder(folder), m_file(std::make_shared<UnsavedFile>(folder)) {
    m_pool.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelay);
    connect(&m_timer, &QTimer::timeout, this, [this] {
        if (m_pool.activeThreadCount() > 0)
            m_timer.start(); // a slow disk gets the newest state, not each
        else
            write();
    });
    connect(&m_document, &Document::changed, this, &Autosave::follow);
}

Autosave::~Autosave() {
    if (!m_ended && m_timer.isActive())
        write();
    m_pool.waitForDone();
}

void Autosave::follow() {
    if (m_ended)
        return;
    if (m_document.modified()) {
        if (!m_timer.isActive())
            m_timer.start();
        return;
    }
    m_timer.stop();
    if (!std::exchange(m_kept, false))
        return;
    m_pool.start([file = m_file] { file->remove(); });
}

void Autosave::write() {
    m_kept = true;
    m_pool.start(
        [this, file = m_file,
         edits = UnsavedEdits{m_document.experiment(), m_document.path(), m_document.displayName()}] {
            const auto written = file->write(edits);
            if (!written && !m_failing)
                emit failed(written.error()); // queued to the window's thread
            m_failing = !written;
        });
}

void Autosave::end() {
    m_ended = true;
    m_timer.stop();
    m_pool.waitForDone();
    m_file->remove();
}

void Autosave::adopt(std::shared_ptr<UnsavedFile> file) {
    if (std::exchange(m_kept, true))
        m_pool.start([before = m_file] { before->remove(); });
    m_file = std::move(file);
}

} // namespace bask
