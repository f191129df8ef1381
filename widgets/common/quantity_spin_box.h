#pragma once
// Spin boxes for physical values: a temperature kept in kelvin and shown in the display unit, and a gain of
// any magnitude.

#include "engine/base/units.h"
#include "widgets/common/number_field.h"

#include <optional>

namespace bask {

/// Temperature: kelvin inside, °C, K or °F on screen, and any of them typed. Changing the unit never changes
/// the value; Escape restores the value before typing. What is typed is the value to a tenth of the display
/// unit, also where one with more digits is shown so already.
class QuantitySpinBox : public NumberField {
    Q_OBJECT
public:
    explicit QuantitySpinBox(QWidget* parent = nullptr);

    double value_K() const { return m_value_K; }
    /// Shows a value without emitting valueEdited_K. Outside the range it is shown at the range's end.
    void setValue_K(double value_K);
    void setRange_K(double min_K, double max_K);
    TemperatureUnit temperatureUnit() const { return m_unit; }
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// A person changed the value (typing and Enter or leaving the field, arrows, wheel).
    void valueEdited_K(double value_K);
    /// The value in the field during typing, if it is in range; value_K() again if the typing is cancelled.
    /// setValue_K has no effect meanwhile.
    void valueTyped_K(double value_K);

protected:
    QString textFromValue(double value) const override;
    std::optional<double> inOwnUnit(const TypedValue& typed) const override;
    bool isRoundedAway(double) const override { return false; } // zero is a temperature as any other
    void keyPressEvent(QKeyEvent* event) override;

private:
    void show_K();
    void take(double shown);
    void takeTyped(const QString& text);
    void endTyping();

    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    double m_value_K = 298.15;
    double m_min_K = 0.0;
    double m_max_K = 1273.15;
    bool m_showing = false;
    bool m_typing = false;
    bool m_isNumber = false;   ///< the text that is being typed, in the range
    double m_typed_K = 298.15; ///< value of the last valueTyped_K
};

/// A number of any magnitude (0, 1e-22 or 60), with four significant digits, taken while it is typed; a step
/// changes the second digit, and does nothing at zero.
class GainSpinBox : public NumberField {
    Q_OBJECT
public:
    explicit GainSpinBox(QWidget* parent = nullptr);

    QString textFromValue(double value) const override;
    void stepBy(int steps) override;
};

} // namespace bask
