#include "widgets/common/number_field.h"

#include "engine/base/typed_unit.h"

#include <QAccessible>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace bask {

namespace {

/// Without the spaces that group thousands in a number from elsewhere, with plain spaces, a plain minus sign
/// and, for the full-width marks of Chinese input, those of ASCII.
QString ungrouped(QString text) {
    constexpr char16_t kFirst = 0xff01, kLast = 0xff5e, kToAscii = 0xfee0;
    for (QChar& each : text)
        if (each >= QChar(kFirst) && each <= QChar(kLast))
            each = QChar(static_cast<char16_t>(each.unicode() - kToAscii));
    text.replace(QChar(0x3002), u'.'); // the full stop
    static const QRegularExpression kGroup(
        QStringLiteral("(?<=\\d)[ \\x{a0}\\x{2009}\\x{202f}\\x{3000}](?=\\d{3}(?!\\d))"));
    static const QRegularExpression kSpace(QStringLiteral("[\\x{a0}\\x{2009}\\x{202f}\\x{3000}]"));
    return text.remove(kGroup).replace(kSpace, QStringLiteral(" ")).replace(QChar(0x2212), u'-');
}

/// "1.0" is a number with a fraction, as "1.5" is.
bool hasFraction(const QString& text, double value) {
    const QString plain = ungrouped(text);
    return value != std::trunc(value) || plain.contains(u'.') || plain.contains(u',');
}

} // namespace

std::optional<TypedValue> typedValue(const QString& text) {
    // What follows is no further digit or mark, but for "1/s", nor an exponent without digits.
    static const QRegularExpression kParts(
        QStringLiteral("^([+-]?(?:[0-9]+[.,]?[0-9]*|[.,][0-9]+)(?:[eE][+-]?[0-9]+)?)"
                       "(?:|\\s*(?![eE][+-]?$)([^0-9.,+\\s-].*)|\\s+(1/.*))$"));
    const QRegularExpressionMatch parts = kParts.match(ungrouped(text.trimmed()));
    bool ok = false;
    const double value = QLocale::c().toDouble(parts.captured(1).replace(u',', u'.'), &ok);
    if (!parts.hasMatch() || !ok)
        return std::nullopt;
    static const QRegularExpression kGrouped(QStringLiteral("^[+-]?[1-9][0-9]{0,2},[0-9]{3}$"));
    return TypedValue{value, parts.captured(2) + parts.captured(3),
                      kGrouped.match(parts.captured(1)).hasMatch()};
}

NumberField::NumberField(QWidget* parent) : QDoubleSpinBox(parent) {
    connect(this, &NumberField::refused, this, [this](const QString& why) {
        setValue(std::exchange(m_beforeTracking, {}).value_or(value()));
        m_isRefused = true;
        if (!why.isEmpty())
            say(why);
    });
    connect(lineEdit(), &QLineEdit::textEdited, this, [this] {
        forgetRefusal();
        m_refusedBy = nullptr;
        if (keyboardTracking() && !m_beforeTracking)
            m_beforeTracking = value(); // that of the text follows
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] { m_beforeTracking.reset(); });
}

QValidator::State NumberField::validate(QString& text, int&) const {
    const auto typed = number(text);
    return typed && isWithinRange(*typed) && !isRoundedAway(*typed) ? QValidator::Acceptable
                                                                    : QValidator::Intermediate;
}

double NumberField::valueFromText(const QString& text) const {
    const auto typed = number(text);
    return typed ? roundedAsShown(*typed) : value();
}

/// The base class would drop the marks that group digits, and take 415 for "4,1,5". It restores the value
/// where a text is not repaired.
void NumberField::fixup(QString& text) const {
    const QString typed = withoutSuffix(text);
    const bool isSpecial = !text.isEmpty() && text == specialValueText();
    const bool isShown = isSpecial || typed == textFromValue(value());
    if (!isShown)
        emit refused(typed.isEmpty() ? QString() : whyNot(typed));
}

void NumberField::stepBy(int steps) {
    QDoubleSpinBox::stepBy(steps);
    m_beforeTracking.reset();
}

