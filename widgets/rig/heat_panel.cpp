#include "widgets/rig/heat_panel.h"

#include "widgets/common/device_words.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/rig/way_up_question.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace bask {

HeatPanel::HeatPanel(QWidget* parent)
    : QWidget(parent), m_setPointLabel(new QLabel(this)), m_typedLabel(new QLabel(this)),
      m_mark(new QLabel(this)), m_state(new QLabel(this)), m_setPoint(new QuantitySpinBox(this)),
      m_typed(new QuantitySpinBox(this)), m_on(new QPushButton(this)), m_off(new QPushButton(this)),
      m_take(new QPushButton(this)) {
    m_setPoint->setObjectName("heatSetPoint");
    m_typed->setObjectName("typedSource");
    m_on->setObjectName("heatOn");
    m_off->setObjectName("heatOff");
    m_take->setObjectName("takeTyped");
    m_state->setObjectName("heatState");
    m_state->setWordWrap(true);
    for (QuantitySpinBox* field : {m_setPoint, m_typed})
        field->setRange_K(kMinTemperature_degC + kZeroCelsius_K, kMaxTemperature_degC + kZeroCelsius_K);
    m_setPointLabel->setBuddy(m_setPoint);
    m_typedLabel->setBuddy(m_typed);
    const auto row = [](std::initializer_list<QWidget*> parts) {
        auto* made = new QHBoxLayout;
        for (QWidget* part : parts)
            made->addWidget(part);
        made->addStretch(1);
        return made;
    };
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* state = new QHBoxLayout;
    state->setSpacing(6);
    state->addWidget(m_mark, 0, Qt::AlignTop);
    state->addWidget(m_state, 1);
    layout->addLayout(state);
    layout->addLayout(row({m_setPointLabel, m_setPoint, m_on, m_off}));
    layout->addLayout(row({m_typedLabel, m_typed, m_take}));
    connect(m_on, &QPushButton::clicked, this, &HeatPanel::heat);
    connect(m_off, &QPushButton::clicked, this, [this] { emit commandWanted(SetHeat{}); });
    connect(m_take, &QPushButton::clicked, this,
            [this] { emit commandWanted(TypeSourceTemperature{m_typed->value_K()}); });
    retranslate();
}

void HeatPanel::setUsual(double setPoint_K) {
    if (setPoint_K == m_usual_K)
        return;
    m_usual_K = setPoint_K;
    m_setPoint->setValue_K(setPoint_K);
    m_typed->setValue_K(setPoint_K);
}

void HeatPanel::apply(const Snapshot& snapshot, bool mayHeat) {
    m_last.simulated = snapshot.simulated;
    m_last.heat = snapshot.heat;
    m_last.alarms = snapshot.alarms;
    m_last.source_K = snapshot.source_K;
    m_last.latest.source_K = snapshot.latest.source_K;
    m_last.sourceAge_s = snapshot.sourceAge_s;
    m_last.heatSetPoint_K = snapshot.heatSetPoint_K;
    m_last.isSourceManual = snapshot.isSourceManual;
    m_mayHeat = mayHeat;
    showState();
}

void HeatPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_setPoint->setTemperatureUnit(unit);
    m_typed->setTemperatureUnit(unit);
    showState();
}

void HeatPanel::heat() {
    const double wanted_K = m_setPoint->value_K();
    const bool isMore = !m_last.heatSetPoint_K || wanted_K > *m_last.heatSetPoint_K;
    if (!m_last.simulated && isMore)
        return ask(wanted_K);
    emit commandWanted(SetHeat{wanted_K});
}

void HeatPanel::ask(double setPoint_K) {
    askOnTheWayUp(
        this, "heatQuestion", tr("Heat the source"),
        tr("The source heats towards %1 until it is switched off. Is nothing on it or near it that must not "
           "get hot?")
            .arg(formatTemperature(setPoint_K, m_unit)),
        tr("Heat"), [this, setPoint_K] { emit commandWanted(SetHeat{setPoint_K}); });
}

void HeatPanel::showState() {
    const bool isManual = m_last.isSourceManual;
    for (QWidget* part : std::initializer_list<QWidget*>{m_setPointLabel, m_setPoint, m_on, m_off})
        part->setVisible(!isManual);
    for (QWidget* part : std::initializer_list<QWidget*>{m_typedLabel, m_typed, m_take})
        part->setVisible(isManual);
    m_on->setEnabled(m_mayHeat);
    m_setPoint->setEnabled(m_mayHeat);
    const QString now = sourceReadingText(m_last, m_unit);
    const ShownHeat heat = shownHeat(m_last);
    const bool isUnknown = heat == ShownHeat::Unknown;
    const int priority = heatPriority(heat);
    QString text;
    if (isManual)
        text = tr("A person keeps the source hot: %1 as typed last.").arg(now);
    else if (isUnknown && m_last.heatSetPoint_K)
        text = tr("UNKNOWN whether it heats: it was asked to heat towards %1. Last seen: %2.")
                   .arg(formatTemperature(*m_last.heatSetPoint_K, m_unit), now);
    else if (isUnknown)
        text = tr("UNKNOWN whether it heats. Last seen: %1. Take it for hot.").arg(now);
    else if (heat == ShownHeat::Unasked)
        text = tr("It heats though its heat is off: %1 now. Switch it off at its mains.").arg(now);
    else if (m_last.heatSetPoint_K)
        text = tr("Heating towards %1: %2 now.").arg(formatTemperature(*m_last.heatSetPoint_K, m_unit), now);
    else if (heat == ShownHeat::On)
        text = tr("The heat is on: %1 now.").arg(now);
    else if (m_last.simulated)
        text = tr("The heat is off: %1 now, behind the closed shutter of the simulated source.").arg(now);
    else
        text = tr("The heat is off: %1 now.").arg(now);
    if (priority > 0)
        showAlarmed(m_mark, m_state, priority);
    else
        showUnknown(m_mark, m_state, isUnknown);
    if (text != m_state->text())
        m_state->setText(text);
}

void HeatPanel::retranslate() {
    m_setPointLabel->setText(tr("Set point"));
    m_setPoint->setAccessibleName(tr("Set point of the source"));
    m_on->setText(tr("Heat"));
    m_on->setToolTip(tr("Heat the source until it is switched off"));
    m_off->setText(tr("Heat off"));
    m_typedLabel->setText(tr("Measured by you"));
    m_typed->setAccessibleName(tr("Temperature of the source as you measured it"));
    m_take->setText(tr("Take"));
    showState();
}

void HeatPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    else if (event->type() == QEvent::PaletteChange)
        showState();
}

} // namespace bask
