#include "app/recovery_offer.h"

#include "app/autosave.h"
#include "app/error_text.h"
#include "app/session_actions.h"
#include "widgets/common/display.h"
#include "widgets/common/message_bar.h"

namespace bask {

RecoveryOffer::RecoveryOffer(MessageBar& bar, Document& document, Autosave& autosave, SessionActions& files,
                             QObject* parent)
    : QObject(parent), m_bar(bar), m_document(document), m_autosave(autosave), m_files(files) {
    connect(&m_bar, &MessageBar::actionClicked, this, &RecoveryOffer::recover);
    connect(&m_bar, &MessageBar::otherClicked, this, &RecoveryOffer::discard);
}

void RecoveryOffer::begin(const QString& folder) {
    m_left = UnsavedFile::left(folder);
    show();
}

void RecoveryOffer::retranslate() {
    if (!m_bar.isHidden()) // or it was put off
        show();
}

void RecoveryOffer::show() {
    if (m_left.empty())
        return m_bar.clear();
    const UnsavedFile& file = *m_left.front();
    m_bar.ask(tr("Bask ended before changes of “%1” were saved. They are kept as they were on %2.")
                  .arg(file.name(), formatDate(file.time())),
              tr("Recover"), tr("Discard"));
}

void RecoveryOffer::recover() {
    if (m_left.empty() || m_read.busy() || !m_files.mayReplace())
        return;
    m_read.run([file = m_left.front()] { return file->read(); },
               [this, since = m_document.generation()](const Result<UnsavedEdits>& read) {
                   if (!read)
                       return emit m_files.problem(sentence(read.error()));
                   if (m_files.refusedByRun() || // which may have begun while the file was read
                       m_files.refusedByEdits(since, m_left.front()->name()))
                       return;
                   m_autosave.adopt(m_left.front());
                   m_left.clear(); // the others at the next start
                   m_bar.clear();
                   m_document.openUnsaved(read->experiment, read->path);
               });
}

void RecoveryOffer::discard() {
    if (m_left.empty() || m_read.busy())
        return;
    m_left.front()->remove();
    m_left.erase(m_left.begin());
    show();
}

} // namespace bask