bool NumberField::takeRefusalBy(const QWidget* widget) {
    return m_refusedBy != nullptr && std::exchange(m_refusedBy, nullptr) == widget;
}

/// Enter that is refused is handled: it does not close the dialog.
void NumberField::keyPressEvent(QKeyEvent* event) {
    m_isRefused = false;
    QDoubleSpinBox::keyPressEvent(event);
    if (m_isRefused)
        event->accept();
}

void NumberField::focusOutEvent(QFocusEvent* event) {
    m_isRefused = false;
    QDoubleSpinBox::focusOutEvent(event);
    if (m_isRefused && event->reason() == Qt::MouseFocusReason)
        m_refusedBy = QApplication::focusWidget();
}

bool NumberField::endTracking() {
    const bool isTaken = !m_beforeTracking || hasAcceptableInput();
    if (m_beforeTracking)
        interpretText();
    m_beforeTracking.reset();
    return isTaken;
}

std::optional<double> NumberField::inOwnUnit(const TypedValue& typed) const {
    if (m_shareOf && typed.unit == QStringLiteral("%"))
        return 0.01 * typed.value * *m_shareOf;
    return typed.unit.isEmpty()
               ? std::optional(typed.value)
               : converted(typed.value, typed.unit.toStdString(), suffix().trimmed().toStdString());
}

std::optional<double> NumberField::number(const QString& text) const {
    const auto typed = typedValue(withoutSuffix(text));
    return typed && !isAmbiguous(*typed) ? inOwnUnit(*typed) : std::nullopt;
}

bool NumberField::isWithinRange(double value) const {
    const double lost = 1e-12 * std::abs(value); // more than a conversion loses
    return value >= minimum() - lost && value <= maximum() + lost;
}

bool NumberField::isRoundedAway(double value) const {
    const double lost = 1e-12 * std::abs(value), rounded = roundedAsShown(value);
    return (rounded == 0.0 && value != 0.0) || (isShownInWords(rounded) && value > minimum() + lost);
}

bool NumberField::isShownInWords(double rounded) const {
    return !specialValueText().isEmpty() && rounded <= minimum();
}

bool NumberField::isAmbiguous(const TypedValue& typed) const {
    return typed.mayBeGrouped && locale().groupSeparator() == QStringLiteral(",");
}

/// As the base class rounds.
double NumberField::roundedAsShown(double value) const {
    return QString::number(value, 'f', decimals()).toDouble();
}

/// The suffix stays behind what is typed over a number.
QString NumberField::withoutSuffix(const QString& text) const {
    return text.left(text.size() - (text.endsWith(suffix()) ? suffix().size() : 0)).trimmed();
}

QString NumberField::whyNot(const QString& typed) const {
    const auto parts = typedValue(typed);
    const QString own = suffix().trimmed();
    if (!parts)
        return tr("\u201c%1\u201d is not a number; the value stays as it was").arg(typed);
    if (isAmbiguous(*parts)) {
        const QString plain = ungrouped(typed);
        return tr("\u201c%1\u201d may be one of two numbers: type %2 or %3")
            .arg(typed, QString(plain).remove(u','), QString(plain).replace(u',', u'.'));
    }
    const auto wanted = inOwnUnit(*parts);
    if (wanted && isWithinRange(*wanted)) {
        const double rounded = roundedAsShown(*wanted);
        return tr("\u201c%1\u201d was not taken: with the digits of this field it would be %2")
            .arg(typed, isShownInWords(rounded) ? specialValueText() : textFromValue(rounded) + suffix());
    }
    if (wanted && !specialValueText().isEmpty())
        return tr("\u201c%1\u201d is out of range; allowed: more than %2, up to %3")
            .arg(typed, textFromValue(minimum()) + suffix(), textFromValue(maximum()) + suffix());
    if (wanted)
        return tr("\u201c%1\u201d is out of range; allowed: %2 to %3")
            .arg(typed, textFromValue(minimum()) + suffix(), textFromValue(maximum()) + suffix());
    if (own.isEmpty())
        return tr("\u201c%1\u201d was not taken: this value has no unit").arg(typed);
    return tr("\u201c%1\u201d was not taken: %2 is not a unit of this value, which is in %3")
        .arg(typed, parts->unit, own);
}

