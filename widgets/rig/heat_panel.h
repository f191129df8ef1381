#pragma once
// The manual heat: on with a set point, off; or the source temperature that a person reads and types.

#include "engine/base/units.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <QWidget>

class QLabel;
class QMessageBox;
class QPushButton;

namespace bask {

class QuantitySpinBox;

/// On a real rig, more heat is asked about first. Object names: "heatSetPoint", "heatOn", "heatOff",
/// "heatState", "typedSource", "takeTyped", "heatQuestion".
class HeatPanel : public QWidget {
    Q_OBJECT

public:
    explicit HeatPanel(QWidget* parent = nullptr);

    /// Sets the proposed set point: the experiment's.
    void setUsual(double setPoint_K);
    /// `mayHeat`: no run is armed or on, no fault is latched.
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

    Snapshot m_last; ///< only the values that are read here
    bool m_mayHeat = false;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    double m_usual_K = 0.0;
    QLabel *m_setPointLabel, *m_typedLabel, *m_mark, *m_state;
    QuantitySpinBox *m_setPoint, *m_typed;
    QPushButton *m_on, *m_off, *m_take;
};

} // namespace bask
