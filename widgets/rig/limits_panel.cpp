#include "widgets/rig/limits_panel.h"

#include "engine/base/units.h"
#include "engine/model/coordinate_range.h"
#include "engine/model/experiment_parameters.h"
#include "widgets/common/coordinate_field.h"
#include "widgets/common/display.h"
#include "widgets/common/evenness_words.h"
#include "widgets/common/labels.h"
#include "widgets/common/number_field.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/rig/coordinate_words.h"

#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>

namespace bask {
namespace {

constexpr int kMaxDecimals = 6;
constexpr std::array<std::string_view, 3> kMotion{"max_speed", "max_rotation", "clearance"};

} // namespace

LimitsPanel::LimitsPanel(QWidget* parent)
    : QWidget(parent), m_sourceTitle(boldLabel(this)), m_workspaceTitle(boldLabel(this)),
      m_speedTitle(boldLabel(this)), m_measuredLabel(new QLabel(this)), m_measured(new QLabel(this)),
      m_setPointLabel(new QLabel(this)), m_emittanceLabel(new QLabel(this)),
      m_evennessLabel(new QLabel(this)), m_evenness(new QLabel(this)), m_setPoint(new QuantitySpinBox(this)),
      m_lowerLabel(new QLabel(this)), m_upperLabel(new QLabel(this)), m_motion(new ParameterForm({}, this)) {
    m_measured->setObjectName("measuredSource");
    m_setPoint->setObjectName("sourceSetPoint");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_sourceTitle);
    layout->addWidget(buildSource());
    layout->addSpacing(6);
    layout->addWidget(m_workspaceTitle);
    layout->addWidget(buildWorkspace());
    layout->addSpacing(6);
    layout->addWidget(m_speedTitle);
    buildMotion();
    layout->addWidget(m_motion);
    layout->addStretch(1);
    retranslate();
}

QDoubleSpinBox* LimitsPanel::number(const QString& name, const ValidRange& range, int decimals,
                                    const QString& suffix, const Apply& apply) {
    QDoubleSpinBox* field = numberField(this, name, range.min, range.max, decimals, suffix);
    connect(field, &QDoubleSpinBox::valueChanged, this,
            [this, field, apply](double value) { edit(field, apply, value); });
    return field;
}

QWidget* LimitsPanel::buildSource() {
    auto* part = new QWidget(this);
    const ParameterFacts &temperature = parameterOf(sourceParameters(), &SourceSpec::temperature_K),
                         &emittance = parameterOf(sourceParameters(), &SourceSpec::emittance);
    m_setPoint->setRange_K(fromWritten(temperature, temperature.range.min),
                           fromWritten(temperature, temperature.range.max));
    const Apply setPoint = [](Experiment& e, double value_K) { e.source.temperature_K = value_K; };
    connect(m_setPoint, &QuantitySpinBox::valueEdited_K, this,
            [this, setPoint](double value_K) { edit(m_setPoint, setPoint, value_K); });
    m_emittance = number("sourceEmittance", emittance.range, emittance.decimals, {},
                         [](Experiment& e, double value) { e.source.emittance = value; });
    m_emittance->setSingleStep(0.01);
    auto* form = new QFormLayout(part);
    form->setContentsMargins(0, 0, 0, 0);
    form->addRow(m_measuredLabel, m_measured);
    form->addRow(m_setPointLabel, m_setPoint);
    form->addRow(m_emittanceLabel, m_emittance);
    m_evenness->setObjectName(QStringLiteral("sourceEvenness"));
    m_evenness->setWordWrap(true);
    form->addRow(m_evennessLabel, m_evenness);
    m_setPointLabel->setBuddy(m_setPoint);
    m_emittanceLabel->setBuddy(m_emittance);
    return part;
}

