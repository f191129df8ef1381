#pragma once
// Fields for numbers with units.

#include <QDoubleSpinBox>

namespace bask {

/// Takes a number when it is entered, not while it is typed.
QDoubleSpinBox* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                            const QString& suffix);
/// Shows a value that nobody entered.
void setQuietly(QDoubleSpinBox* field, double value);

} // namespace bask
