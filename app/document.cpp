#include "app/document.h"

#include <QFileInfo>

namespace bask {

Document::Document(QObject* parent) : QObject(parent), m_shared(std::make_shared<Experiment>()) {
    connect(this, &Document::changed, this, [this] { ++m_generation; });
}

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
    reset(experiment, path, true);
}

void Document::openUnsaved(const Experiment& experiment, const QString& path) {
    reset(experiment, path, false);
}

void Document::reset(const Experiment& experiment, const QString& path, bool saved) {
    m_shared = std::make_shared<const Experiment>(experiment);
    take();
    m_path = path;
    m_history.clear(saved);
    emit opened();
    emit changed();
}

void Document::markSaved(const QString& path) {
    m_path = path;
    m_history.setSaved();
    emit changed();
}

Result<void> Document::edit(const Experiment& experiment, std::optional<Page> page) {
    if (const auto valid = validate(experiment); !valid)
        return valid;
    if (experiment == m_experiment)
        return {};
    EditStep step;
    step.edit = compared(m_experiment, experiment);
    step.edit.page = page.value_or(step.edit.page);
    step.before = m_shared;
    step.after = std::make_shared<const Experiment>(experiment);
    const EditScope scope = step.edit.scope;
    const auto after = step.after;
    m_history.add(std::move(step), EditHistory::Time::clock::now());
    become(after, scope);
    return {};
}

void Document::take() {
    m_experiment = *m_shared;
    if (m_experiment.rig)
        m_realRobot = m_experiment.robot;
}

void Document::become(const std::shared_ptr<const Experiment>& experiment, EditScope scope) {
    m_shared = experiment;
    take();
    switch (scope) {
    case EditScope::Targets:
        emit targetsChanged();
        break;
    case EditScope::Controller:
        emit controllerChanged();
        break;
    case EditScope::Vision:
        emit visionChanged();
        break;
    case EditScope::All:
        emit edited();
        break;
    }
    emit changed();
}

void Document::undo() {
    if (toUndo() == nullptr)
        return;
    const EditStep step = *toUndo();
    m_history.undo();
    become(step.before, step.edit.scope);
}

void Document::redo() {
    if (toRedo() == nullptr)
        return;
    const EditStep step = *toRedo();
    m_history.redo();
    become(step.after, step.edit.scope);
}

Result<void> Document::setTargets(const std::vector<double>& targets_K) {
    Experiment changed = m_experiment;
    if (const auto set = bask::setTargets(changed, targets_K); !set)
        return set;
    return edit(changed);
}

Result<void> Document::setVision(const VisionSpec& vision) {
    Experiment changed = m_experiment;
    changed.vision = vision;
    return edit(changed);
}

Result<void> Document::setController(const ControllerSettings& settings) {
    Experiment changed = m_experiment;
    changed.controller = settings;
    return edit(changed);
}

} // namespace bask
