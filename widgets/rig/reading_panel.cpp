#include "widgets/rig/reading_panel.h"

#include "widgets/common/labels.h"

#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace bask {

ReadingPanel::ReadingPanel(QWidget* parent)
    : QWidget(parent), m_title(boldLabel(this)), m_note(new QLabel(this)), m_grid(new QGridLayout) {
    m_note->setObjectName("readByNote");
    m_note->setWordWrap(true);
    m_grid->setHorizontalSpacing(12);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(1, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_title);
    layout->addLayout(m_grid);
    layout->addWidget(m_note);
    retranslate();
}

void ReadingPanel::setExperiment(const Experiment& experiment) {
    m_names.clear();
    m_readBy.clear();
    for (const ObjectSpec& object : experiment.objects) {
        m_names.push_back(object.name);
        m_readBy.push_back(object.readBy);
    }
    m_isPoseUnknown = readsByCamera(experiment) && experiment.rig && experiment.rig->thermalCamera &&
                      !experiment.rig->thermalCamera->calibration.pose;
    refresh();
}

void ReadingPanel::setEditable(bool editable) {
    for (const Row& row : m_rows)
        row.readBy->setEnabled(editable);
}

void ReadingPanel::addRow() {
    const auto index = static_cast<int>(m_rows.size());
    Row row{new QLabel(this), new QComboBox(this)};
    row.name->setTextFormat(Qt::PlainText);
    row.readBy->setObjectName(QStringLiteral("readBy.%1").arg(index));
    for (int k = 0; k < 3; ++k)
        row.readBy->addItem(QString());
    m_grid->addWidget(row.name, index, 0);
    m_grid->addWidget(row.readBy, index, 1, Qt::AlignLeft);
    connect(row.readBy, &QComboBox::activated, this, [this, index](int choice) {
        emit chosen(static_cast<std::size_t>(index), static_cast<ReadBy>(choice));
        refresh(); // as it is, if it was refused
    });
    m_rows.push_back(row);
}

void ReadingPanel::refresh() {
    const std::size_t before = m_rows.size();
    while (m_rows.size() < m_names.size())
        addRow();
    if (m_rows.size() > before)
        retranslate();
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool isThere = i < m_names.size();
        m_rows[i].name->setVisible(isThere);
        m_rows[i].readBy->setVisible(isThere);
        if (!isThere)
            continue;
        m_rows[i].name->setText(QString::fromStdString(m_names[i]));
        nameChoice(m_rows[i].readBy, tr("Temperature of %1").arg(m_rows[i].name->text()));
        m_rows[i].readBy->setCurrentIndex(static_cast<int>(m_readBy[i]));
    }
    m_note->setVisible(m_isPoseUnknown);
}

void ReadingPanel::retranslate() {
    m_title->setText(tr("Temperatures by"));
    m_note->setText(tr("The pose of the thermal camera is not known, so it reads nothing: set it up."));
    for (const Row& row : m_rows) {
        row.readBy->setItemText(0, tr("Sensor on the object"));
        row.readBy->setItemText(1, tr("Thermal camera"));
        row.readBy->setItemText(2, tr("Sensor, checked by the thermal camera"));
    }
}

void ReadingPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        refresh();
    }
}

} // namespace bask
