#include "widgets/rig/safety_panel.h"

#include "widgets/common/display.h"
#include "widgets/common/labels.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/rig/limit_field.h"

#include <QCheckBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>

namespace bask {
namespace {

const QString kSeconds = QStringLiteral("\u00a0s"), kKelvin = QStringLiteral("\u00a0K");

QFormLayout* makeForm(QWidget* part) {
    auto* form = new QFormLayout(part);
    form->setContentsMargins(0, 0, 0, 0);
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    return form;
}

} // namespace

SafetyPanel::SafetyPanel(QWidget* parent)
    : QWidget(parent), m_title(boldLabel(this)), m_own(new QLabel(this)),
      m_warning(temperature("safety.warning")), m_trip(temperature("safety.trip")),
      m_sourceTrip(temperature("safety.sourceTrip")),
      m_largestRate(limitField(this, "safety.largestRate", 0.0, 1e5, 2, QStringLiteral("\u00a0K/s"))),
      m_jumps(limitField(this, "safety.jumps", 1.0, 100.0, 0, {})), m_sourceAutomatic(new QCheckBox(this)),
      m_rateAutomatic(new QCheckBox(this)), m_more(new QToolButton(this)), m_morePart(new QWidget(this)) {
    build();
    connect(m_warning, &QuantitySpinBox::valueEdited_K, this, [this](double value_K) {
        edit(m_warning, m_warning->text(), [value_K](SafetySpec& s) { s.warning_K = value_K; });
    });
    connect(m_trip, &QuantitySpinBox::valueEdited_K, this, [this](double value_K) {
        edit(m_trip, m_trip->text(), [value_K](SafetySpec& s) { s.trip_K = value_K; });
    });
    connect(m_sourceTrip, &QuantitySpinBox::valueEdited_K, this, [this](double value_K) {
        edit(m_sourceTrip, m_sourceTrip->text(), [value_K](SafetySpec& s) { s.sourceTrip_K = value_K; });
    });
    connect(m_sourceAutomatic, &QCheckBox::clicked, this, [this](bool isAutomatic) {
        const double now_K = sourceTripLimit_K(m_experiment);
        edit(m_sourceTrip, isAutomatic ? tr("automatic") : formatTemperature(now_K, m_unit),
             [isAutomatic, now_K](SafetySpec& s) {
                 s.sourceTrip_K = isAutomatic ? std::nullopt : std::optional(now_K);
             });
    });
    connect(m_largestRate, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(m_largestRate, m_largestRate->text(), [value](SafetySpec& s) { s.largestRate_K_s = value; });
    });
    connect(m_rateAutomatic, &QCheckBox::clicked, this, [this](bool isAutomatic) {
        edit(m_largestRate, isAutomatic ? tr("automatic") : QString(), [isAutomatic](SafetySpec& s) {
            s.largestRate_K_s = isAutomatic ? std::nullopt : std::optional(SafetySpec::kLeastRate_K_s);
        });
    });
    connect(m_jumps, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        edit(m_jumps, m_jumps->text(), [value](SafetySpec& s) { s.jumps = static_cast<int>(value); });
    });
    connect(m_more, &QToolButton::toggled, this, [this](bool isOpen) {
        m_morePart->setVisible(isOpen);
        m_more->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
    });
    retranslate();
}

QuantitySpinBox* SafetyPanel::temperature(const QString& name) {
    auto* field = new QuantitySpinBox(this);
    field->setObjectName(name);
    field->setRange_K(kelvinFromCelsius(kLeastTemperature_degC), kelvinFromCelsius(kMostTemperature_degC));
    return field;
}

QWidget* SafetyPanel::withAutomatic(QWidget* field, QCheckBox* box) {
    auto* part = new QWidget(this);
    auto* row = new QHBoxLayout(part);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(field, 1);
    row->addWidget(box);
    box->setObjectName(field->objectName() + QStringLiteral("Automatic"));
    return part;
}

void SafetyPanel::addRow(QFormLayout* form, QWidget* row, QWidget* field, const char* text, const char* tip) {
    auto* label = new QLabel(this);
    label->setBuddy(field);
    form->addRow(label, row);
    m_rows.push_back({label, field, text, tip});
}

