#include "app/document.h"

#include "engine/runtime/rig_setup.h"
#include "engine/runtime/simulated_run.h"

#include <QFileInfo>

namespace bask {

Document::Document(QObject* parent) : QObject(parent) {}

QString Document::displayName() const {
    if (!m_path.isEmpty())
        return QFileInfo(m_path).fileName();
    return m_experiment.title.empty() ? tr("Untitled") : QString::fromStdString(m_experiment.title);
}

Experiment Document::blank() {
    Experiment experiment;
    ObjectSpec disk;
    disk.name = "disk";
    disk.shape = Disk{0.015};
    experiment.objects.push_back(disk);
    return experiment;
}

void Document::open(const Experiment& experiment, const QString& path) {
    m_experiment = experiment;
    m_path = path;
    m_modified = false;
    m_verdict.reset();
    m_lookup.reset();
    m_pairs.reset();
    m_kept.clear();
    emit opened();
    emit modifiedChanged();
    judgeTargets();
}

void Document::markSaved(const QString& path) {
    m_path = path;
    m_modified = false;
    emit modifiedChanged();
}

Result<void> Document::adopt(const Experiment& experiment) {
    if (const auto valid = validate(experiment); !valid)
        return valid;
    m_experiment = experiment;
    m_modified = true;
    emit modifiedChanged();
    return {};
}

Result<void> Document::edit(const Experiment& experiment) {
    if (const auto adopted = adopt(experiment); !adopted)
        return adopted;
    m_lookup.reset();
    m_pairs.reset();
    if (m_kept.size() != m_experiment.objects.size())
        m_kept.clear(); // they were of others
    emit edited();
    judgeTargets();
    return {};
}

Result<void> Document::setTargets(const std::vector<double>& targets_K) {
    Experiment changed = m_experiment;
    if (const auto set = bask::setTargets(changed, targets_K); !set)
        return set;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    emit targetsChanged();
    judgeTargets();
    return {};
}

Result<void> Document::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    m_judged.controller = settings; // no verdict depends on it
    emit controllerChanged();
    dropPrediction();
    return {};
}

void Document::setKept(const std::vector<bool>& kept) {
    m_kept = kept;
    judgeTargets();
}

void Document::tryTargets(const std::vector<double>& targets_K) {
    if (m_trying) {
        m_nextTry_K = targets_K;
        return;
    }
    Experiment tried = m_experiment;
    if (!bask::setTargets(tried, targets_K))
        return;
    m_trying = true;
    judge(std::move(tried));
}

void Document::dropTries() {
    if (m_trying || m_judged != m_experiment)
        judgeTargets();
}

void Document::judgeTargets() {
    m_trying = false;
    m_nextTry_K.reset();
    judge(m_experiment);
}

void Document::judge(Experiment experiment) {
    m_judged = std::move(experiment);
    m_stale = true;
    dropPrediction();
    m_pairsPlaced = false;
    m_map.forget();
    emit verdictChanged();
    const auto work = [experiment = m_judged, lookup = m_lookup, kept = m_kept](const std::stop_token& stop) {
        FeasibilityRequest request = feasibilityRequest(experiment);
        request.lookup = lookup ? lookup : feasibilityLookup(request.geometry, request.rest);
        if (kept.size() == experiment.objects.size())
            request.held = kept;
        return Judgement{jointFeasibility(request, stop), request.lookup};
    };
    m_judge.run(work, [this](Judgement judgement) {
        m_verdict = std::move(judgement.verdict);
        m_lookup = std::move(judgement.lookup);
        m_stale = false;
        emit verdictChanged();
        if (m_pairsWanted)
            mapPairs();
        else
            tryNext();
    });
}

void Document::tryNext() {
    m_trying = false;
    if (m_nextTry_K)
        tryTargets(*std::exchange(m_nextTry_K, std::nullopt));
}

void Document::wantPairs(bool wanted) {
    m_pairsWanted = wanted;
    if (wanted)
        mapPairs();
    else {
        m_map.forget();
        if (!m_stale)
            tryNext(); // it waited for the maps
    }
}

void Document::mapPairs() {
    if (m_pairsPlaced || m_stale)
        return;
    const auto work = [experiment = m_judged, lookup = m_lookup,
                       known = m_pairs](const std::stop_token& stop) {
        FeasibilityRequest request = feasibilityRequest(experiment);
        request.lookup = lookup;
        return known ? placeTargets(*known, request, stop) : reachablePairs(request, stop);
    };
    m_map.run(work, [this](std::optional<std::vector<ReachableMap>> pairs) {
        m_pairs = std::move(pairs);
        m_pairsPlaced = true;
        emit pairsChanged();
        tryNext();
    });
}

void Document::dropPrediction() {
    m_predict.forget();
    m_predicting = m_predicted = false;
    emit predictionChanged();
}

void Document::predict() {
    if (m_stale || !m_verdict || !m_verdict->feasible || m_predicted || m_predicting)
        return;
    if (m_judged != m_experiment)
        return; // the verdict is on targets that were only tried
    m_predicting = true;
    const auto work = [experiment = m_experiment](const std::stop_token& stop) {
        const auto settling_s = bask::predictedSettling_s(experiment, stop);
        return settling_s ? *settling_s : std::nullopt; // one that cannot run does not settle
    };
    m_predict.run(work, [this](std::optional<double> settling_s) {
        m_predicted = true;
        m_predictedSettling_s = settling_s;
        emit predictionChanged();
    });
}

} // namespace bask
