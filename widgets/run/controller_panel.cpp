#include "widgets/run/controller_panel.h"

#include "widgets/common/display.h"
#include "widgets/common/quantity_spin_box.h"
#include "widgets/common/theme.h"

#include <QComboBox>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace bask {
namespace {

constexpr ControllerKind kKinds[] = {ControllerKind::LevelServo, ControllerKind::ModelBased,
                                     ControllerKind::Adaptive};

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
}

} // namespace bask