void SafetyPanel::addNumber(QFormLayout* form, const QString& name, double SafetySpec::*limit, double least,
                            double most, int decimals, const QString& suffix, const char* text,
                            const char* tip) {
    QDoubleSpinBox* field = limitField(this, name, least, most, decimals, suffix);
    connect(field, &QDoubleSpinBox::valueChanged, this, [this, field, limit](double value) {
        edit(field, field->text(), [limit, value](SafetySpec& s) { s.*limit = value; });
    });
    addRow(form, field, field, text, tip);
    m_numbers.push_back({field, limit});
}

// Ranges as validate() has them.
void SafetyPanel::build() {
    m_own->setObjectName("ownLimits");
    m_own->setWordWrap(true);
    m_own->setTextFormat(Qt::PlainText); // names are as they are
    m_more->setObjectName("safetyMore");
    m_more->setCheckable(true);
    m_more->setAutoRaise(true);
    m_more->setArrowType(Qt::RightArrow);
    m_more->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_morePart->hide();
    m_largestRate->setSpecialValueText(kNoValue); // at 0, which is none

    auto* usual = new QWidget(this);
    QFormLayout* form = makeForm(usual);
    addRow(form, m_warning, m_warning, QT_TR_NOOP("Objects: warning"),
           QT_TR_NOOP("A run holds, and a priority 2 alarm is given"));
    addRow(form, m_trip, m_trip, QT_TR_NOOP("Objects: trip"),
           QT_TR_NOOP("Heat off and retreat. What object, paint and sensor bear."));
    addRow(form, withAutomatic(m_sourceTrip, m_sourceAutomatic), m_sourceTrip, QT_TR_NOOP("Source: trip"),
           QT_TR_NOOP("Heat off and retreat. Automatic: 50 K over the highest set point."));
    addNumber(form, "safety.heldLimit", &SafetySpec::heldLimit_s, 0.0, 3600.0, 1, kSeconds,
              QT_TR_NOOP("Longest hold"),
              QT_TR_NOOP("A lost sensor or source holds the run so long, then it ends with a retreat"));
    addNumber(form, "safety.stalePeriods", &SafetySpec::stalePeriods, 1.0, 1000.0, 1, {},
              QT_TR_NOOP("Periods a reading is good for"),
              QT_TR_NOOP("A sensor without a newer one is lost; also the source and its place"));

    form = makeForm(m_morePart);
    addRow(
        form, withAutomatic(m_largestRate, m_rateAutomatic), m_largestRate,
        QT_TR_NOOP("Fastest plausible change"),
        QT_TR_NOOP("Faster readings are a jump, and no heat. Automatic: three times what the source can do "
                   "to the object, 2 K/s at least."));
    addRow(form, m_jumps, m_jumps, QT_TR_NOOP("Jumps in a row"),
           QT_TR_NOOP("So many readings that are too fast are a sensor fault"));
    addNumber(form, "safety.frozen", &SafetySpec::frozen_s, 1.0, 3600.0, 1, kSeconds,
              QT_TR_NOOP("Frozen sensor after"),
              QT_TR_NOOP("The very same reading for so long, though the object must have changed"));
    addNumber(form, "safety.warming", &SafetySpec::warming_K, 0.5, 1000.0, 1, kKelvin,
              QT_TR_NOOP("Change that must be seen"),
              QT_TR_NOOP("An object that must have changed by so much and did not does not follow its heat"));
    addNumber(form, "safety.crossCheck", &SafetySpec::crossCheck_K, 0.5, 1000.0, 1, kKelvin,
              QT_TR_NOOP("Sensors apart when cold"),
              QT_TR_NOOP("Sensors of a cold rig that differ by more are told"));
    addNumber(form, "safety.sourceHeating", &SafetySpec::sourceHeating_s, 10.0, 36000.0, 0, kSeconds,
              QT_TR_NOOP("Source: time to gain 2 K"),
              QT_TR_NOOP("A source that is too cold and no nearer after so long does not heat"));
    addNumber(form, "safety.sourceBand", &SafetySpec::sourceBand_K, 1.0, 1000.0, 1, kKelvin,
              QT_TR_NOOP("Source: near its set point"), QT_TR_NOOP("Within this the source is not too cold"));
    addNumber(form, "safety.sourceUnasked", &SafetySpec::sourceUnasked_K, 1.0, 1000.0, 1, kKelvin,
              QT_TR_NOOP("Source: warming unasked"),
              QT_TR_NOOP("More warming with the heat off is an alarm"));
    addNumber(form, "safety.leastDisk", &SafetySpec::leastDisk_MB, 0.0, 1e6, 0, QStringLiteral("\u00a0MB"),
              QT_TR_NOOP("Least room on the disk"), QT_TR_NOOP("With less no recording is begun"));

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addWidget(m_title);
    layout->addWidget(usual);
    layout->addWidget(m_own);
    layout->addWidget(m_more);
    layout->addWidget(m_morePart);
}

