#include "app/target_judge.h"

#include "engine/rig/rig_setup.h"
#include "engine/runtime/simulated_run.h"

#include <utility>

namespace bask {

void TargetJudge::setExperiment(const Experiment& experiment, Change change) {
    if (change == Change::All) {
        m_lookup.reset();
        m_pairs.reset();
    }
    m_experiment = experiment;
    if (m_kept.size() != experiment.objects.size())
        m_kept.clear(); // they were of others
    if (change == Change::Controller) {
        m_judged.controller = experiment.controller;
        dropPrediction();
    } else {
        judgeTargets();
    }
}

void TargetJudge::setKept(const std::vector<bool>& kept) {
    if (kept == m_kept)
        return;
    m_kept = kept;
    if (!m_experiment.objects.empty()) // the page may have its ticks before there is an experiment
        judgeTargets();
}

void TargetJudge::tryTargets(const std::vector<double>& targets_K) {
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

void TargetJudge::dropTries() {
    if (m_trying || isTrying())
        judgeTargets();
}

void TargetJudge::judgeTargets() {
    m_trying = false;
    m_nextTry_K.reset();
    judge(m_experiment);
}

void TargetJudge::judge(Experiment experiment) {
    m_judged = std::move(experiment);
    m_stale = true;
    m_pairsPlaced = false;
    m_map.forget();
    dropPrediction();
    emit verdictChanged();
    const auto work = [experiment = m_judged, lookup = m_lookup, kept = m_kept](const std::stop_token& stop) {
        FeasibilityRequest request = feasibilityRequest(experiment);
        request.lookup = lookup ? lookup : feasibilityLookup(request.geometry, request.rest);
        if (kept.size() == experiment.objects.size())
            request.fixed = kept;
        Judgement judgement{jointFeasibility(request, stop), request.lookup, {}};
        if (judgement.verdict && judgement.verdict->anyPose)
            judgement.shade = shadeRemarks(experiment, judgement.verdict->pose, ShadedPose::Here);
        return judgement;
    };
    m_judge.run(work, [this](Judgement judgement) {
        m_verdict = std::move(judgement.verdict);
        m_lookup = std::move(judgement.lookup);
        m_shade = std::move(judgement.shade);
        m_stale = false;
        emit verdictChanged();
        if (m_pairsWanted)
            mapPairs();
        else
            tryNext();
    });
}

void TargetJudge::tryNext() {
    m_trying = false;
    if (m_nextTry_K)
        tryTargets(*std::exchange(m_nextTry_K, std::nullopt));
}

void TargetJudge::wantPairs(bool wanted) {
    m_pairsWanted = wanted;
    if (wanted)
        return mapPairs();
    m_map.forget();
    if (!m_stale)
        tryNext(); // it waited for the maps
}

void TargetJudge::mapPairs() {
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

void TargetJudge::dropPrediction() {
    m_predict.forget();
    m_predicting = m_predicted = false;
    emit predictionChanged();
}

void TargetJudge::predict() {
    if (m_stale || !m_verdict || !m_verdict->feasible || m_predicted || m_predicting || isTrying())
        return;
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
