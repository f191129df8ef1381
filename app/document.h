#pragma once
// The experiment that is open: its value, its file, whether it was changed, and the verdicts on its targets.

#include "engine/control/feasibility.h"
#include "engine/session/experiment.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>

namespace bask {

/// GUI thread. Only valid experiments get in; verdicts are computed off the thread and are stale until they
/// are there.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Experiment& experiment() const { return m_experiment; }
    QString path() const { return m_path; }
    bool modified() const { return m_modified; }
    /// File name, else title, else a word for "untitled".
    QString displayName() const;

    /// Another experiment; `path` empty: it has no file yet.
    void open(const Experiment& experiment, const QString& path);
    void markSaved(const QString& path);

    /// Refused edits leave everything as it was.
    Result<void> edit(const Experiment& experiment);
    Result<void> setTargets(const std::vector<double>& targets_K);
    Result<void> setController(const ControllerSettings& settings);

    const std::vector<TargetVerdict>& verdicts() const { return m_verdicts; }
    bool verdictsStale() const { return m_stale; }

    /// What File > New makes: one painted disk over the default source.
    static Experiment blank();

signals:
    void opened();
    /// Objects, source or robot: the engine needs the whole experiment again.
    void edited();
    void targetsChanged();
    void controllerChanged();
    void modifiedChanged();
    void verdictsChanged();

private:
    Result<void> adopt(const Experiment& experiment);
    void judgeTargets();

    Experiment m_experiment;
    QString m_path;
    bool m_modified = false;
    std::vector<TargetVerdict> m_verdicts;
    bool m_stale = true;
    LatestJob<std::vector<TargetVerdict>> m_judge;
};

} // namespace bask
