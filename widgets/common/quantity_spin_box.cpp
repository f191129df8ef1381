#include "widgets/common/quantity_spin_box.h"

#include "engine/base/typed_unit.h"
#include "widgets/common/display.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kSameTemperature_K = 1e-9; // more than a conversion of units loses

} // namespace

QuantitySpinBox::QuantitySpinBox(QWidget* parent) : NumberField(parent) {
    setDecimals(1);
    setSingleStep(0.5);
    setKeyboardTracking(false);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    connect(this, &QDoubleSpinBox::valueChanged, this, [this](double shown) {
        if (!m_showing)
            take(shown);
    });
    connect(lineEdit(), &QLineEdit::textEdited, this, &QuantitySpinBox::takeTyped);
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        // What is shown already is no change to the base class; the value may have more digits.
        if (m_typing && m_isNumber &&
            std::abs(kelvinFromDisplay(value(), m_unit) - m_value_K) > kSameTemperature_K)
            take(value());
        endTyping();
    });
    connect(this, &NumberField::refused, this, &QuantitySpinBox::endTyping);
    show_K();
}

void QuantitySpinBox::take(double shown) {
    m_value_K = std::clamp(kelvinFromDisplay(shown, m_unit), m_min_K, m_max_K);
    m_typed_K = m_value_K;
    m_typing = false;
    emit valueEdited_K(m_value_K);
}

void QuantitySpinBox::takeTyped(const QString& text) {
    if (!m_typing)
        m_typed_K = m_value_K;
    m_typing = true;
    const auto shown = number(text);
    m_isNumber = shown && isWithinRange(*shown);
    if (!m_isNumber)
        return;
    m_typed_K = kelvinFromDisplay(*shown, m_unit);
    emit valueTyped_K(m_typed_K);
}

void QuantitySpinBox::endTyping() {
    if (!std::exchange(m_typing, false))
        return;
    show_K();
    if (m_typed_K != m_value_K) {
        m_typed_K = m_value_K;
        emit valueTyped_K(m_value_K);
    }
}

void QuantitySpinBox::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape || !m_typing)
        return NumberField::keyPressEvent(event);
    endTyping();
    selectAll();
}

std::optional<double> QuantitySpinBox::inOwnUnit(const TypedValue& typed) const {
    if (typed.unit.isEmpty())
        return typed.value;
    const auto unit = typedTemperatureUnit(typed.unit.toStdString());
    return unit ? std::optional(displayTemperature(kelvinFromDisplay(typed.value, *unit), m_unit))
                : std::nullopt;
}

QString QuantitySpinBox::textFromValue(double value) const {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator);
    return plain.toString(value, 'f', decimals());
}

void QuantitySpinBox::setValue_K(double value_K) {
    if (!std::isfinite(value_K) || m_typing)
        return;
    m_value_K = std::clamp(value_K, m_min_K, m_max_K);
    show_K();
}

void QuantitySpinBox::setRange_K(double min_K, double max_K) {
    m_min_K = min_K;
    m_max_K = std::max(min_K, max_K);
    m_value_K = std::clamp(m_value_K, m_min_K, m_max_K);
    show_K();
}

void QuantitySpinBox::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m_unit)
        return;
    m_unit = unit;
    show_K();
}

void QuantitySpinBox::show_K() {
    m_showing = true;
    setSuffix(QChar(0x00a0) + temperatureUnitSymbol(m_unit));
    setRange(displayTemperature(m_min_K, m_unit), displayTemperature(m_max_K, m_unit));
    setValue(std::round(displayTemperature(m_value_K, m_unit) * 10.0) / 10.0); // as display.h rounds
    m_showing = false;
}

GainSpinBox::GainSpinBox(QWidget* parent) : NumberField(parent) {
    setDecimals(60); // the base class rounds to this; what is shown is textFromValue's business
    setRange(1e-40, 1e9);
    setKeyboardTracking(true);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
}

QString GainSpinBox::textFromValue(double value) const {
    QLocale plain = locale();
    plain.setNumberOptions(QLocale::OmitGroupSeparator | QLocale::OmitLeadingZeroInExponent);
    return plain.toString(value, 'g', 4);
}

void GainSpinBox::stepBy(int steps) {
    if (!endTracking() || value() <= 0.0) // no magnitude to step by
        return;
    for (int i = 0; i < std::abs(steps); ++i) {
        const bool up = steps > 0;
        // Stepping down from a power of ten uses the finer step below it, so that up and down retrace each
        // other.
        const double magnitude = std::log10(value()) * (1.0 + 1e-15);
        double exponent = std::floor(magnitude + 1e-9);
        if (!up && std::abs(magnitude - exponent) < 1e-9)
            exponent -= 1.0;
        const double step = std::pow(10.0, exponent - 1.0);
        setValue((std::round(value() / step) + (up ? 1.0 : -1.0)) * step);
    }
    selectAll();
}

} // namespace bask
