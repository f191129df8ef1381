#pragma once
// Judges an experiment's targets before a run: whether they can be held, how long a run takes, and which
// temperatures of each pair of objects can be combined.

#include "engine/control/reachable_pairs.h"
#include "engine/model/mounting_check.h"
#include "widgets/common/latest_job.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// GUI thread; everything is computed off it. The verdict follows every change and is stale until the new one
/// arrives; prediction and maps are computed on request. A newer request stops the work on an older one.
class TargetJudge : public QObject {
    Q_OBJECT

public:
    /// What differs from the previous experiment.
    enum class Change { All, Targets, Controller };
    void setExperiment(const Experiment& experiment, Change change);
    /// Sets which targets the nearest feasible ones must keep; a list whose length is not the number of
    /// objects means none.
    void setKept(const std::vector<bool>& kept);
    /// Judges targets that are only being considered. During a judgement only the newest of the following
    /// ones waits; setExperiment ends them.
    void tryTargets(const std::vector<double>& targets_K);

    /// No tried target is accepted: the verdict is about the experiment again.
    void dropTries();

    /// The newest verdict; empty before the first.
    const std::optional<JointVerdict>& verdict() const { return m_verdict; }
    /// Returns who shades whom at the verdict's pose.
    const std::vector<MountingRemark>& shade() const { return m_shade; }
    bool isStale() const { return m_stale; }
    /// Whether verdict and maps are, or will be, about targets that are only tried.
    bool isTrying() const { return m_judged.objects != m_experiment.objects; }
    /// Whether the verdict is about the experiment as it is.
    bool isCurrent() const { return m_verdict && !m_stale && !isTrying(); }

    /// Simulates a run with the experiment's targets and controller, if they can be held: takes a few
    /// seconds.
    void predict();
    bool predicted() const { return m_predicted; }
    /// After a prediction, the time when all objects have settled; empty if not within the experiment's
    /// duration limit.
    const std::optional<double>& predictedSettling_s() const { return m_predictedSettling_s; }

    /// Maps of all pairs of objects are computed, and follow edits, only while they are wanted.
    void wantPairs(bool wanted);
    /// Maps of the present objects, source and robot; each states its targets. Empty if not computed yet.
    const std::optional<std::vector<ReachableMap>>& pairs() const { return m_pairs; }

signals:
    void verdictChanged();
    void predictionChanged();
    void pairsChanged();

private:
    struct Judgement {
        std::optional<JointVerdict> verdict; ///< empty if it was stopped
        std::shared_ptr<const PoseLookup> lookup;
        std::vector<MountingRemark> shade;
    };
    void judgeTargets();
    void judge(Experiment experiment);
    void tryNext();
    void dropPrediction();
    void mapPairs();

    Experiment m_experiment;
    Experiment m_judged; ///< m_experiment, or the same with tried targets
    std::vector<bool> m_kept;
    std::shared_ptr<const PoseLookup> m_lookup; ///< for the present objects, source and robot
    std::optional<JointVerdict> m_verdict;
    std::vector<MountingRemark> m_shade;
    bool m_stale = true;
    LatestJob<Judgement> m_judge;
    bool m_trying = false;
    std::optional<std::vector<double>> m_nextTry_K;

    bool m_predicting = false;
    bool m_predicted = false;
    std::optional<double> m_predictedSettling_s;
    LatestJob<std::optional<double>> m_predict;

    bool m_pairsWanted = false;
    bool m_pairsPlaced = false; ///< m_pairs are for the present targets
    std::optional<std::vector<ReachableMap>> m_pairs;
    LatestJob<std::optional<std::vector<ReachableMap>>> m_map;
};

} // namespace bask
