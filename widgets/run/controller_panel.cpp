#include "widgets/run/controller_panel.h"

#include "engine/control/controller_catalogue.h"
#include "engine/model/trace.h"
#include "widgets/common/belief_words.h"
#include "widgets/common/display.h"
#include "widgets/common/elided_label.h"
#include "widgets/common/parameter_form.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kPredictedStep_K = 10.0;

} // namespace

ControllerPanel::ControllerPanel(QWidget* parent) : QGroupBox(parent) {
    setObjectName(QStringLiteral("controllerPanel"));
    m_choiceLabel = new QLabel(this);
    m_choice = new QComboBox(this);
    m_choice->setObjectName(QStringLiteral("controllerChoice"));
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToContents); // also when the language changes
    m_choiceLabel->setBuddy(m_choice);
    for (const ControllerEntry& entry : controllerCatalogue())
        m_choice->addItem(QString(), QLatin1String(entry.kind.key()));
    m_form = new QFormLayout;
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setVerticalSpacing(5);
    m_form->addRow(m_choiceLabel, m_choice);
    makeRows();
    makeNaturalRows();
    m_prediction = new QLabel(this);
    m_prediction->setObjectName(QStringLiteral("gainsPrediction"));
    m_prediction->setWordWrap(true);

    m_note = new ElidedLabel(this);
    m_note->setObjectName(QStringLiteral("gainsStaged"));
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_revert = new QPushButton(this);
    m_revert->setObjectName(QStringLiteral("gainsRevert"));
    m_apply = new QPushButton(this);
    m_apply->setObjectName(QStringLiteral("gainsApply"));
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_note, 1);
    buttons->addWidget(m_revert);
    buttons->addWidget(m_apply);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setSpacing(6);
    layout->addLayout(m_form);
    layout->addWidget(m_prediction);
    layout->addLayout(buttons);

    connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (m_showing || index < 0)
            return;
        m_staged.kind = controllerCatalogue()[static_cast<std::size_t>(index)].kind;
        showStaged();
    });
    connect(m_apply, &QPushButton::clicked, this, [this] { emit controllerApplied(m_staged); });
    connect(m_revert, &QPushButton::clicked, this, [this] {
        m_staged = m_applied;
        showStaged();
    });
    retranslateUi();
    showStaged();
}

void ControllerPanel::makeRows() {
    for (const ControllerEntry& entry : controllerCatalogue())
        for (const ControllerGain& gain : entry.gains) {
            auto* label = new QLabel(this);
            auto* box = new GainSpinBox(this);
            box->setObjectName(QStringLiteral("gain.%1.%2").arg(entry.group, gain.facts->name));
            box->setRange(gain.facts->range.excludesMin ? box->minimum() : gain.facts->range.min,
                          gain.facts->range.max);
            label->setBuddy(box);
            m_form->addRow(label, box);
            connect(box, &QDoubleSpinBox::valueChanged, this, [this, &gain](double typed) {
                if (m_showing)
                    return;
                gain.set(m_staged, typed);
                showChanges();
            });
            m_gains.push_back({entry.kind, &gain, label, box});
        }
}

void ControllerPanel::makeNaturalRows() {
    const auto row = [this](QLabel*& label, GainSpinBox*& box, const char* name) {
        label = new QLabel(this);
        box = new GainSpinBox(this);
        box->setObjectName(QLatin1String(name));
        label->setBuddy(box);
        m_form->addRow(label, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (m_showing)
                return;
            m_staged.modelBased = gainsFromNatural({m_frequency->value(), m_damping->value()});
            for (const Gain& gain : m_gains) // as far as they are valid
                if (gain.kind == ControllerKind::ModelBased)
                    gain.gain->set(m_staged, std::min(gain.gain->get(m_staged), gain.box->maximum()));
            showStaged();
        });
    };
    row(m_frequencyLabel, m_frequency, "gain.frequency");
    row(m_dampingLabel, m_damping, "gain.damping");
    m_damping->setMinimum(0.0);
}

/// Frequency and damping of the staged gains, which are left as they are.
void ControllerPanel::showNatural() {
    const bool showing = std::exchange(m_showing, true);
    const NaturalGains natural = naturalGains(m_staged.modelBased);
    m_frequency->setValue(natural.frequency_rad_s);
    m_damping->setValue(natural.damping);
    m_showing = showing;
}

/// What the staged gains promise; empty for the level servo, whose time is that of travel and heat.
QString ControllerPanel::prediction() const {
    const QString band = QLocale().toString(kSettledBand_K);
    const QString step = QLocale().toString(kPredictedStep_K);
    if (m_staged.kind == ControllerKind::ModelBased) {
        const StepPrediction said = predictStep(m_staged.modelBased, kPredictedStep_K, kSettledBand_K);
        const QString overshoot = QLocale().toString(100.0 * said.overshoot, 'f', 1);
        if (!std::isfinite(said.settling_s))
            return tr("After a step of %1 K, without limits and noise: it never settles.").arg(step);
        return tr("After a step of %1 K, without limits and noise: overshoot %2 %, within \u00b1%3 K after "
                  "%4 s.")
            .arg(step, overshoot, band, QLocale().toString(said.settling_s, 'f', 0));
    }
    if (m_staged.kind == ControllerKind::Adaptive)
        return tr("After a step of %1 K, once it has adapted, without limits and noise: no overshoot, within "
                  "\u00b1%2 K after %3 s at best.")
            .arg(step, band,
                 QLocale().toString(predictSettling_s(m_staged.adaptive, kPredictedStep_K, kSettledBand_K),
                                    'f', 0));
    return {};
}

