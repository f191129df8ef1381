#pragma once
// The experiment that is open: its value, its file, whether it was changed, and the verdict on its targets.

#include "engine/control/reachable_pairs.h"
#include "engine/session/experiment.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// GUI thread. Only valid experiments get in; the verdict is computed off the thread and is stale until it is
/// there; a newer edit stops the work on an older one. So are the maps of reachable pairs, after the verdict
/// and while somebody wants them.
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

    /// Targets that the nearest feasible ones shall keep.
    void setKept(const std::vector<bool>& kept);

    /// Empty before the first.
    const std::optional<JointVerdict>& verdict() const { return m_verdict; }
    bool verdictStale() const { return m_stale; }

    /// Maps of all pairs of objects are made, and follow edits, only while they are wanted.
    void wantPairs(bool wanted);
    /// Of the present objects, source and robot; each says for which targets. Empty: not made yet.
    const std::optional<std::vector<ReachableMap>>& pairs() const { return m_pairs; }

    /// What File > New makes: one painted disk over the default source.
    static Experiment blank();

signals:
    void opened();
    /// Objects, source or robot: the engine needs the whole experiment again.
    void edited();
    void targetsChanged();
    void controllerChanged();
    void modifiedChanged();
    void verdictChanged();
    /// There are new ones.
    void pairsChanged();

private:
    Result<void> adopt(const Experiment& experiment);
    void judgeTargets();
    void mapPairs();

    Experiment m_experiment;
    QString m_path;
    bool m_modified = false;
    /// The sampled workspace outlives edits of targets.
    struct Judgement {
        std::optional<JointVerdict> verdict; ///< empty: stopped
        std::shared_ptr<const PoseLookup> lookup;
    };
    std::optional<JointVerdict> m_verdict;
    std::shared_ptr<const PoseLookup> m_lookup; ///< of the present objects, source and robot
    std::vector<bool> m_kept;
    bool m_stale = true;
    LatestJob<Judgement> m_judge;
    std::optional<std::vector<ReachableMap>> m_pairs; ///< of the present objects, source and robot
    bool m_pairsWanted = false;
    bool m_pairsPlaced = false; ///< and of the present targets
    LatestJob<std::optional<std::vector<ReachableMap>>> m_map;
};

} // namespace bask
