#include "widgets/rig/safety_panel.h"

#include "engine/model/experiment_parameters.h"
#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/parameter_form.h"

#include <QEvent>
#include <QLabel>
#include <QToolButton>

namespace bask {
namespace {

constexpr std::array<std::string_view, 5> kUsual{"warning", "trip", "source_trip", "stale_periods",
                                                 "held_limit"};

} // namespace

SafetyPanel::SafetyPanel(QWidget* parent)
    : QWidget(parent), m_title(boldLabel(this)), m_own(new QLabel(this)), m_more(new QToolButton(this)),
      m_usual(new ParameterForm("safety.", this)), m_seldom(new ParameterForm("safety.", this)) {
    m_own->setObjectName("ownLimits");
    m_own->setWordWrap(true);
    m_own->setTextFormat(Qt::PlainText); // names are as they are
    m_more->setObjectName("safetyMore");
    m_more->setCheckable(true);
    m_more->setAutoRaise(true);
    m_more->setArrowType(Qt::RightArrow);
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_seldom->hide();
    connect(m_more, &QToolButton::toggled, this, [this](bool isOpen) {
        m_seldom->setVisible(isOpen);
        m_more->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
    });
    addRows();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_title);
    layout->addWidget(m_usual);
    layout->addWidget(m_own);
    layout->addWidget(m_more);
    layout->addWidget(m_seldom);
    retranslate();
}

void SafetyPanel::addRows() {
    for (const Parameter<SafetySpec>& parameter : safetyParameters()) {
        const bool isUsual = std::ranges::find(kUsual, parameter.name) != kUsual.end();
        (isUsual ? m_usual : m_seldom)->addRow(parameter, parameter.isOptional());
    }
    const auto take = [this](const ParameterFacts* facts, std::optional<double> si, const QString& words) {
        Experiment changed = m_experiment;
        setParameter(safetyParameters(), facts, changed.safety, si);
        emit edited(changed, words);
    };
    for (ParameterForm* form : {m_usual, m_seldom})
        connect(form, &ParameterForm::edited, this, take);
}

void SafetyPanel::setExperiment(const Experiment& experiment) {
    m_experiment = experiment;
    showValues();
}

void SafetyPanel::setEditable(bool editable) {
    for (ParameterForm* form : {m_usual, m_seldom})
        form->setEditable(editable);
}

void SafetyPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    for (ParameterForm* form : {m_usual, m_seldom})
        form->setTemperatureUnit(unit);
    showValues();
}

void SafetyPanel::showValues() {
    const double sourceTrip_K = sourceTripLimit_K(m_experiment);
    for (const Parameter<SafetySpec>& parameter : safetyParameters())
        for (ParameterForm* form : {m_usual, m_seldom}) {
            if (parameter.name == std::string_view("source_trip"))
                form->setAutomatic(parameter, sourceTrip_K, sourceTrip_K);
            else if (parameter.name == std::string_view("largest_rate"))
                form->setAutomatic(parameter, {}, SafetySpec::kMinRate_K_s);
            form->setValue(parameter, parameter.get(m_experiment.safety));
        }
    QStringList own;
    for (const ObjectSpec& object : m_experiment.objects)
        if (object.warning_K || object.trip_K)
            own << tr("%1 has limits of its own: warning %2, trip %3.")
                       .arg(QString::fromStdString(object.name),
                            formatTemperature(warningLimit_K(m_experiment, object), m_unit),
                            formatTemperature(tripLimit_K(m_experiment, object), m_unit));
    m_own->setText(own.join(u'\n'));
    m_own->setVisible(!own.isEmpty());
}

void SafetyPanel::retranslate() {
    m_title->setText(tr("Safety limits"));
    m_more->setText(tr("More"));
    showValues();
}

void SafetyPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
