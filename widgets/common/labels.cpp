#include "widgets/common/labels.h"

#include <QLabel>

namespace bask {

void makeBold(QLabel* label, double scale) {
    QFont font = label->font();
    font.setWeight(QFont::DemiBold);
    if (scale != 1.0) // else it goes on following the application's size
        font.setPointSizeF(font.pointSizeF() * scale);
    label->setFont(font);
}

QLabel* boldLabel(QWidget* parent, double scale) {
    auto* label = new QLabel(parent);
    makeBold(label, scale);
    return label;
}

} // namespace bask