void SafetyPanel::edit(QDoubleSpinBox* field, const QString& wanted, const Apply& apply) {
    Experiment changed = m_experiment;
    apply(changed.safety);
    if (changed.safety == m_experiment.safety)
        return;
    showValues(); // as it is, until the change is taken
    emit edited(changed, tr("%1: %2 instead of %3").arg(field->accessibleName(), wanted, field->text()));
}

void SafetyPanel::setExperiment(const Experiment& experiment) {
    m_experiment = experiment;
    showValues();
}

void SafetyPanel::setEditable(bool editable) {
    m_editable = editable;
    showEditable();
}

void SafetyPanel::showEditable() {
    for (const Row& row : m_rows)
        row.field->setEnabled(m_editable);
    m_sourceAutomatic->setEnabled(m_editable);
    m_rateAutomatic->setEnabled(m_editable);
    if (!m_experiment.safety.sourceTrip_K)
        m_sourceTrip->setEnabled(false);
    if (!m_experiment.safety.largestRate_K_s)
        m_largestRate->setEnabled(false);
}

void SafetyPanel::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    for (QuantitySpinBox* field : {m_warning, m_trip, m_sourceTrip})
        field->setTemperatureUnit(unit);
    showValues();
}

void SafetyPanel::showValues() {
    const SafetySpec& safety = m_experiment.safety;
    m_warning->setValue_K(safety.warning_K);
    m_trip->setValue_K(safety.trip_K);
    m_sourceTrip->setValue_K(sourceTripLimit_K(m_experiment));
    m_sourceAutomatic->setChecked(!safety.sourceTrip_K);
    setQuietly(m_largestRate, safety.largestRate_K_s.value_or(0.0));
    m_rateAutomatic->setChecked(!safety.largestRate_K_s);
    setQuietly(m_jumps, safety.jumps);
    for (const Number& number : m_numbers)
        setQuietly(number.field, safety.*number.limit);
    QStringList own;
    for (const ObjectSpec& object : m_experiment.objects)
        if (object.warning_K || object.trip_K)
            own << tr("%1 has limits of its own: warning %2, trip %3.")
                       .arg(QString::fromStdString(object.name),
                            formatTemperature(warningLimit_K(m_experiment, object), m_unit),
                            formatTemperature(tripLimit_K(m_experiment, object), m_unit));
    m_own->setText(own.join(u'\n'));
    m_own->setVisible(!own.isEmpty());
    showEditable();
}

void SafetyPanel::retranslate() {
    m_title->setText(tr("Safety limits"));
    m_more->setText(tr("More"));
    m_sourceAutomatic->setText(tr("Automatic"));
    m_sourceAutomatic->setAccessibleName(tr("Automatic trip limit of the source"));
    m_rateAutomatic->setText(tr("Automatic"));
    m_rateAutomatic->setAccessibleName(tr("Automatic fastest change"));
    for (const Row& row : m_rows) {
        row.label->setText(tr(row.text));
        row.field->setAccessibleName(tr(row.text));
        row.field->setToolTip(tr(row.tip));
    }
    showValues();
}

void SafetyPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
