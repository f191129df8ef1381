#pragma once
// What the experiment states of the air in the room, and how much of an object's loss it takes.

#include "engine/base/units.h"
#include "engine/model/experiment.h"

#include <QWidget>

class QComboBox;
class QLabel;

namespace bask {

class ParameterForm;

/// Unknown, a given h, or natural convection by correlation: one statement for all objects. Object names:
/// "airKind", "air.convection", "airTakes", "airSimulated".
class AirForm : public QWidget {
    Q_OBJECT

public:
    explicit AirForm(QWidget* parent = nullptr);

    /// `object`: index of the object whose loss is told; -1 for none.
    void setExperiment(const Experiment& experiment, int object);
    void setTemperatureUnit(TemperatureUnit unit);
    void setReadOnly(bool readOnly);

signals:
    void airEdited(const bask::Air& air);

protected:
    void changeEvent(QEvent* event) override;

private:
    void choose(int kind);
    void show();
    QString lossText() const;
    void retranslate();

    Air m_air;
    Surroundings m_surroundings;
    std::optional<ObjectSpec> m_object;
    std::optional<SimulationSpec> m_simulation; ///< empty on a real rig
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel* m_heading;
    QLabel* m_kindCaption;
    QComboBox* m_kind;
    ParameterForm* m_form;
    QLabel* m_takes;
    QLabel* m_simulated;
};

} // namespace bask
