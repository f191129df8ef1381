#pragma once
// The experiment that is open: its value, its file, whether it was changed.

#include "engine/session/experiment.h"

#include <QObject>
#include <QString>

#include <vector>

namespace bask {

/// GUI thread. Only valid experiments get in.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);

    const Experiment& experiment() const { return m_experiment; }
    QString path() const { return m_path; }
    bool modified() const { return m_modified; }
    /// File name, else title, else a word for "untitled".
    QString displayName() const;

    /// Another experiment; `path` empty: it has no file yet.
    void open(const Experiment& experiment, const QString& path);
    void markSaved(const QString& path);

    /// Refused edits leave everything as it was.
    Result<void> edit(const Experiment& experiment);
    Result<void> setTargets(const std::vector<double>& targets_K);
    /// Markers and calibrations; the rest stays.
    Result<void> setVision(const VisionSpec& vision);
    Result<void> setController(const ControllerSettings& settings);

    /// What File > New makes: one painted disk over the default source.
    static Experiment blank();

signals:
    void opened();
    /// Objects, source or robot: the engine needs the whole experiment again.
    void edited();
    void targetsChanged();
    void controllerChanged();
    void visionChanged();
    void modifiedChanged();

private:
    Result<void> adopt(const Experiment& experiment);

    Experiment m_experiment;
    QString m_path;
    bool m_modified = false;
};

} // namespace bask
