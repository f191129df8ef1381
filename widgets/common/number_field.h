#pragma once
// Fields for numbers with units.

#include <QDoubleSpinBox>

namespace bask {

/// Makes a field that takes a number when it is entered, not while it is typed.
QDoubleSpinBox* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                            const QString& suffix);
/// Sets a value without signals.
void setQuietly(QDoubleSpinBox* field, double value);

} // namespace bask
