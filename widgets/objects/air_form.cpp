#include "widgets/objects/air_form.h"

#include "engine/model/experiment_parameters.h"
#include "engine/model/experiment_rig.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace bask {
namespace {

enum AirKind { kAirUnknown, kAirGiven, kAirNatural, kAirKinds };
constexpr double kUsualConvection_W_m2K = 5.0; ///< of a small plate in calm air

AirKind kindOf(const Air& air) {
    return air.isNatural ? kAirNatural : air.convection_W_m2K ? kAirGiven : kAirUnknown;
}

double convectionAt_W_m2K(const ObjectSpec& object, Surroundings surroundings, const Air& air) {
    surroundings.air = air;
    return heatRates(object, surroundings).air.coefficient_1_s(object.target_K) *
           object.material.arealHeatCapacity_J_m2K();
}

} // namespace

AirForm::AirForm(QWidget* parent) : QWidget(parent), m_heading(boldLabel(this)) {
    m_kindCaption = new QLabel(this);
    m_kind = new QComboBox(this);
    m_kind->setObjectName("airKind");
    m_kind->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    for (int kind = 0; kind < kAirKinds; ++kind)
        m_kind->addItem({});
    m_kindCaption->setBuddy(m_kind);
    connect(m_kind, &QComboBox::activated, this, &AirForm::choose);
    const auto told = [this](const char* name) {
        auto* label = new QLabel(this);
        label->setObjectName(QString::fromLatin1(name));
        label->setWordWrap(true);
        return label;
    };
    m_takes = told("airTakes");
    m_simulated = told("airSimulated");

    auto* rows = new QFormLayout;
    rows->setRowWrapPolicy(QFormLayout::WrapAllRows);
    rows->setVerticalSpacing(3);
    rows->addRow(m_kindCaption, m_kind);
    m_form = new ParameterForm("air.", *rows, this);
    for (const Parameter<Air>& parameter : airParameters())
        m_form->addRow(parameter, false);
    connect(m_form, &ParameterForm::edited, this,
            [this](const ParameterFacts* facts, std::optional<double> si) {
                Air air = m_air;
                setParameter(airParameters(), facts, air, si);
                emit airEdited(air);
            });
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(2, 10, 8, 4);
    layout->setSpacing(3);
    layout->addWidget(m_heading);
    layout->addLayout(rows);
    layout->addWidget(m_takes);
    layout->addWidget(m_simulated);
    retranslate();
}

void AirForm::setExperiment(const Experiment& experiment, int object) {
    m_air = experiment.air;
    m_surroundings = surroundingsOf(experiment);
    m_object.reset();
    if (object >= 0)
        m_object = experiment.objects[static_cast<std::size_t>(object)];
    m_simulation.reset();
    if (!experiment.rig)
        m_simulation = experiment.simulation;
    show();
}

void AirForm::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    show();
}

void AirForm::setReadOnly(bool readOnly) {
    m_kind->setEnabled(!readOnly);
    m_form->setEditable(!readOnly);
}

/// A given h begins with what the correlation says for the object at its target.
void AirForm::choose(int kind) {
    if (kind == kindOf(m_air))
        return;
    Air air;
    air.isNatural = kind == kAirNatural;
    if (kind == kAirGiven)
        air.convection_W_m2K =
            m_object ? std::round(10.0 * convectionAt_W_m2K(*m_object, m_surroundings, {{}, true})) / 10.0
                     : kUsualConvection_W_m2K;
    show(); // as it is, until the change is taken
    emit airEdited(air);
}

void AirForm::show() {
    const QSignalBlocker block(m_kind);
    m_kind->setCurrentIndex(kindOf(m_air));
    for (const Parameter<Air>& parameter : airParameters()) {
        m_form->setValue(parameter, parameter.get(m_air));
        m_form->setShown(parameter, kindOf(m_air) == kAirGiven);
    }
    m_takes->setText(lossText());
    m_takes->setVisible(!m_takes->text().isEmpty());
    m_simulated->setVisible(m_simulation.has_value());
    if (!m_simulation)
        return;
    m_simulated->setText(m_simulation->naturalConvection
                             ? tr("The simulated rig has natural convection.")
                             : tr("The simulated rig has h = %1 W/(m\u00b2 K).")
                                   .arg(QLocale().toString(m_simulation->convection_W_m2K, 'g', 4)));
}

/// Of the loss at the target, radiation's less what the room gives.
QString AirForm::lossText() const {
    if (!m_object || !(shapeArea(m_object->shape) > 0.0))
        return {};
    Surroundings surroundings = m_surroundings;
    if (!m_air.isKnown())
        surroundings.air.isNatural = true;
    const HeatRates rates = heatRates(*m_object, surroundings);
    const double air_K_s = rates.air.rate_K_s(m_object->target_K);
    const double share = air_K_s / (air_K_s - rates.withoutAir().rate_K_s(0.0, m_object->target_K));
    if (!(air_K_s > 0.0 || share == 0.0) || share > 1.0)
        return {}; // a target at or below the room
    const QLocale locale;
    const QString percent = locale.toString(100.0 * share, 'f', 0);
    const QString name = QString::fromStdString(m_object->name);
    const QString at = formatTemperature(m_object->target_K, m_unit);
    if (!m_air.isKnown())
        return tr("Natural convection would take some %1 % of what \u201c%2\u201d loses at %3.")
            .arg(percent, name, at);
    return tr("Takes %1 % of what \u201c%2\u201d loses at %3, with h = %4 W/(m\u00b2 K).")
        .arg(percent, name, at,
             locale.toString(convectionAt_W_m2K(*m_object, m_surroundings, m_air), 'f', 1));
}

void AirForm::retranslate() {
    m_heading->setText(tr("Air in the room"));
    m_kindCaption->setText(tr("Convection, for all objects"));
    m_kind->setAccessibleName(m_kindCaption->text());
    m_kind->setToolTip(tr("What verdicts, predictions and controllers take the air to be; it has the "
                          "temperature of the room"));
    m_kind->setItemText(kAirUnknown, tr("not known, not counted"));
    m_kind->setItemText(kAirGiven, tr("h is given"));
    m_kind->setItemText(kAirNatural, tr("natural, by correlation"));
    const QPalette caption = captionPalette(palette());
    for (QLabel* label : {m_kindCaption, m_takes, m_simulated})
        label->setPalette(caption);
    for (QLabel* label : findChildren<QLabel*>())
        if (label->buddy() != nullptr)
            label->setPalette(caption);
    show();
}

void AirForm::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        retranslate();
}

} // namespace bask
