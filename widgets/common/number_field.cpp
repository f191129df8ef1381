#include "widgets/common/number_field.h"

#include <QSignalBlocker>

namespace bask {

QDoubleSpinBox* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                            const QString& suffix) {
    auto* field = new QDoubleSpinBox(parent);
    field->setObjectName(name);
    field->setDecimals(decimals);
    field->setRange(min, max);
    field->setSuffix(suffix);
    field->setKeyboardTracking(false);
    field->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    return field;
}

void setQuietly(QDoubleSpinBox* field, double value) {
    const QSignalBlocker block(field);
    field->setValue(value);
}

} // namespace bask