void NumberField::forgetRefusal() {
    delete m_refusal;
    if (m_ownDescription)
        setAccessibleDescription(*std::exchange(m_ownDescription, {}));
}

/// The words stand where the field was when they came.
bool NumberField::eventFilter(QObject* watched, QEvent* event) {
    const bool isElsewhere = event->type() == QEvent::Hide || event->type() == QEvent::Resize ||
                             (event->type() == QEvent::Move && watched != window());
    if (isElsewhere && m_refusal != nullptr)
        m_refusal->hide();
    return QDoubleSpinBox::eventFilter(watched, event);
}

void NumberField::say(const QString& why) {
    constexpr std::chrono::seconds kShown(10);
    constexpr int kMargin_px = 4, kMaxWidth_px = 420;
    const QString name = QStringLiteral("fieldRefusal");
    QWidget* place = window();
    qDeleteAll(place->findChildren<QLabel*>(name)); // of another field
    m_refusal = new QLabel(why, place);
    m_refusal->setObjectName(name);
    m_refusal->setTextFormat(Qt::PlainText);
    m_refusal->setWordWrap(true);
    m_refusal->setMargin(kMargin_px);
    m_refusal->setFrameShape(QFrame::Box);
    m_refusal->setBackgroundRole(QPalette::ToolTipBase);
    m_refusal->setForegroundRole(QPalette::ToolTipText);
    m_refusal->setAutoFillBackground(true);
    m_refusal->setAttribute(Qt::WA_TransparentForMouseEvents); // what is below can be clicked
    const int wanted = m_refusal->fontMetrics().horizontalAdvance(why) + 4 * kMargin_px;
    const int width = std::min({wanted, kMaxWidth_px, place->width()});
    const int height = m_refusal->heightForWidth(width);
    const QPoint above = mapTo(place, QPoint(0, 0)), below = mapTo(place, QPoint(0, this->height()));
    const bool fits = below.y() + height <= place->height();
    m_refusal->setGeometry(std::clamp(below.x(), 0, place->width() - width),
                           std::max(0, fits ? below.y() : above.y() - height), width, height);
    m_refusal->show();
    m_refusal->raise();
    for (QWidget* each = this; each != place; each = each->parentWidget())
        each->installEventFilter(this);
    place->installEventFilter(this);
    QAccessibleEvent alert(m_refusal, QAccessible::Alert);
    QAccessible::updateAccessibility(&alert);
    if (!m_ownDescription)
        m_ownDescription = accessibleDescription();
    setAccessibleDescription(why); // a screen reader on Linux is told no alert
    QTimer::singleShot(kShown, m_refusal, &QObject::deleteLater);
    connect(this, &QObject::destroyed, m_refusal, &QObject::deleteLater);
}

WholeNumberField::WholeNumberField(QWidget* parent) : NumberField(parent) {
    setDecimals(0);
}

std::optional<double> WholeNumberField::number(const QString& text) const {
    const auto typed = NumberField::number(text);
    return typed && !hasFraction(text, *typed) ? typed : std::nullopt;
}

QString WholeNumberField::whyNot(const QString& typed) const {
    const auto parts = typedValue(typed);
    if (parts && hasFraction(typed, inOwnUnit(*parts).value_or(0.0)))
        return tr("\u201c%1\u201d is not a whole number; the value stays as it was").arg(typed);
    return NumberField::whyNot(typed);
}

NumberField* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
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

void setQuietly(QDoubleSpinBox* field, double value, int decimals, int maxDecimals) {
    constexpr double kSame = 5e-3; // of the value
    const auto isShown = [value](int with) {
        const double scale = std::pow(10.0, with);
        return std::abs(std::round(value * scale) / scale - value) <= kSame * std::abs(value);
    };
    while (decimals < maxDecimals && !isShown(decimals))
        ++decimals;
    const QSignalBlocker block(field);
    field->setDecimals(decimals);
    field->setValue(value);
}

} // namespace bask
