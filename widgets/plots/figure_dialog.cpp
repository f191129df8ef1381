#include "widgets/plots/figure_dialog.h"

#include "widgets/common/dialog_frame.h"
#include "widgets/common/number_field.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <utility>

namespace bask {

FigureDialog::FigureDialog(const FigureLayout& layout, QWidget* parent)
    : QDialog(parent), m_columns(new QComboBox(this)),
      m_width(numberField(this, QStringLiteral("figureWidth"), kNarrowest_mm, kWidest_mm, 0, tr(" mm"))),
      m_heading(new QCheckBox(tr("With a &heading"), this)) {
    setWindowTitle(tr("Size of the figure"));
    m_columns->setObjectName("figureColumns");
    m_heading->setObjectName("figureHeading");
    for (const auto& [name, width_mm] : {std::pair{tr("One column: %1 mm"), kOneColumn_mm},
                                         std::pair{tr("Two columns: %1 mm"), kTwoColumns_mm}})
        m_columns->addItem(name.arg(width_mm), width_mm);
    m_columns->addItem(tr("Another"));
    setQuietly(m_width, layout.width_mm);
    findWidth();
    m_heading->setChecked(layout.hasHeading);
    m_heading->setToolTip(tr("Title, names of the files and marked moments. Without it, a simulated run is "
                             "called so in the corner."));
    connect(m_columns, &QComboBox::activated, this, &FigureDialog::choose);
    connect(m_width, &QDoubleSpinBox::valueChanged, this, &FigureDialog::findWidth);

    auto* form = new QFormLayout;
    form->addRow(tr("&Size on paper"), m_columns);
    form->addRow(tr("&Width"), m_width);
    auto* note = new QLabel(tr("The letters have 7 to 9 points at any width."), this);
    QVBoxLayout* column = dialogColumn(*this);
    column->addLayout(form);
    column->addWidget(note);
    column->addWidget(m_heading);
    addDialogButtons(*this, tr("Choose the place\u2026"));
}

FigureLayout FigureDialog::chosen() const {
    return {m_width->value(), m_heading->isChecked()};
}

void FigureDialog::choose() {
    const QVariant width_mm = m_columns->currentData();
    if (!width_mm.isValid())
        return m_width->setFocus();
    setQuietly(m_width, width_mm.toDouble());
}

/// Shows in the list what is typed.
void FigureDialog::findWidth() {
    const int known = m_columns->findData(m_width->value());
    m_columns->setCurrentIndex(known < 0 ? m_columns->count() - 1 : known);
}

} // namespace bask
