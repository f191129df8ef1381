#include "widgets/common/labels.h"

#include "widgets/common/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include <optional>

namespace bask {
namespace {

constexpr int kUnknownMark = 14;

/// Empty: as what is around it.
void setInk(QLabel* label, const std::optional<QColor>& ink) {
    QPalette shown = label->parentWidget()->palette();
    if (ink)
        shown.setColor(QPalette::WindowText, *ink);
    if (label->palette() != shown)
        label->setPalette(shown);
}

} // namespace

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

void showUnknown(QLabel* mark, QLabel* text, bool isUnknown) {
    const bool dark = isDark(mark->parentWidget());
    const QVariant drawn = mark->property("drawnDark");
    if (isUnknown && (!drawn.isValid() || drawn.toBool() != dark)) {
        mark->setPixmap(unknownPixmap(dark, kUnknownMark, mark->devicePixelRatioF()));
        mark->setProperty("drawnDark", dark);
    }
    mark->setVisible(isUnknown);
    setInk(text, isUnknown ? std::optional(unknownColor(dark)) : std::nullopt);
    if (QFont font = text->font(); font.bold() != isUnknown) {
        font.setBold(isUnknown);
        text->setFont(font);
    }
}

void showOld(QLabel* text, bool isOld) {
    setInk(text, isOld ? std::optional(secondaryText(isDark(text->parentWidget()))) : std::nullopt);
}

void sayWithText(QLabel* label, const QString& what) {
    const QString said = label->text().isEmpty() ? what : what + QStringLiteral(", ") + label->text();
    if (label->accessibleName() != said)
        label->setAccessibleName(said);
}

void nameChoice(QComboBox* choice, const QString& what) {
    choice->setAccessibleName(what);
    if (choice->toolTip().isEmpty()) // which is said, too
        choice->setAccessibleDescription(what);
    if (QLineEdit* field = choice->lineEdit())
        field->setAccessibleName(what);
}

} // namespace bask
