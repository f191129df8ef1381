#pragma once
// Predicts the run that would be started now, for the Run page.

#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace bask {

struct RigCondition;

/// GUI thread; the run is simulated on a thread of its own, while nothing else wants the processor, from
/// where the rig is and with objects and source as the experiment assumes them: a moment after the last
/// change of experiment or rig, only while it is looked at, and before Start only. From Start on the last
/// prediction stays until the next Arm or an edit. None where the rig's place or a reading is not known.
class RunForecast : public QObject {
    Q_OBJECT

public:
    static constexpr int kRest_ms = 500;              ///< without a change, before it is computed
    static constexpr int kLongest_ms = 20'000;        ///< of computing; the prediction ends where it is then
    static constexpr double kMaxPredicted_s = 1800.0; ///< simulated

    RunForecast();

    /// Sets for how long at most it computes: tests on a loaded machine need longer.
    void setLongest_ms(int longest_ms);
    /// Forgets the prediction, which was for another experiment.
    void setExperiment(const Experiment& experiment);
    /// Takes where the rig is, and whether somebody looks at the prediction: if nobody does none is computed,
    /// but one that is of elsewhere goes all the same.
    void apply(const Snapshot& snapshot, bool isWatched);
    /// Without samples: none.
    const PredictedRun& predicted() const { return m_predicted; }
    enum class Missing {
        Nothing,
        NotSeen,     ///< nobody has looked long enough at the place where it is shown
        NotFinished, ///< it is about to be computed, or is
        NotKnown,    ///< the rig's place or a reading is not known
        NotPossible  ///< it was computed in vain
    };
    /// Why there is none; Nothing if there is one.
    Missing missing() const;
    /// Whether one is about to be computed, or is.
    bool isPending() const { return m_rest.isActive() || isComputing(); }
    bool isComputing() const { return m_job.busy(); }

signals:
    void changed();

private:
    /// What a prediction begins from.
    struct Beginning {
        Vector6d coordinates = Vector6d::Zero();
        std::vector<double> objects_K;
        double source_K = 0.0, environment_K = 0.0;
    };
    std::optional<Beginning> beginningOf(const Snapshot& snapshot) const; ///< empty if it is not known
    bool isInside(const Vector6d& coordinates) const;
    static bool isNear(const Beginning& a, const Beginning& b, double sourceNear_K);
    void pause();
    void drop();
    void predict();
    void spread(const Experiment& experiment, const RigCondition& from);

    Experiment m_experiment;
    std::optional<Beginning> m_from; ///< of the prediction that is there, computed or waited for
    bool m_isKnown = false;          ///< where a run would begin from
    bool m_isMade = false;           ///< that for m_from, though it may be empty
    bool m_isOfRun = false;          ///< what is shown, or that nothing is, belongs to the run that was or is
    std::uint64_t m_runId = 0;
    double m_newest_K = 0.0; ///< of the source
    PredictedRun m_predicted;
    std::function<void()> m_spread; ///< computes how far other noise takes it; empty: done, or of no use
    int m_longest_ms = kLongest_ms;
    QTimer m_rest;
    QThreadPool m_pool;
    LatestJob<PredictedRun> m_job{m_pool};
};

} // namespace bask
