#pragma once
// Tells at the start that the program ended in the middle of a run: nobody has stopped the rig then.

#include "engine/recording/session_header.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>

#include <utility>
#include <vector>

namespace bask {

class MessageBar;

/// While a run is on, a file of this process, locked by it, names the recording. A file that no process has
/// is that of a run that was cut off; it stays until a person has read of it.
class CutOffRun : public QObject {
    Q_OBJECT

public:
    CutOffRun(MessageBar& bar, QString folder, QObject* parent = nullptr);
    /// Leaves the mark of a run of which nobody has said that it is over.
    ~CutOffRun() override;

    void begin();
    /// Marks the run that is on, and that it is over.
    void apply(const Snapshot& snapshot);
    /// The engine has ended: so has the run.
    void end();
    void retranslate();

signals:
    void openWanted(const QString& session);

private:
    struct Mark {
        QString path;
        int lock = -1; ///< file descriptor
    };

    static void remove(Mark& mark);
    static std::vector<Mark> left(const QString& folder);
    void take(const std::vector<SessionHeader>& headers);
    void tell();
    void forget();

    MessageBar& m_bar;
    QString m_folder;
    Mark m_own;               ///< of this process' run
    std::vector<Mark> m_left; ///< of others, this one's from now on
    SessionHeader m_told;
    LatestJob<std::vector<SessionHeader>> m_read;
};

} // namespace bask
