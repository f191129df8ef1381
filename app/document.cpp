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
    m_kept.clear();
    emit opened();
    emit modifiedChanged();
    judge(m_experiment);
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
    emit edited();
    judge(m_experiment);
    return {};
}

Result<void> Document::setTargets(const std::vector<double>& targets_K) {
    Experiment changed = m_experiment;
    if (const auto set = bask::setTargets(changed, targets_K); !set)
        return set;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    emit targetsChanged();
    judge(m_experiment);
    return {};
}

Result<void> Document::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    dropPrediction();
    emit controllerChanged();
    return {};
}

void Document::setKept(const std::vector<bool>& kept) {
    m_kept = kept;
    judge(m_experiment);
}

void Document::tryTargets(const std::vector<double>& targets_K) {
    Experiment tried = m_experiment;
    if (bask::setTargets(tried, targets_K))
        judge(std::move(tried));
}

void Document::judge(Experiment experiment) {
    dropPrediction();
    m_stale = true;
    emit verdictChanged();
    const auto work = [experiment = std::move(experiment), lookup = m_lookup,
                       kept = m_kept](const std::stop_token& stop) {
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
    for (std::size_t i = 0; i < m_experiment.objects.size(); ++i)
        if (m_verdict->conditions1[i].target_K != m_experiment.objects[i].target_K)
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
