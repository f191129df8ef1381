#pragma once
// The source and the robot's limits: edits the experiment's values.

#include "engine/base/parameter.h"
#include "engine/base/units.h"
#include "engine/model/experiment.h"

#include <QWidget>

#include <array>
#include <functional>

class QDoubleSpinBox;
class QLabel;

namespace bask {

class ParameterForm;
class QuantitySpinBox;

/// Each change is one `edited`; the fields show the last setExperiment. Object names: "measuredSource",
/// "sourceSetPoint", "sourceEmittance", "lower.x" ..., "upper.x" ..., "maxSpeed", "maxRotation", "clearance".
class LimitsPanel : public QWidget {
    Q_OBJECT

public:
    explicit LimitsPanel(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setMeasured(double source_K); ///< NaN if not known
    void setEditable(bool editable);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// `words`: what has changed.
    void edited(const bask::Experiment& experiment, const QString& words);

protected:
    void changeEvent(QEvent* event) override;

private:
    using Apply = std::function<void(Experiment&, double)>;
    QDoubleSpinBox* number(const QString& name, const ValidRange& range, int decimals, const QString& suffix,
                           const Apply& apply);
    QWidget* buildSource();
    QWidget* buildWorkspace();
    void buildMotion();
    void edit(QDoubleSpinBox* field, const Apply& apply, double value);
    void showValues();
    void retranslate();

    Experiment m_experiment;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    double m_measured_K = 0.0;
    QLabel *m_sourceTitle, *m_workspaceTitle, *m_speedTitle;
    QLabel *m_measuredLabel, *m_measured, *m_setPointLabel, *m_emittanceLabel;
    QLabel *m_evennessLabel, *m_evenness;
    QuantitySpinBox* m_setPoint;
    QDoubleSpinBox* m_emittance = nullptr;
    QLabel *m_lowerLabel, *m_upperLabel;
    std::array<QLabel*, 6> m_names{};
    std::array<QDoubleSpinBox*, 6> m_lower{}, m_upper{};
    ParameterForm* m_motion; ///< speeds and clearance
};

} // namespace bask
