#pragma once
// The form of one step of a recipe.

#include "engine/base/units.h"
#include "engine/recipe/recipe.h"

#include <QDialog>
#include <QStringList>

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;

namespace bask {

class QuantitySpinBox;

/// Object names: "recipeStepDialog", fields "until", "duration", "object", "temperature", "atMost",
/// "otherwise", buttons "stepOk", "stepCancel".
class RecipeStepDialog : public QDialog {
    Q_OBJECT

public:
    /// `objects`: names that are offered; others can be typed.
    RecipeStepDialog(const RecipeStep& step, const QStringList& objects, TemperatureUnit unit,
                     QWidget* parent = nullptr);

    RecipeStep step() const;

private:
    void addRow(const QString& label, QWidget* field, const char* name);
    void setDurationRange(RecipeStep::Until until);
    void showFields();

    RecipeStep m_step;                                          ///< the given step
    double m_shownDuration_s = 0.0, m_shownMaxDuration_s = 0.0; ///< its durations, rounded
    QFormLayout* m_form;
    QComboBox* m_until;
    QDoubleSpinBox* m_duration;
    QComboBox* m_object;
    QuantitySpinBox* m_temperature;
    QDoubleSpinBox* m_maxDuration;
    QComboBox* m_otherwise;
};

} // namespace bask
