#include "widgets/common/labels.h"

#include "widgets/common/theme.h"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include <optional>

namespace bask {
namespace {

constexpr int kLabelMark = 14;
constexpr int kNotKnown = 0; ///< in place of an alarm's priority

/// Empty: as what is around it.
void setInk(QLabel* label, const std::optional<QColor>& ink) {
    QPalette shown = label->parentWidget()->palette();
    if (ink)
        shown.setColor(QPalette::WindowText, *ink);
    if (label->palette() != shown)
        label->setPalette(shown);
}

/// An alarm's priority, or kNotKnown; empty: neither mark nor colour.
void showMarked(QLabel* mark, QLabel* text, std::optional<int> priority) {
    const bool dark = isDark(mark->parentWidget());
    const bool isUnknown = priority == kNotKnown;
    if (const QPoint drawn(priority.value_or(kNotKnown), dark ? 1 : 0);
        priority && mark->property("drawn") != QVariant(drawn)) {
        const double ratio = mark->devicePixelRatioF();
        mark->setPixmap(isUnknown ? unknownPixmap(dark, kLabelMark, ratio)
                                  : alarmPixmap(*priority, dark, kLabelMark, ratio));
        mark->setProperty("drawn", drawn);
    }
    mark->setVisible(priority.has_value());
    setInk(text, !priority   ? std::nullopt
                 : isUnknown ? std::optional(unknownColor(dark))
                             : std::optional(alarmColor(*priority, dark)));
    if (QFont font = text->font(); font.bold() != priority.has_value()) {
        font.setBold(priority.has_value());
        text->setFont(font);
    }
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
    showMarked(mark, text, isUnknown ? std::optional(kNotKnown) : std::nullopt);
}

void showAlarmed(QLabel* mark, QLabel* text, int priority) {
    showMarked(mark, text, priority);
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
