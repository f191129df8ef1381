#include "widgets/rig/rig_devices.h"

#include "widgets/rig/device_card.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>

namespace bask {

RigDevices::RigDevices(QWidget* parent)
    : QWidget(parent), m_simulated(new QRadioButton(this)), m_real(new QRadioButton(this)),
      m_name(new QLineEdit(this)), m_open(new QPushButton(this)), m_save(new QPushButton(this)),
      m_console(new QPushButton(this)) {
    m_simulated->setObjectName("useSimulated");
    m_real->setObjectName("useReal");
    m_name->setObjectName("rigName");
    m_name->setMaxLength(60);
    m_open->setObjectName("openRig");
    m_save->setObjectName("saveRig");
    m_console->setObjectName("openConsole");
    auto* choice = new QHBoxLayout;
    choice->setSpacing(14);
    choice->addWidget(m_simulated);
    choice->addWidget(m_real);
    choice->addStretch(1);
    auto* file = new QHBoxLayout;
    file->addWidget(m_name, 1);
    file->addWidget(m_open);
    file->addWidget(m_save);
    file->addWidget(m_console);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    layout->addLayout(choice);
    layout->addLayout(file);
    for (std::size_t i = 0; i < kDeviceRoles.size(); ++i) {
        m_cards[i] = new DeviceCard(kDeviceRoles[i], this);
        layout->addWidget(m_cards[i]);
        connect(m_cards[i], &DeviceCard::setUpWanted, this, &RigDevices::setUpWanted);
        connect(m_cards[i], &DeviceCard::removeWanted, this, &RigDevices::removeWanted);
        connect(m_cards[i], &DeviceCard::acceptWanted, this, &RigDevices::acceptWanted);
        connect(m_cards[i], &DeviceCard::confirmWanted, this, &RigDevices::confirmWanted);
    }
    // A click asks; what is shown is what is in use.
    connect(m_simulated, &QRadioButton::clicked, this, [this] {
        if (m_rig)
            emit simulatedWanted();
        showChoice();
    });
    connect(m_real, &QRadioButton::clicked, this, [this] {
        if (!m_rig)
            emit realWanted();
        showChoice();
    });
    connect(m_name, &QLineEdit::editingFinished, this, [this] {
        if (m_rig && m_name->text().trimmed().toStdString() != m_rig->name)
            emit named(m_name->text().trimmed());
    });
    connect(m_open, &QPushButton::clicked, this, &RigDevices::openWanted);
    connect(m_save, &QPushButton::clicked, this, &RigDevices::saveWanted);
    connect(m_console, &QPushButton::clicked, this, &RigDevices::consoleWanted);
    retranslate();
    setRig({});
}

void RigDevices::setRig(const std::optional<RigSpec>& rig) {
    m_rig = rig;
    for (DeviceCard* card : m_cards)
        card->setRig(rig);
    showChoice();
}

void RigDevices::showChoice() {
    (m_rig ? m_real : m_simulated)->setChecked(true);
    m_name->setEnabled(m_rig && m_editable);
    m_name->setText(m_rig ? QString::fromStdString(m_rig->name) : QString());
    m_save->setEnabled(m_rig.has_value());
}

void RigDevices::setStates(const std::vector<RigDeviceState>& states) {
    for (std::size_t i = 0; i < kDeviceRoles.size(); ++i) {
        const auto it = std::ranges::find(states, kDeviceRoles[i], &RigDeviceState::role);
        m_cards[i]->setState(it == states.end() ? std::nullopt : std::optional(*it));
    }
}

void RigDevices::showRole(DeviceRole role, bool show) {
    const auto at = std::ranges::find(kDeviceRoles, role) - kDeviceRoles.begin();
    m_cards[static_cast<std::size_t>(at)]->setVisible(show);
}

void RigDevices::setEditable(bool editable) {
    if (editable == m_editable)
        return;
    m_editable = editable;
    for (QWidget* part : std::initializer_list<QWidget*>{m_simulated, m_real, m_open})
        part->setEnabled(editable);
    for (DeviceCard* card : m_cards)
        card->setEditable(editable);
    showChoice();
}

void RigDevices::retranslate() {
    m_simulated->setText(tr("Simulated rig"));
    m_simulated->setToolTip(tr("No device moves or heats. The real rig's set-up is kept for later."));
    m_real->setText(tr("Real rig"));
    m_real->setToolTip(tr("The devices below"));
    m_name->setPlaceholderText(tr("Name of the rig"));
    m_name->setAccessibleName(tr("Name of the rig"));
    m_open->setText(tr("Open rig…"));
    m_open->setToolTip(tr("Take the devices from a rig file"));
    m_save->setText(tr("Save rig…"));
    m_console->setText(tr("Console…"));
    m_console->setToolTip(tr("What goes over the links to the devices"));
    m_save->setToolTip(tr("Write these devices to a rig file, for other experiments"));
}

void RigDevices::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
}

} // namespace bask
