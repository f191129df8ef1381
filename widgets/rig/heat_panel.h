#pragma once
// The heat by hand: on towards a set point, off; or the temperature that a person reads off and types.

#include "engine/base/units.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <QWidget>

class QLabel;
class QMessageBox;
class QPushButton;

namespace bask {

class QuantitySpinBox;

/// More heat on a real rig asks first. Object names: "heatSetPoint", "heatOn", "heatOff", "heatState",
/// "typedSource", "takeTyped", "heatQuestion".
class HeatPanel : public QWidget {
    Q_OBJECT

public:
    explicit HeatPanel(QWidget* parent = nullptr);

    /// The experiment's set point: what is proposed.
    void setUsual(double setPoint_K);
    /// `mayHeat`: no run is armed or on, nothing is latched.
    void apply(const Snapshot& snapshot, bool mayHeat);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    void commandWanted(const bask::Command& command);

protected:
    void changeEvent(QEvent* event) override;

private:
    void heat();
    void ask(double setPoint_K);
    void showState();
    void retranslate();

    Snapshot m_last; ///< of what is read here only
    bool m_mayHeat = false;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    double m_usual_K = 0.0;
    QLabel *m_setPointLabel, *m_typedLabel, *m_mark, *m_state;
    QuantitySpinBox *m_setPoint, *m_typed;
    QPushButton *m_on, *m_off, *m_take;
};

} // namespace bask