QWidget* LimitsPanel::buildWorkspace() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    grid->addWidget(m_lowerLabel, 0, 1);
    grid->addWidget(m_upperLabel, 0, 2);
    for (int k = 0; k < 6; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const QString name = QLatin1String(kCoordinateNames[i]);
        const ValidRange range = coordinateRange(k, kMaxPlace_cm, true);
        m_names[i] = new QLabel(coordinateWord(k), part);
        m_lower[i] = number(QStringLiteral("lower.") + name, range, 2, coordinateSymbol(k),
                            [k](Experiment& e, double v) { e.robot.lower[k] = coordinateFromShown(k, v); });
        m_upper[i] = number(QStringLiteral("upper.") + name, range, 2, coordinateSymbol(k),
                            [k](Experiment& e, double v) { e.robot.upper[k] = coordinateFromShown(k, v); });
        setCoordinateRange(*m_lower[i], k, range);
        setCoordinateRange(*m_upper[i], k, range);
        grid->addWidget(m_names[i], k + 1, 0);
        grid->addWidget(m_lower[i], k + 1, 1);
        grid->addWidget(m_upper[i], k + 1, 2);
    }
    return part;
}

void LimitsPanel::buildMotion() {
    for (const Parameter<RobotLimits>& parameter : robotParameters())
        if (std::ranges::find(kMotion, parameter.name) != kMotion.end())
            m_motion->addRow(parameter, false);
    connect(m_motion, &ParameterForm::edited, this,
            [this](const ParameterFacts* facts, std::optional<double> si, const QString& words) {
                Experiment changed = m_experiment;
                setParameter(robotParameters(), facts, changed.robot, si);
                emit edited(changed, words);
            });
}

void LimitsPanel::edit(QDoubleSpinBox* field, const Apply& apply, double value) {
    const QString wanted = field->text();
    Experiment changed = m_experiment;
    apply(changed, value);
    if (changed == m_experiment)
        return;
    showValues(); // as it is, until the change is taken
    emit edited(changed, tr("%1: %2 instead of %3").arg(field->accessibleName(), wanted, field->text()));
}

void LimitsPanel::setExperiment(const Experiment& experiment) {
    m_experiment = experiment;
    showValues();
}

void LimitsPanel::setMeasured(double source_K) {
    m_measured_K = source_K;
    if (const QString text = formatTemperature(source_K, m_unit); text != m_measured->text())
        m_measured->setText(text);
}

void LimitsPanel::setEditable(bool editable) {
    for (QAbstractSpinBox* field : findChildren<QAbstractSpinBox*>())
        field->setEnabled(editable);
    m_motion->setEditable(editable);
}

void LimitsPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    m_setPoint->setTemperatureUnit(unit);
    setMeasured(m_measured_K);
}

void LimitsPanel::showValues() {
    const RobotLimits& robot = m_experiment.robot;
    m_setPoint->setValue_K(m_experiment.source.temperature_K);
    setQuietly(m_emittance, m_experiment.source.emittance,
               parameterOf(sourceParameters(), &SourceSpec::emittance).decimals, kMaxDecimals);
    m_evenness->setText(evennessText(m_experiment));
    for (int k = 0; k < 6; ++k) {
        const auto i = static_cast<std::size_t>(k);
        setQuietly(m_lower[i], shownCoordinate(k, robot.lower[k]));
        setQuietly(m_upper[i], shownCoordinate(k, robot.upper[k]));
        for (QWidget* part : std::initializer_list<QWidget*>{m_names[i], m_lower[i], m_upper[i]})
            part->setVisible(robot.free[i]);
    }
    for (const Parameter<RobotLimits>& parameter : robotParameters())
        m_motion->setValue(parameter, parameter.get(robot));
}

void LimitsPanel::retranslate() {
    m_sourceTitle->setText(tr("Heat source"));
    m_measuredLabel->setText(tr("Measured temperature"));
    m_setPointLabel->setText(tr("Set point of runs"));
    m_setPoint->setAccessibleName(m_setPointLabel->text());
    m_emittanceLabel->setText(tr("Emittance"));
    m_evennessLabel->setText(tr("Evenness"));
    m_evenness->setText(evennessText(m_experiment));
    m_emittance->setAccessibleName(tr("Emittance of the source"));
    m_workspaceTitle->setText(tr("Workspace of the end-effector"));
    m_lowerLabel->setText(tr("From"));
    m_upperLabel->setText(tr("To"));
    for (int k = 0; k < 6; ++k) {
        const auto i = static_cast<std::size_t>(k);
        m_lower[i]->setAccessibleName(tr("Least %1").arg(coordinateWord(k)));
        m_upper[i]->setAccessibleName(tr("Largest %1").arg(coordinateWord(k)));
    }
    m_speedTitle->setText(tr("Limits of motion"));
}

void LimitsPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
