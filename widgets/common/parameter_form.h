#pragma once
// A form for a table of parameters: one row each, with label, unit, valid range and help.

#include "engine/base/parameter.h"
#include "engine/base/units.h"

#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;

namespace bask {

/// Returns the translated label and help of a parameter.
QString parameterLabel(const ParameterFacts& facts);
QString parameterHelp(const ParameterFacts& facts);
/// Returns a value (SI) in the parameter's unit with so many significant digits: "2700 kg/m³".
QString parameterText(const ParameterFacts& facts, double si, int digits);
/// Returns "heldLimit" for "held_limit": the end of an object's name.
QString parameterObjectName(const ParameterFacts& facts);

/// Each change by a person is one `edited`; the fields show the last setValue. A parameter that may be
/// automatic has a box *Automatic*. Object names: the prefix with parameterObjectName, and that with
/// "Automatic".
class ParameterForm : public QWidget {
    Q_OBJECT

public:
    explicit ParameterForm(const QString& prefix, QWidget* parent = nullptr);
    /// Adds its rows to `rows`, which may contain others; the widget itself is not visible.
    ParameterForm(const QString& prefix, QFormLayout& rows, QWidget* parent);

    void addRow(const ParameterFacts& facts, bool mayBeAutomatic);

    /// Empty `si`: automatic. A parameter without a row is ignored.
    void setValue(const ParameterFacts& facts, std::optional<double> si);
    /// Sets the value of an automatic parameter (empty if it varies: a dash is shown), and its value when a
    /// person makes it manual.
    void setAutomatic(const ParameterFacts& facts, std::optional<double> si, double takenOver);
    /// Hides or shows its row.
    void setShown(const ParameterFacts& facts, bool isShown);
    void setEditable(bool editable);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// Empty `si`: automatic was chosen. `words`: "Longest hold: 20 s instead of 15 s".
    void edited(const bask::ParameterFacts* facts, std::optional<double> si, const QString& words);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        const ParameterFacts* facts;
        QLabel* label;
        QDoubleSpinBox* field;
        QCheckBox* automatic; ///< null if a value is required
        QWidget* part;        ///< the field with its box
        std::optional<double> value{}, automaticValue{};
        double takenOver = 0.0;
    };
    QDoubleSpinBox* makeField(const ParameterFacts& facts, bool mayBeAutomatic);
    Row* rowOf(const ParameterFacts& facts);
    void tell(const ParameterFacts& facts, std::optional<double> si, const QString& wanted);
    void show(Row& row);
    void retranslate();

    QString m_prefix;
    QFormLayout* m_layout;
    std::vector<Row> m_rows;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_isEditable = true;
};

} // namespace bask
