#pragma once
// Fields for numbers with units.

#include <QDoubleSpinBox>
#include <QPointer>

#include <optional>

class QLabel;

namespace bask {

/// A number as a person typed it, and what stands after it.
struct TypedValue {
    double value = 0.0;
    QString unit;              ///< as it was typed; empty if there is none
    bool mayBeGrouped = false; ///< as "1,234" may be a thousand or 1.234
};

/// Reads a number as a person types or pastes it, with a point or a comma, with either minus sign, with
/// spaces between thousands, and with a unit after it or none; empty if the number is none.
std::optional<TypedValue> typedValue(const QString& text);

/// A number in the unit of its suffix. Anything can be typed: a number with another unit of the same
/// dimension is converted when it is entered; what is no number, may be one of two, has a unit of something
/// else, is too small for the field's digits or lies out of range is refused with words beside the field,
/// which stays as it was. Object name of these words: "fieldRefusal".
class NumberField : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberField(QWidget* parent = nullptr);

    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    void fixup(QString& text) const override;
    void stepBy(int steps) override;
    /// A percentage that is typed is this share of `whole`, as for an uncertainty of 2 %.
    void setShareOf(double whole) { m_shareOf = whole; }
    /// Whether a click on `widget` made the field refuse what was typed. Tells it once.
    bool takeRefusalBy(const QWidget* widget);
    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// What was typed is not taken; `why` is empty if nothing was typed.
    void refused(const QString& why) const;

protected:
    /// Returns a typed value in the unit of the suffix; empty if that has another dimension.
    virtual std::optional<double> inOwnUnit(const TypedValue& typed) const;
    /// Returns the number in the text of the field, with or without its suffix; empty if it cannot be taken.
    virtual std::optional<double> number(const QString& text) const;
    virtual QString whyNot(const QString& typed) const;
    bool isWithinRange(double value) const;
    /// Whether a value would be shown as zero, or as the words of the minimum, without being that.
    virtual bool isRoundedAway(double value) const;
    /// Takes or refuses what was typed into a field that takes numbers on the way. Returns false if refused.
    bool endTracking();
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    bool isAmbiguous(const TypedValue& typed) const;
    double roundedAsShown(double value) const;
    bool isShownInWords(double rounded) const;
    QString withoutSuffix(const QString& text) const;
    void say(const QString& why);
    void forgetRefusal();

    std::optional<double> m_shareOf;
    std::optional<double> m_beforeTracking; ///< the "41,5" of "41,5,5" may be taken on the way
    bool m_isRefused = false;               ///< by the key or the loss of focus that is handled
    QPointer<QWidget> m_refusedBy;
    QPointer<QLabel> m_refusal;
    std::optional<QString> m_ownDescription; ///< while the refusal is told in its place
};

/// A number without a fraction. What has the mark of one is refused, also 1.000, which may be a thousand.
class WholeNumberField : public NumberField {
    Q_OBJECT

public:
    explicit WholeNumberField(QWidget* parent = nullptr);

    int whole() const { return static_cast<int>(value()); }

protected:
    std::optional<double> number(const QString& text) const override;
    QString whyNot(const QString& typed) const override;
};

/// Makes a field that takes a number when it is entered, not while it is typed.
NumberField* numberField(QWidget* parent, const QString& name, double min, double max, int decimals,
                         const QString& suffix);
/// Sets a value without signals.
void setQuietly(QDoubleSpinBox* field, double value);
/// Sets a value without signals, with so many decimals, or with more, up to `maxDecimals`, where it is so
/// small that it would be shown as another.
void setQuietly(QDoubleSpinBox* field, double value, int decimals, int maxDecimals);

} // namespace bask
