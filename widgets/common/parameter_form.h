#pragma once
// A form over a table of parameters: a row each, with its label, unit, valid range and help.

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

/// Translated label and help of a parameter.
QString parameterLabel(const ParameterFacts& facts);
QString parameterHelp(const ParameterFacts& facts);
/// "heldLimit" of "held_limit": the end of an object's name.
QString parameterObjectName(const ParameterFacts& facts);

/// Each change by a person is one `edited`; the fields show what setValue gave last. A parameter that may be
/// left to the program has a box *Automatic*. Object names: the prefix with parameterObjectName, and that
/// with "Automatic".
class ParameterForm : public QWidget {
    Q_OBJECT

public:
    explicit ParameterForm(const QString& prefix, QWidget* parent = nullptr);
    /// Its rows are those of `rows`, among others; itself it is not seen.
    ParameterForm(const QString& prefix, QFormLayout& rows, QWidget* parent);

    void addRow(const ParameterFacts& facts, bool mayBeAutomatic);

    /// `si` empty: automatic. A row that is not there is ignored.
    void setValue(const ParameterFacts& facts, std::optional<double> si);
    /// What an automatic value amounts to (empty: it depends, a dash is shown), and what it becomes when a
    /// person takes it over.
    void setAutomatic(const ParameterFacts& facts, std::optional<double> si, double takenOver);
    /// Hides or shows its row.
    void setShown(const ParameterFacts& facts, bool isShown);
    void setEditable(bool editable);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// `si` empty: automatic is asked for. `words`: "Longest hold: 20 s instead of 15 s".
    void edited(const bask::ParameterFacts* facts, std::optional<double> si, const QString& words);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        const ParameterFacts* facts;
        QLabel* label;
        QDoubleSpinBox* field;
        QCheckBox* automatic; ///< null: there must be a value
        QWidget* part;        ///< the field, with its box
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
