#pragma once
// What there is to know of an experiment's targets before a run: whether they can be held, how long a run
// takes, which temperatures of each two objects go together.

#include "engine/control/reachable_pairs.h"
#include "engine/model/experiment.h"
#include "widgets/common/latest_job.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// GUI thread; everything is computed off it. The verdict follows every change and is stale until it is
/// there; the prediction and the maps are made when they are asked for. A newer question stops the work on an
/// older one.
class TargetJudge : public QObject {
    Q_OBJECT

public:
    /// What is other than in the experiment before.
    enum class Change { All, Targets, Controller };
    void setExperiment(const Experiment& experiment, Change change);
    /// Targets that the nearest feasible ones shall keep; another number of them than of objects counts as
    /// none.
    void setKept(const std::vector<bool>& kept);
    /// Judges targets that are only being considered. While one try is judged the newest of those that follow
    /// waits; setExperiment ends them.
    void tryTargets(const std::vector<double>& targets_K);

    /// None of the tried targets is taken: the verdict is on the experiment's again.
    void dropTries();

    /// Empty before the first.
    const std::optional<JointVerdict>& verdict() const { return m_verdict; }
    bool isStale() const { return m_stale; }
    /// Whether verdict and maps are, or will be, of targets that are only tried.
    bool isTrying() const { return m_judged != m_experiment; }

    /// Simulates a run with the experiment's targets and controller, if they can be held: a second or a few
    /// of work.
    void predict();
    bool predicted() const { return m_predicted; }
    /// Once predicted: when all objects have settled; empty: not within the experiment's duration limit.
    const std::optional<double>& predictedSettling_s() const { return m_predictedSettling_s; }

    /// Maps of all pairs of objects are made, and follow edits, only while they are wanted.
    void wantPairs(bool wanted);
    /// Of the present objects, source and robot; each says for which targets. Empty: not made yet.
    const std::optional<std::vector<ReachableMap>>& pairs() const { return m_pairs; }

signals:
    void verdictChanged();
    void predictionChanged();
    void pairsChanged();

private:
    struct Judgement {
        std::optional<JointVerdict> verdict; ///< empty: stopped
        std::shared_ptr<const PoseLookup> lookup;
    };
    void judgeTargets();
    void judge(Experiment experiment);
    void tryNext();
    void dropPrediction();
    void mapPairs();

    Experiment m_experiment;
    Experiment m_judged; ///< m_experiment, or with targets that are tried
    std::vector<bool> m_kept;
    std::shared_ptr<const PoseLookup> m_lookup; ///< of the present objects, source and robot
    std::optional<JointVerdict> m_verdict;
    bool m_stale = true;
    LatestJob<Judgement> m_judge;
    bool m_trying = false;
    std::optional<std::vector<double>> m_nextTry_K;

    bool m_predicting = false;
    bool m_predicted = false;
    std::optional<double> m_predictedSettling_s;
    LatestJob<std::optional<double>> m_predict;

    bool m_pairsWanted = false;
    bool m_pairsPlaced = false; ///< m_pairs are of the present targets
    std::optional<std::vector<ReachableMap>> m_pairs;
    LatestJob<std::optional<std::vector<ReachableMap>>> m_map;
};

} // namespace bask
