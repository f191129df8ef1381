#pragma once
// Tells at the start that the program ended in the middle of its last run: nobody has stopped the rig then.

#include "engine/runtime/snapshot.h"
#include "engine/session/session_header.h"
#include "widgets/common/latest_job.h"

#include <QFile>
#include <QObject>
#include <QString>

namespace bask {

class MessageBar;

/// While a run is recorded a file names the recording. Whoever finds that file, held by no process, tells of
/// it until somebody has read it.
class CutOffRun : public QObject {
    Q_OBJECT

public:
    CutOffRun(MessageBar& bar, QString markFile, QObject* parent = nullptr);
    ~CutOffRun() override;

    void begin();
    /// Marks the run that is on, and that it is over.
    void apply(const Snapshot& snapshot);
    void retranslate();

signals:
    void openWanted(const QString& session);

private:
    void tell();
    void forget();
    void mark(const QString& recording);

    MessageBar& m_bar;
    QString m_markFile;
    int m_lock = -1;     ///< file descriptor; of this process' run
    QString m_recording; ///< of this process' run; empty: none is on
    SessionHeader m_left;
    LatestJob<SessionHeader> m_read;
};

} // namespace bask
