#include "widgets/common/parameter_form.h"

#include "widgets/common/display.h"
#include "widgets/common/number_field.h"
#include "widgets/common/quantity_spin_box.h"

#include <QCheckBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>

namespace bask {
namespace {

bool isTemperature(const ParameterFacts& facts) {
    return facts.unit.edge == EdgeUnit::Temperature;
}

} // namespace

QString parameterLabel(const ParameterFacts& facts) {
    return QCoreApplication::translate("Parameter", facts.label);
}

QString parameterHelp(const ParameterFacts& facts) {
    return *facts.help == '\0' ? QString() : QCoreApplication::translate("Parameter", facts.help);
}

QString parameterText(const ParameterFacts& facts, double si, int digits) {
    const QString unit = QString::fromUtf8(facts.unit.symbol);
    return QLocale().toString(si * facts.unit.symbolPerSi, 'g', digits) +
           (unit.isEmpty() ? QString() : QChar(0x00a0) + unit);
}

QString parameterObjectName(const ParameterFacts& facts) {
    QString out;
    for (const QString& word : QString::fromLatin1(facts.name).split(u'_'))
        out += out.isEmpty() ? word : word.left(1).toUpper() + word.mid(1);
    return out;
}

ParameterForm::ParameterForm(const QString& prefix, QWidget* parent)
    : QWidget(parent), m_prefix(prefix), m_layout(new QFormLayout(this)) {
    m_layout->setContentsMargins(0, 0, 0, 0);
    m_layout->setRowWrapPolicy(QFormLayout::WrapLongRows);
}

ParameterForm::ParameterForm(const QString& prefix, QFormLayout& rows, QWidget* parent)
    : QWidget(parent), m_prefix(prefix), m_layout(&rows) {
    hide();
}

void ParameterForm::addRow(const ParameterFacts& facts, bool mayBeAutomatic) {
    auto* label = new QLabel(this);
    QDoubleSpinBox* field = makeField(facts, mayBeAutomatic);
    label->setBuddy(field);
    QWidget* part = field;
    QCheckBox* automatic = nullptr;
    if (mayBeAutomatic) {
        part = new QWidget(this);
        automatic = new QCheckBox(part);
        automatic->setObjectName(field->objectName() + QStringLiteral("Automatic"));
        auto* row = new QHBoxLayout(part);
        row->setContentsMargins(0, 0, 0, 0);
        row->addWidget(field, 1);
        row->addWidget(automatic);
        connect(automatic, &QCheckBox::clicked, this, [this, &facts](bool isAutomatic) {
            if (isAutomatic)
                tell(facts, std::nullopt, tr("automatic"));
            else
                tell(facts, rowOf(facts)->takenOver, {});
        });
    }
    if (m_layout->parentWidget() != this) // a number among wider fields
        field->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
    m_layout->addRow(label, part);
    m_rows.push_back({&facts, label, field, automatic, part});
    retranslate();
}

QDoubleSpinBox* ParameterForm::makeField(const ParameterFacts& facts, bool mayBeAutomatic) {
    const QString name = m_prefix + parameterObjectName(facts);
    const double min = fromWritten(facts, facts.range.min), max = fromWritten(facts, facts.range.max);
    if (isTemperature(facts)) {
        auto* field = new QuantitySpinBox(this);
        field->setObjectName(name);
        field->setRange_K(min, max);
        connect(field, &QuantitySpinBox::valueEdited_K, this,
                [this, &facts, field](double value_K) { tell(facts, value_K, field->text()); });
        return field;
    }
    const QString symbol = QString::fromUtf8(facts.unit.symbol);
    const double scale = facts.unit.symbolPerSi;
    QDoubleSpinBox* field = numberField(this, name, min * scale, max * scale, facts.decimals,
                                        symbol.isEmpty() ? symbol : QChar(0x00a0) + symbol);
    if (mayBeAutomatic)
        field->setSpecialValueText(kNoValue); // at the lowest value, which is not valid itself
    connect(field, &QDoubleSpinBox::valueChanged, this,
            [this, &facts, field, scale](double value) { tell(facts, value / scale, field->text()); });
    return field;
}

ParameterForm::Row* ParameterForm::rowOf(const ParameterFacts& facts) {
    const auto row = std::ranges::find(m_rows, &facts, &Row::facts);
    return row == m_rows.end() ? nullptr : &*row;
}

void ParameterForm::tell(const ParameterFacts& facts, std::optional<double> si, const QString& wanted) {
    Row& row = *rowOf(facts);
    if (si == row.value)
        return;
    const std::optional<double> before = row.value;
    QString words = wanted;
    if (words.isEmpty()) { // as the field will show it
        row.value = si;
        show(row);
        words = row.field->text();
        row.value = before;
    }
    show(row); // as it is, until the change is taken
    emit edited(&facts, si,
                tr("%1: %2 instead of %3").arg(row.field->accessibleName(), words, row.field->text()));
}

void ParameterForm::setValue(const ParameterFacts& facts, std::optional<double> si) {
    if (Row* row = rowOf(facts)) {
        row->value = si;
        show(*row);
    }
}

void ParameterForm::setAutomatic(const ParameterFacts& facts, std::optional<double> si, double takenOver) {
    if (Row* row = rowOf(facts)) {
        row->automaticValue = si;
        row->takenOver = takenOver;
        show(*row);
    }
}

void ParameterForm::setShown(const ParameterFacts& facts, bool isShown) {
    if (Row* row = rowOf(facts)) {
        row->label->setVisible(isShown);
        row->part->setVisible(isShown);
    }
}

void ParameterForm::setEditable(bool editable) {
    m_isEditable = editable;
    for (Row& row : m_rows)
        show(row);
}

void ParameterForm::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    for (Row& row : m_rows) {
        if (isTemperature(*row.facts))
            static_cast<QuantitySpinBox*>(row.field)->setTemperatureUnit(unit);
        show(row);
    }
}

void ParameterForm::show(Row& row) {
    const std::optional<double> shown = row.value ? row.value : row.automaticValue;
    if (isTemperature(*row.facts))
        static_cast<QuantitySpinBox*>(row.field)->setValue_K(shown.value_or(0.0));
    else
        setQuietly(row.field, shown ? *shown * row.facts->unit.symbolPerSi : row.field->minimum());
    row.field->setEnabled(m_isEditable && (row.value || row.automatic == nullptr));
    if (row.automatic == nullptr)
        return;
    row.automatic->setChecked(!row.value);
    row.automatic->setEnabled(m_isEditable);
}

void ParameterForm::retranslate() {
    for (Row& row : m_rows) {
        const QString label = parameterLabel(*row.facts);
        row.label->setText(label);
        row.field->setAccessibleName(label);
        row.field->setToolTip(parameterHelp(*row.facts));
        if (row.automatic == nullptr)
            continue;
        row.automatic->setText(tr("Automatic"));
        row.automatic->setAccessibleName(tr("%1: automatic").arg(label));
    }
}

void ParameterForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
