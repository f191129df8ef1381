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

    /// Judges targets that are only being considered; the experiment keeps its own. While one try is judged
    /// the newest of those that follow waits.
    void tryTargets(const std::vector<double>& targets_K);
    /// None of the tried targets is taken: the verdict is on the experiment's again.
    void dropTries();

    /// Simulates a run with the experiment's targets and controller, if they can be held: a second or a few
    /// of work off the thread. Any edit drops it.
    void predict();
    bool predicted() const { return m_predicted; }
    /// Once predicted: when all objects have settled; empty: not within the experiment's duration limit.
    const std::optional<double>& predictedSettling_s() const { return m_predictedSettling_s; }

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
    void predictionChanged();
    void pairsChanged();

private:
    Result<void> adopt(const Experiment& experiment);
    void judgeTargets();
    void judge(Experiment experiment);
    void tryNext();
    void dropPrediction();
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
    Experiment m_judged; ///< m_experiment, or with targets that are tried
    bool m_trying = false;
    std::optional<std::vector<double>> m_nextTry_K;
    bool m_predicting = false;
    bool m_predicted = false;
    std::optional<double> m_predictedSettling_s;
    LatestJob<std::optional<double>> m_predict;
    std::optional<std::vector<ReachableMap>> m_pairs; ///< of the present objects, source and robot
    bool m_pairsWanted = false;
    bool m_pairsPlaced = false; ///< and of the present targets
    LatestJob<std::optional<std::vector<ReachableMap>>> m_map;
};

} // namespace bask
