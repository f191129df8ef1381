#pragma once
// Offers unsaved edits of an earlier Bask, in the bar above the pages, never as a dialog.

#include "app/unsaved_file.h"
#include "widgets/common/latest_job.h"

#include <QObject>

#include <memory>
#include <vector>

namespace bask {

class Autosave;
class Document;
class MessageBar;
class SessionActions;

/// Offers one at a time, the newest first: it is recovered as unsaved edits of its file, or discarded. What
/// is postponed is offered again at the next start.
class RecoveryOffer : public QObject {
    Q_OBJECT

public:
    /// Errors are reported as problems of `files`.
    RecoveryOffer(MessageBar& bar, Document& document, Autosave& autosave, SessionActions& files,
                  QObject* parent = nullptr);

    void begin(const QString& folder);
    void retranslate();

private:
    void show();
    void recover();
    void discard();

    MessageBar& m_bar;
    Document& m_document;
    Autosave& m_autosave;
    SessionActions& m_files;
    std::vector<std::shared_ptr<UnsavedFile>> m_left;
    LatestJob<Result<UnsavedEdits>> m_read;
};

} // namespace bask