void ControllerPanel::setSettings(const ControllerSettings& settings) {
    if (settings == m_applied)
        return;
    const bool untouched = !changed();
    m_applied = settings;
    if (untouched) {
        m_staged = settings;
        showStaged();
    } else {
        showChanges();
    }
}

void ControllerPanel::setWrongRates(double factor) {
    m_wrongRates = factor;
    showChanges();
}

void ControllerPanel::showStaged() {
    m_showing = true;
    m_choice->setCurrentIndex(m_choice->findData(QLatin1String(m_staged.kind.key())));
    for (const Gain& gain : m_gains) {
        gain.box->setValue(gain.gain->get(m_staged));
        m_form->setRowVisible(gain.box, gain.kind == m_staged.kind);
    }
    for (GainSpinBox* box : {m_frequency, m_damping})
        m_form->setRowVisible(box, m_staged.kind == ControllerKind::ModelBased);
    m_showing = false;
    showChanges();
}

void ControllerPanel::showChanges() {
    const auto mark = [](QLabel* label, bool differs) {
        QFont font = label->font();
        font.setBold(differs);
        label->setFont(font);
    };
    int changes = m_staged.kind != m_applied.kind ? 1 : 0;
    mark(m_choiceLabel, changes > 0);
    for (const Gain& gain : m_gains) {
        const bool differs = gain.gain->get(m_staged) != gain.gain->get(m_applied);
        mark(gain.label, differs);
        changes += differs ? 1 : 0;
    }
    showNatural();
    m_prediction->setText(prediction());
    m_prediction->setPalette(captionPalette(palette()));
    m_prediction->setVisible(!m_prediction->text().isEmpty());
    const bool isWrong = m_wrongRates != 1.0;
    m_note->setText(changes > 0 ? tr("Not applied: %1", "number of changes").arg(changes)
                    : isWrong ? tr("Rates wrong: \u00d7%1", "the heat rates that the controller begins with")
                                    .arg(QLocale().toString(m_wrongRates, 'g', 3))
                              : QString());
    m_note->setToolTip(changes > 0 ? QString() : wrongRatesText(m_wrongRates));
    m_apply->setEnabled(changes > 0);
    m_revert->setEnabled(changes > 0);
}

void ControllerPanel::retranslateUi() {
    setTitle(tr("Controller and gains"));
    m_choiceLabel->setText(tr("Controller"));
    m_choice->setAccessibleName(tr("Controller"));
    m_showing = true;
    for (int i = 0; const ControllerEntry& entry : controllerCatalogue()) {
        m_choice->setItemText(i, controllerWord(entry.kind));
        m_choice->setItemData(i++, QCoreApplication::translate("Controller", entry.help), Qt::ToolTipRole);
    }
    m_choice->setMinimumWidth(m_choice->sizeHint().width()); // Qt keeps the minimum of the old words
    for (const Gain& gain : m_gains) {
        const ParameterFacts& facts = *gain.gain->facts;
        const QString unit = QString::fromUtf8(facts.unit.symbol);
        gain.label->setText(parameterLabel(facts));
        gain.box->setSuffix(QChar(0x00a0) + unit);
        gain.box->setToolTip(parameterHelp(facts));
        gain.box->setAccessibleName(QStringLiteral("%1 (%2)").arg(parameterLabel(facts), unit));
    }
    const auto natural = [](QLabel* label, GainSpinBox* box, const QString& text, const QString& unit,
                            const QString& help) {
        label->setText(text);
        box->setSuffix(unit.isEmpty() ? QString() : QChar(0x00a0) + unit);
        box->setToolTip(help);
        box->setAccessibleName(unit.isEmpty() ? text : QStringLiteral("%1 (%2)").arg(text, unit));
    };
    natural(m_frequencyLabel, m_frequency, tr("Frequency \u03c9"), tr("rad/s"),
            tr("Natural frequency: \u03c9 = \u221aK. Changes D and K together."));
    natural(m_dampingLabel, m_damping, tr("Damping ratio \u03b6"), QString(),
            tr("\u03b6 = D / (2\u221aK): overshoots below 1. Changes D."));
    m_showing = false;
    m_apply->setText(tr("Apply"));
    m_apply->setToolTip(tr("Use these settings from the next control step on; noted in the run's log."));
    m_revert->setText(tr("Revert"));
    m_revert->setToolTip(tr("Back to the settings in use."));
    showChanges();
}

void ControllerPanel::changeEvent(QEvent* event) {
    QGroupBox::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslateUi();
    else if (event->type() == QEvent::PaletteChange && m_apply != nullptr)
        showChanges();
}

} // namespace bask
