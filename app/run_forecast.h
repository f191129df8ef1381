#pragma once
// Predicts the run that would be started now, for the Run page.

#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/latest_job.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <optional>
#include <vector>

namespace bask {

/// GUI thread; the run is simulated on a thread of its own, with low priority, from where the rig is and with
/// objects and source as the experiment assumes them: a moment after the last change of experiment or rig,
/// only while it is looked at, and before Start only. From Start on the last prediction stays until the next
/// run or an edit.
class RunForecast : public QObject {
    Q_OBJECT

public:
    static constexpr int kRest_ms = 500;              ///< without a change, before it is computed
    static constexpr int kLongest_ms = 20'000;        ///< of computing; the prediction ends where it is then
    static constexpr double kMaxPredicted_s = 1800.0; ///< simulated

    RunForecast();

    /// Forgets the prediction, which was for another experiment.
    void setExperiment(const Experiment& experiment);
    /// Takes where the rig is, and whether somebody looks at the prediction.
    void apply(const Snapshot& snapshot, bool isWatched);
    /// Without samples: none.
    const PredictedRun& predicted() const { return m_predicted; }
    /// Whether one is about to be computed, or is.
    bool isPending() const { return m_rest.isActive() || m_job.busy(); }

signals:
    void changed();

private:
    /// What a prediction begins from.
    struct Beginning {
        Vector6d coordinates = Vector6d::Zero();
        std::vector<double> objects_K; ///< the room's temperature, if it is not known
        double source_K = 0.0, environment_K = 0.0;
    };
    std::optional<Beginning> beginningOf(const Snapshot& snapshot) const;
    static bool isNear(const Beginning& a, const Beginning& b);
    void drop();
    void predict();

    Experiment m_experiment;
    std::optional<Beginning> m_from; ///< of the prediction that is there, computed or waited for
    bool m_isMade = false;           ///< that for m_from, though it may be empty
    PredictedRun m_predicted;
    QTimer m_rest;
    QThreadPool m_pool;
    LatestJob<PredictedRun> m_job{m_pool};
};

} // namespace bask
