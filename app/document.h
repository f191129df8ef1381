#pragma once
// The open experiment: its value, its file, its edits and whether any of them is not saved.

#include "app/edit_history.h"
#include "engine/model/experiment.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// GUI thread. Accepts only valid experiments. All edits of the experiment are made here, so that they can be
/// undone.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Experiment& experiment() const { return m_experiment; }
    /// Robot limits of the newest experiment for a real rig; empty if there was none.
    const std::optional<RobotLimits>& realRobot() const { return m_realRobot; }
    QString path() const { return m_path; }
    /// Whether it differs from what was opened or saved last; an undo may change this in both directions.
    bool modified() const { return !m_history.isSaved(); }
    /// Increases with every change: a reader of a file compares it later, to see whether the experiment is
    /// still the same.
    int generation() const { return m_generation; }
    /// The file name, or the title, or a word for "untitled".
    QString displayName() const;

    /// Opens another experiment; with an empty `path` it has no file yet.
    void open(const Experiment& experiment, const QString& path);
    /// Opens an experiment that differs from its file, or has none.
    void openUnsaved(const Experiment& experiment, const QString& path);
    void markSaved(const QString& path);

    /// Applies an edit; a refused one changes nothing. `page`: where it was made, if not on the usual page.
    Result<void> edit(const Experiment& experiment, std::optional<Page> page = {});
    Result<void> setTargets(const std::vector<double>& targets_K);
    /// Sets markers and calibrations; the rest is not changed.
    Result<void> setVision(const VisionSpec& vision);
    Result<void> setController(const ControllerSettings& settings);

    /// The edit to undo or to redo; null if there is none.
    const EditStep* toUndo() const { return m_history.toUndo(); }
    const EditStep* toRedo() const { return m_history.toRedo(); }
    void undo();
    void redo();

    /// The experiment of File > New: one painted disk over the default source.
    static Experiment blank();

signals:
    void opened();
    // For each edit, also an undone or redone one, the narrowest of these signals:
    /// Objects, source or robot: the engine needs the whole experiment again.
    void edited();
    void targetsChanged();
    void controllerChanged();
    void visionChanged();
    /// After any of the above or a save: experiment, file, modified state or undo list have changed.
    void changed();

private:
    void reset(const Experiment& experiment, const QString& path, bool saved);
    void become(const std::shared_ptr<const Experiment>& experiment, EditScope scope);

    void take();

    Experiment m_experiment;
    std::optional<RobotLimits> m_realRobot{};
    std::shared_ptr<const Experiment> m_shared; ///< the same value, shared with the history
    QString m_path;
    EditHistory m_history;
    int m_generation = 0;
};

} // namespace bask
