#include "widgets/rig/axis_table.h"

#include "engine/model/rig_spec.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/rig/coordinate_words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <cmath>
#include <string_view>

namespace bask {
namespace {

constexpr std::string_view kLetters = "XYZABCR";
constexpr int kOriginDecimals = 3;

} // namespace

AxisTable::AxisTable(QWidget* parent)
    : QWidget(parent), m_axisLabel(new QLabel(this)), m_originLabel(new QLabel(this)) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(3, 1);
    grid->addWidget(m_axisLabel, 0, 1);
    grid->addWidget(m_originLabel, 0, 3);
    for (int k = 0; k < 6; ++k) {
        Row& row = m_rows[static_cast<std::size_t>(k)];
        row.letter = new QComboBox(this);
        row.letter->setObjectName(coordinateObjectName("axis", k));
        row.letter->addItem(QStringLiteral("\u2014"), 0);
        for (const char letter : kLetters)
            row.letter->addItem(QString(QLatin1Char(letter)), static_cast<int>(letter));
        row.reversed = new QCheckBox(this);
        row.reversed->setObjectName(coordinateObjectName("reversed", k));
        row.origin = new NumberField(this);
        row.origin->setObjectName(coordinateObjectName("origin", k));
        row.origin->setDecimals(kOriginDecimals);
        const double max = shownCoordinate(k, maxAxisOrigin(k));
        row.origin->setRange(-max, max);
        row.origin->setSuffix(coordinateSymbol(k));
        row.origin->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        grid->addWidget(new QLabel(coordinateWord(k), this), k + 1, 0);
        grid->addWidget(row.letter, k + 1, 1);
        grid->addWidget(row.reversed, k + 1, 2);
        grid->addWidget(row.origin, k + 1, 3);
        const auto showUse = [row] {
            const bool isUsed = row.letter->currentIndex() > 0;
            row.reversed->setEnabled(isUsed);
            row.origin->setEnabled(isUsed);
        };
        connect(row.letter, &QComboBox::currentIndexChanged, this, showUse);
        showUse();
    }
    retranslate();
}

void AxisTable::setAxes(const std::vector<AxisSpec>& axes) {
    for (Row& row : m_rows) {
        row.letter->setCurrentIndex(0);
        row.reversed->setChecked(false);
        row.origin->setValue(0.0);
        row.given = {};
    }
    for (const AxisSpec& axis : axes) {
        Row& row = m_rows.at(static_cast<std::size_t>(axis.coordinate));
        row.letter->setCurrentIndex(row.letter->findData(static_cast<int>(axis.letter)));
        row.reversed->setChecked(axis.reversed);
        row.origin->setValue(shownCoordinate(axis.coordinate, axis.origin));
        row.given = axis;
    }
}

std::vector<AxisSpec> AxisTable::axes() const {
    std::vector<AxisSpec> axes;
    for (const char letter : kLetters)
        for (int k = 0; k < 6; ++k) {
            const Row& row = m_rows[static_cast<std::size_t>(k)];
            if (row.letter->currentData().toInt() != static_cast<int>(letter))
                continue;
            const double given = shownCoordinate(k, row.given.origin);
            const bool isAsGiven =
                std::abs(row.origin->value() - given) <= 0.5 * std::pow(10.0, -kOriginDecimals);
            axes.push_back({letter, k, row.reversed->isChecked(),
                            isAsGiven ? row.given.origin : coordinateFromShown(k, row.origin->value())});
        }
    return axes;
}

void AxisTable::retranslate() {
    m_axisLabel->setText(tr("Axis"));
    m_originLabel->setText(tr("Where the axis reads zero"));
    for (int k = 0; k < 6; ++k) {
        const Row& row = m_rows[static_cast<std::size_t>(k)];
        const QString word = coordinateWord(k);
        nameChoice(row.letter, tr("Axis that drives %1").arg(word));
        row.reversed->setText(tr("reversed"));
        row.reversed->setAccessibleName(tr("The axis of %1 counts the other way").arg(word));
        row.origin->setAccessibleName(tr("%1 where its axis reads zero").arg(word));
    }
}

void AxisTable::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
