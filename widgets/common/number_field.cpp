#include "widgets/common/number_field.h"

#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>

#include <algorithm>

namespace bask {

namespace {

/// Without the spaces that group thousands in a number from elsewhere, and with a plain minus sign.
QString ungrouped(QString text) {
    static const QRegularExpression kGroup(
        QStringLiteral("(?<=\\d)[ \\x{a0}\\x{2009}\\x{202f}](?=\\d{3}(?!\\d))"));
    return text.remove(kGroup).replace(QChar(0x2212), u'-');
}

} // namespace

std::optional<double> typedNumber(QString text) {
    text = ungrouped(text.trimmed()).replace(u',', u'.');
    const bool isPlain = std::all_of(
        text.begin(), text.end(), [](QChar c) { return c.isDigit() || QStringLiteral("+-.eE").contains(c); });
    bool ok = false;
    const double value = QLocale::c().toDouble(text, &ok);
    return ok && isPlain ? std::optional(value) : std::nullopt;
}

QValidator::State NumberField::validate(QString& text, int& position) const {
    const QString unit = text.endsWith(suffix()) ? suffix() : QString();
    text.chop(unit.size());
    const QString mark = locale().decimalPoint();
    text = ungrouped(text).replace(u'.', mark).replace(u',', mark) + unit;
    position = std::min(position, static_cast<int>(text.size()));
    return QDoubleSpinBox::validate(text, position);
}

QDoubleSpinBox* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                            const QString& suffix) {
    auto* field = new NumberField(parent);
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
