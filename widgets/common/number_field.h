#pragma once
// Fields for numbers with units.

#include <QDoubleSpinBox>

#include <optional>

namespace bask {

/// Reads a number as a person types or pastes it, with a point or a comma, with either minus sign, and with
/// spaces between thousands; empty if it is none.
std::optional<double> typedNumber(QString text);

/// A point or a comma that is typed becomes the decimal mark of its locale; spaces between thousands go.
class NumberField : public QDoubleSpinBox {
public:
    using QDoubleSpinBox::QDoubleSpinBox;

    QValidator::State validate(QString& text, int& position) const override;
};

/// Makes a field that takes a number when it is entered, not while it is typed.
QDoubleSpinBox* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                            const QString& suffix);
/// Sets a value without signals.
void setQuietly(QDoubleSpinBox* field, double value);

} // namespace bask
