#pragma once
// The experiment that is open: its value, its file, its edits and whether any is not saved.

#include "app/edit_history.h"
#include "engine/model/experiment.h"

#include <QObject>
#include <QString>

#include <memory>
#include <optional>
#include <vector>

namespace bask {

/// GUI thread. Only valid experiments get in. Whoever edits the experiment does it here, so that it can be
/// undone.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Experiment& experiment() const { return m_experiment; }
    /// Of the newest experiment that was for a real rig; empty: there was none.
    const std::optional<RobotLimits>& realRobot() const { return m_realRobot; }
    QString path() const { return m_path; }
    /// Not as it was opened or saved last; true again or not after an undo, as it happens.
    bool modified() const { return !m_history.isSaved(); }
    /// Grows with every change: what is read for its place later asks whether it is still the same.
    int generation() const { return m_generation; }
    /// File name, else title, else a word for "untitled".
    QString displayName() const;

    /// Another experiment; `path` empty: it has no file yet.
    void open(const Experiment& experiment, const QString& path);
    /// The same of one whose file, if it has any, does not hold what it is.
    void openUnsaved(const Experiment& experiment, const QString& path);
    void markSaved(const QString& path);

    /// Refused edits leave everything as it was. `page`: where it was made, if it is not the usual one.
    Result<void> edit(const Experiment& experiment, std::optional<Page> page = {});
    Result<void> setTargets(const std::vector<double>& targets_K);
    /// Markers and calibrations; the rest stays.
    Result<void> setVision(const VisionSpec& vision);
    Result<void> setController(const ControllerSettings& settings);

    /// Null: nothing to undo, to redo.
    const EditStep* toUndo() const { return m_history.toUndo(); }
    const EditStep* toRedo() const { return m_history.toRedo(); }
    void undo();
    void redo();

    /// What File > New makes: one painted disk over the default source.
    static Experiment blank();

signals:
    void opened();
    // Of an edit, undone or redone ones too, the narrowest:
    /// Objects, source or robot: the engine needs the whole experiment again.
    void edited();
    void targetsChanged();
    void controllerChanged();
    void visionChanged();
    /// After any of the above or a save: experiment, file, what is modified, what can be undone.
    void changed();

private:
    void reset(const Experiment& experiment, const QString& path, bool saved);
    void become(const std::shared_ptr<const Experiment>& experiment, EditScope scope);

    void take();

    Experiment m_experiment;
    std::optional<RobotLimits> m_realRobot{};
    std::shared_ptr<const Experiment> m_shared; ///< the same, as the history has it
    QString m_path;
    EditHistory m_history;
    int m_generation = 0;
};

} // namespace bask
