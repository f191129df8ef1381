#include "app/document.h"

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
    emit opened();
    emit modifiedChanged();
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
    emit edited();
    return {};
}

Result<void> Document::setTargets(const std::vector<double>& targets_K) {
    Experiment changed = m_experiment;
    if (const auto set = bask::setTargets(changed, targets_K); !set)
        return set;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    emit targetsChanged();
    return {};
}

Result<void> Document::setVision(const VisionSpec& vision) {
    Experiment changed = m_experiment;
    changed.vision = vision;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    emit visionChanged();
    return {};
}

Result<void> Document::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    if (const auto adopted = adopt(changed); !adopted)
        return adopted;
    emit controllerChanged();
    return {};
}

} // namespace bask
