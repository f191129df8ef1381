#include "app/labels_dialog.h"

#include "app/error_text.h"
#include "widgets/common/dialog_frame.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr int kFieldWidth = 260;

} // namespace

LabelsDialog::LabelsDialog(const Content& content, QWidget* parent)
    : QDialog(parent), m_operator(new QComboBox(this)), m_sample(new QLineEdit(this)),
      m_batch(new QLineEdit(this)), m_ask(new QCheckBox(this)), m_problem(new QLabel(this)), m_take(nullptr) {
    setObjectName(QStringLiteral("labelsDialog"));
    setWindowTitle(content.isBeforeArm ? tr("Before the run") : tr("Operator and sample"));
    setAttribute(Qt::WA_DeleteOnClose);

    m_operator->setObjectName(QStringLiteral("operatorName"));
    m_operator->setEditable(true);
    m_operator->setInsertPolicy(QComboBox::NoInsert);
    m_operator->addItems(content.operators);
    m_operator->setCurrentText(QString::fromStdString(content.labels.operatorName));
    m_operator->setMinimumWidth(kFieldWidth);
    m_sample->setObjectName(QStringLiteral("sampleName"));
    m_sample->setText(QString::fromStdString(content.labels.sample));
    m_batch->setObjectName(QStringLiteral("batchName"));
    m_batch->setText(QString::fromStdString(content.labels.batch));
    for (QLineEdit* field : {m_sample, m_batch}) {
        field->setEnabled(!content.isRunOn);
        field->setToolTip(content.isRunOn ? tr("The run that is on has it; it can be changed after the run.")
                                          : QString());
    }
    auto* form = new QFormLayout;
    nameChoice(m_operator, tr("Operator"));
    form->addRow(tr("Operator"), m_operator);
    form->addRow(tr("Sample"), m_sample);
    form->addRow(tr("Batch"), m_batch);

    auto* meaning = new QLabel(this);
    meaning->setWordWrap(true);
    meaning->setText(tr("Recordings, reports and the list of runs show them. Each command, note and "
                        "acknowledgement is recorded with its operator."));
    m_ask->setObjectName(QStringLiteral("askLabels"));
    m_ask->setText(tr("Ask at each Arm"));
    m_ask->setChecked(content.isAskedAlways);
    m_problem->setObjectName(QStringLiteral("labelsProblem"));
    m_problem->setWordWrap(true);
    m_problem->hide();

    QVBoxLayout* column = dialogColumn(*this);
    column->addLayout(form);
    column->addWidget(m_ask);
    column->addWidget(meaning);
    column->addWidget(m_problem);
    m_take = addDialogButtons(*this, content.isBeforeArm ? tr("Arm") : tr("OK")).take;
    m_take->setObjectName(QStringLiteral("takeLabels"));
    connect(m_operator, &QComboBox::editTextChanged, this, &LabelsDialog::check);
    connect(m_sample, &QLineEdit::textChanged, this, &LabelsDialog::check);
    connect(m_batch, &QLineEdit::textChanged, this, &LabelsDialog::check);
    m_operator->setFocus();
    check();
}

RunLabels LabelsDialog::labels() const {
    return {m_operator->currentText().trimmed().toStdString(), m_sample->text().trimmed().toStdString(),
            m_batch->text().trimmed().toStdString()};
}

bool LabelsDialog::isAskedAlways() const {
    return m_ask->isChecked();
}

void LabelsDialog::check() {
    const auto valid = validate(labels());
    m_problem->setText(valid ? QString() : asSentence(sentence(valid.error().message)));
    m_problem->setVisible(!valid);
    m_take->setEnabled(valid.ok());
}

} // namespace bask
