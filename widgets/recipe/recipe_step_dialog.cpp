#include "widgets/recipe/recipe_step_dialog.h"

#include "widgets/common/dialog_frame.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/recipe/recipe_words.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace bask {

using Until = RecipeStep::Until;

namespace {

/// Milliseconds are kept, and shown where there are any.
class SecondsSpinBox : public NumberField {
public:
    explicit SecondsSpinBox(QWidget* parent) : NumberField(parent) {
        setDecimals(3);
        setSingleStep(10.0);
        setSuffix(QStringLiteral(" s"));
        setMinimumWidth(140);
    }

protected:
    QString textFromValue(double value) const override {
        QLocale plain = locale();
        plain.setNumberOptions(QLocale::OmitGroupSeparator);
        return plain.toString(value, 'f', QLocale::FloatingPointShortest);
    }
};

} // namespace

RecipeStepDialog::RecipeStepDialog(const RecipeStep& step, const QStringList& objects, TemperatureUnit unit,
                                   QWidget* parent)
    : QDialog(parent), m_step(step), m_form(new QFormLayout), m_until(new QComboBox(this)),
      m_duration(new SecondsSpinBox(this)), m_object(new QComboBox(this)),
      m_temperature(new QuantitySpinBox(this)), m_maxDuration(new SecondsSpinBox(this)),
      m_otherwise(new QComboBox(this)) {
    setObjectName(QStringLiteral("recipeStepDialog"));
    setWindowTitle(step.isRun() ? tr("Run %1").arg(stepWords(step)) : tr("Wait"));
    setAttribute(Qt::WA_DeleteOnClose);

    if (step.isRun())
        m_until->addItem(tr("All objects have settled"), static_cast<int>(Until::Settled));
    m_until->addItem(tr("A time has passed"), static_cast<int>(Until::Time));
    m_until->addItem(tr("An object is so hot or hotter"), static_cast<int>(Until::Above));
    m_until->addItem(tr("An object is so cold or colder"), static_cast<int>(Until::Below));
    m_until->setCurrentIndex(m_until->findData(static_cast<int>(step.until)));
    const ValidRange& limit = limitParameters(Until::Settled).front().range;
    m_maxDuration->setRange(limit.min, limit.max);
    setDurationRange(Until::Settled);
    m_duration->setValue(step.duration_s);
    m_maxDuration->setValue(step.maxDuration_s);
    m_shownDuration_s = m_duration->value();
    m_shownMaxDuration_s = m_maxDuration->value();
    m_object->setEditable(true);
    m_object->addItems(objects);
    if (!step.object.empty())
        m_object->setEditText(QString::fromStdString(step.object));
    m_temperature->setTemperatureUnit(unit);
    const ParameterFacts& hot = conditionParameters(Until::Above).front();
    m_temperature->setRange_K(fromWritten(hot, hot.range.min), fromWritten(hot, hot.range.max));
    m_temperature->setValue_K(step.temperature_K);
    m_otherwise->addItem(tr("End the recipe"), false);
    m_otherwise->addItem(tr("Go on with the next step"), true);
    m_otherwise->setCurrentIndex(step.goesOn ? 1 : 0);

    addRow(tr("Until"), m_until, "until");
    addRow(tr("For"), m_duration, "duration");
    addRow(tr("Object"), m_object, "object");
    nameChoice(m_object, tr("Object"));
    addRow(tr("Temperature"), m_temperature, "temperature");
    addRow(tr("At most"), m_maxDuration, "atMost");
    addRow(tr("Otherwise"), m_otherwise, "otherwise");
    m_otherwise->setToolTip(
        tr("Where the condition does not come in time, or the run cannot be begun. An alarm, a fault or a "
           "person's stop always ends the recipe."));

    dialogColumn(*this)->addLayout(m_form);
    const DialogButtons buttons = addDialogButtons(*this, tr("OK"));
    buttons.take->setObjectName(QStringLiteral("stepOk"));
    buttons.cancel->setObjectName(QStringLiteral("stepCancel"));
    connect(m_until, &QComboBox::currentIndexChanged, this, &RecipeStepDialog::showFields);
    showFields();
}

void RecipeStepDialog::addRow(const QString& label, QWidget* field, const char* name) {
    field->setObjectName(QLatin1String(name));
    field->setAccessibleName(label);
    m_form->addRow(label, field);
}

void RecipeStepDialog::setDurationRange(Until until) {
    const ValidRange& range = conditionParameters(until).front().range;
    m_duration->setRange(range.min, range.max);
}

void RecipeStepDialog::showFields() {
    const auto until = static_cast<Until>(m_until->currentData().toInt());
    const bool isOfObject = until == Until::Above || until == Until::Below;
    m_form->setRowVisible(m_duration, !isOfObject);
    m_form->setRowVisible(m_object, isOfObject);
    m_form->setRowVisible(m_temperature, isOfObject);
    m_form->setRowVisible(m_maxDuration, until != Until::Time);
    setDurationRange(isOfObject ? Until::Settled : until);
    adjustSize();
}

/// What nobody has changed stays as it was given, with more digits than are shown.
RecipeStep RecipeStepDialog::step() const {
    RecipeStep made = m_step;
    made.until = static_cast<Until>(m_until->currentData().toInt());
    if (m_duration->value() != m_shownDuration_s)
        made.duration_s = m_duration->value();
    made.duration_s = std::max(made.duration_s, m_duration->minimum());
    if (m_maxDuration->value() != m_shownMaxDuration_s)
        made.maxDuration_s = m_maxDuration->value();
    if (made.until == Until::Above || made.until == Until::Below) {
        made.object = m_object->currentText().trimmed().toStdString();
        made.temperature_K = m_temperature->value_K();
    }
    made.goesOn = m_otherwise->currentData().toBool();
    return made;
}

} // namespace bask
