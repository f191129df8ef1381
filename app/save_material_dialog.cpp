#include "app/save_material_dialog.h"

#include "app/error_text.h"
#include "widgets/common/dialog_frame.h"
#include "widgets/common/display.h"
#include "widgets/common/number_field.h"
#include "widgets/common/parameter_form.h"

#include <QDate>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr int kNameCharacters = 36;

} // namespace

SaveMaterialDialog::SaveMaterialDialog(const Material& values, const MaterialLibrary& library,
                                       const QDate& today, QWidget* parent)
    : QDialog(parent), m_values(values), m_library(library), m_name(new QLineEdit(this)),
      m_source(new QLineEdit(this)), m_problem(new QLabel(this)), m_take(nullptr) {
    setObjectName(QStringLiteral("saveMaterialDialog"));
    setWindowTitle(tr("Save as material"));
    setAttribute(Qt::WA_DeleteOnClose);
    m_values.date = today.toString(Qt::ISODate).toStdString();
    const Material* known = materialNamed(m_library, values.name);
    if (known != nullptr && values.uncertainties.empty() && haveSameValues(*known, values))
        m_values.uncertainties = known->uncertainties; // an experiment of before it kept them
    m_name->setObjectName(QStringLiteral("materialName"));
    m_name->setText(QString::fromStdString(values.name));
    m_name->setMinimumWidth(kNameCharacters * fontMetrics().averageCharWidth());
    m_source->setObjectName(QStringLiteral("materialSource"));
    m_source->setText(QString::fromStdString(values.source));
    m_source->setPlaceholderText(tr("measured on a sample, data sheet, book"));
    auto* form = new QFormLayout;
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("Source"), m_source);
    auto* heading = new QLabel(tr("Values, with their standard uncertainties"), this);
    form->addRow(heading);
    for (const Parameter<Material>& value : materialParameters())
        form->addRow(parameterLabel(value), uncertaintyRow(value));
    m_problem->setObjectName(QStringLiteral("materialProblem"));
    m_problem->setWordWrap(true);

    QVBoxLayout* column = dialogColumn(*this);
    column->addLayout(form);
    column->addWidget(m_problem);
    m_take = addDialogButtons(*this, tr("Save")).take;
    m_take->setObjectName(QStringLiteral("takeMaterial"));
    connect(m_name, &QLineEdit::textChanged, this, &SaveMaterialDialog::check);
    connect(m_source, &QLineEdit::textChanged, this, &SaveMaterialDialog::check);
    m_name->setFocus();
    m_name->selectAll();
    check();
}

QWidget* SaveMaterialDialog::uncertaintyRow(const Parameter<Material>& value) {
    const double scale = value.unit.symbolPerSi;
    const QString unit = QString::fromUtf8(value.unit.symbol);
    const QString suffix = unit.isEmpty() ? QString() : QChar(0x00a0) + unit;
    auto* row = new QWidget(this);
    const double of = value.get(m_values).value();
    auto* said = new QLabel(parameterText(value, of, 6) + QStringLiteral(" \u00b1"), row);
    NumberField* field = numberField(row, QStringLiteral("uncertainty_") + parameterObjectName(value), 0.0,
                                     fromWritten(value, value.range.max) * scale, value.decimals + 1, suffix);
    field->setSpecialValueText(tr("not known"));
    field->setShareOf(of * scale);
    field->setToolTip(tr("As it is, or as a share of the value: 2 %"));
    field->setAccessibleName(tr("Standard uncertainty: %1").arg(parameterLabel(value)));
    if (const auto found = m_values.uncertainties.find(value.name); found != m_values.uncertainties.end())
        field->setValue(found->second * scale);
    m_uncertainties.emplace_back(&value, field);
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(said, 1, Qt::AlignRight);
    layout->addWidget(field);
    return row;
}

Material SaveMaterialDialog::material() const {
    Material out = m_values;
    out.name = m_name->text().trimmed().toStdString();
    out.source = m_source->text().trimmed().toStdString();
    out.uncertainties.clear();
    for (const auto& [value, field] : m_uncertainties)
        if (field->value() > 0.0)
            out.uncertainties[value->name] = field->value() / value->unit.symbolPerSi;
    return out;
}

void SaveMaterialDialog::check() {
    const Material asked = material();
    const bool isNamed = !asked.name.empty();
    const auto valid = validate(MaterialLibrary{asked});
    const bool isKnown = isNamed && materialNamed(m_library, asked.name) != nullptr;
    QString said;
    if (isNamed && !valid)
        said = asSentence(sentence(valid.error().message));
    else if (isKnown)
        said = tr("The library has a material of this name. Its values are replaced.");
    m_problem->setText(said);
    m_problem->setVisible(!said.isEmpty());
    m_take->setText(isKnown ? tr("Replace") : tr("Save"));
    m_take->setEnabled(isNamed && valid.ok());
}

} // namespace bask
