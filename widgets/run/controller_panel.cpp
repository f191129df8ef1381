#include "widgets/run/controller_panel.h"

#include "engine/session/trace.h"
#include "widgets/common/display.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"

#include <QComboBox>
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

constexpr ControllerKind kKinds[] = {ControllerKind::LevelServo, ControllerKind::ModelBased,
                                     ControllerKind::Adaptive};
constexpr double kPredictedStep_K = 10.0;

} // namespace

ControllerPanel::ControllerPanel(QWidget* parent) : QGroupBox(parent) {
    setObjectName(QStringLiteral("controllerPanel"));
    m_choiceLabel = new QLabel(this);
    m_choice = new QComboBox(this);
    m_choice->setObjectName(QStringLiteral("controllerChoice"));
    m_choiceLabel->setBuddy(m_choice);
    for (ControllerKind kind : kKinds)
        m_choice->addItem(QString(), static_cast<int>(kind));
    m_form = new QFormLayout;
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->setVerticalSpacing(5);
    m_form->addRow(m_choiceLabel, m_choice);
    makeRows();
    makeNaturalRows();
    m_prediction = new QLabel(this);
    m_prediction->setObjectName(QStringLiteral("gainsPrediction"));
    m_prediction->setWordWrap(true);

    m_note = new QLabel(this);
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
        m_staged.kind = static_cast<ControllerKind>(m_choice->itemData(index).toInt());
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
    using S = ControllerSettings;
    m_gains = {
        {ControllerKind::LevelServo, "timeConstant",
         [](S& s) -> double& { return s.levelServo.timeConstant_s; }, 0.5, 1000.0},
        {ControllerKind::LevelServo, "integralTime",
         [](S& s) -> double& { return s.levelServo.integralTime_s; }, 1.0, 1e5},
        {ControllerKind::ModelBased, "modelD", [](S& s) -> double& { return s.modelBased.D; }, 1e-4, 100.0},
        {ControllerKind::ModelBased, "modelK", [](S& s) -> double& { return s.modelBased.K; }, 1e-6, 100.0},
        {ControllerKind::Adaptive, "adaptiveMu", [](S& s) -> double& { return s.adaptive.mu; }, 1e-4, 10.0},
        {ControllerKind::Adaptive, "adaptiveK", [](S& s) -> double& { return s.adaptive.K; }, 1e-4, 100.0},
        {ControllerKind::Adaptive, "adaptiveGamma1", [](S& s) -> double& { return s.adaptive.gamma1; }, 1e-9,
         1e3},
        {ControllerKind::Adaptive, "adaptiveGamma2", [](S& s) -> double& { return s.adaptive.gamma2; }, 1e-35,
         1.0},
    };
    for (Gain& gain : m_gains) {
        gain.label = new QLabel(this);
        gain.box = new GainSpinBox(this);
        gain.box->setObjectName(QStringLiteral("gain.") + QLatin1String(gain.key));
        gain.box->setRange(gain.least, gain.most);
        gain.label->setBuddy(gain.box);
        m_form->addRow(gain.label, gain.box);
        connect(gain.box, &QDoubleSpinBox::valueChanged, this, [this, of = gain.of](double typed) {
            if (m_showing)
                return;
            of(m_staged) = typed;
            showChanges();
        });
    }
}

void ControllerPanel::makeNaturalRows() {
    const auto row = [this](QLabel*& label, GainSpinBox*& box, const char* name, double least, double most) {
        label = new QLabel(this);
        box = new GainSpinBox(this);
        box->setObjectName(QLatin1String(name));
        box->setRange(least, most);
        label->setBuddy(box);
        m_form->addRow(label, box);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (m_showing)
                return;
            m_staged.modelBased = gainsFromNatural({m_frequency->value(), m_damping->value()});
            showStaged();
        });
    };
    row(m_frequencyLabel, m_frequency, "gain.modelFrequency", 1e-3, 10.0);
    row(m_dampingLabel, m_damping, "gain.modelDamping", 1e-4, 100.0);
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

void ControllerPanel::showStaged() {
    m_showing = true;
    m_choice->setCurrentIndex(m_choice->findData(static_cast<int>(m_staged.kind)));
    for (const Gain& gain : m_gains) {
        gain.box->setValue(gain.of(m_staged));
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
        const bool differs = gain.of(m_staged) != gain.of(m_applied);
        mark(gain.label, differs);
        changes += differs ? 1 : 0;
    }
    showNatural();
    m_prediction->setText(prediction());
    m_prediction->setPalette(captionPalette(palette()));
    m_prediction->setVisible(!m_prediction->text().isEmpty());
    m_note->setText(changes > 0 ? tr("Not applied: %1", "number of changes").arg(changes) : QString());
    m_note->setToolTip(m_note->text());
    m_apply->setEnabled(changes > 0);
    m_revert->setEnabled(changes > 0);
}

void ControllerPanel::retranslateUi() {
    setTitle(tr("Controller and gains"));
    m_choiceLabel->setText(tr("Controller"));
    m_choice->setAccessibleName(tr("Controller"));
    for (int i = 0; i < m_choice->count(); ++i)
        m_choice->setItemText(i, controllerWord(kKinds[i]));
    m_choice->setItemData(0, tr("Moves to the view factor each object needs; learns the rates on the way."),
                          Qt::ToolTipRole);
    m_choice->setItemData(1, tr("The paper's law with known heat rates: dv/dt = −D v \u2212 K \u0394\u03c4."),
                          Qt::ToolTipRole);
    m_choice->setItemData(2, tr("The paper's law with adapted heat rates."), Qt::ToolTipRole);

    const struct {
        QString label, unit, help;
    } texts[] = {
        {tr("Time constant"), tr("s"),
         tr("Wanted rate = error / time constant: shorter is faster and rougher.")},
        {tr("Integral time"), tr("s"), tr("Of the slow integral action near the target.")},
        {tr("Damping D"), tr("1/s"), tr("dv/dt = −D v \u2212 K \u0394\u03c4")},
        {tr("Stiffness K"), tr("1/s\u00b2"), tr("dv/dt = −D v \u2212 K \u0394\u03c4")},
        {tr("Weight of the error \u03bc"), tr("1/s"), tr("\u03b6 = v + \u03bc \u0394\u03c4")},
        {tr("Feedback K"), tr("1/K"), tr("Of \u03b6 in the velocity command")},
        {tr("Adaptation \u03b3\u2081"), tr("s\u00b3/K\u00b3"),
         tr("Speed at which 1/\u03bb\u2081 is adapted")},
        {tr("Adaptation \u03b3\u2082"), tr("s/K\u2079"),
         tr("Speed at which \u03bb\u2082/\u03bb\u2081 is adapted")},
    };
    m_showing = true;
    for (std::size_t i = 0; i < m_gains.size(); ++i) {
        m_gains[i].label->setText(texts[i].label);
        m_gains[i].box->setSuffix(QChar(0x00a0) + texts[i].unit);
        m_gains[i].box->setToolTip(texts[i].help);
        m_gains[i].box->setAccessibleName(QStringLiteral("%1 (%2)").arg(texts[i].label, texts[i].unit));
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
    else if (event->type() == QEvent::PaletteChange && m_prediction != nullptr)
        m_prediction->setPalette(captionPalette(palette()));
}

} // namespace bask
