#pragma once
// Reports at the start that the program ended in the middle of a run: then nobody has stopped the rig.

#include "engine/recording/session_header.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>

#include <utility>
#include <vector>

namespace bask {

class MessageBar;

/// During a run, a file locked by this process names the recording. A file that no process has locked is that
/// of a run that was cut off; it stays until a person has read the report.
class CutOffRun : public QObject {
    Q_OBJECT

public:
    CutOffRun(MessageBar& bar, QString folder, QObject* parent = nullptr);
    /// Keeps the mark of a run that was not reported as over.
    ~CutOffRun() override;

    void begin();
    /// Marks the current run, and removes the mark when it is over.
    void apply(const Snapshot& snapshot);
    /// Call when the engine has ended: the run is over.
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
    Mark m_own;               ///< mark of this process's run
    std::vector<Mark> m_left; ///< marks of other processes, now owned by this one
    SessionHeader m_told;
    LatestJob<std::vector<SessionHeader>> m_read;
};

} // namespace bask
