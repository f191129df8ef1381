#include "app/fault_menu.h"

#include "app/fault_words.h"
#include "widgets/common/display.h"

#include <QAction>
#include <QMenu>

#include <algorithm>

namespace bask {
namespace {

/// Menus show the one, the foot of the window the other.
void setTip(QAction* action, const QString& tip) {
    action->setToolTip(tip); // without one, its text
    action->setStatusTip(tip);
}

} // namespace

FaultMenu::FaultMenu(QWidget* window)
    : QObject(window), m_menu(new QMenu(window)), m_restore(new QAction(window)) {
    m_menu->setObjectName(QStringLiteral("faultMenu"));
    m_menu->setToolTipsVisible(true);
    m_restore->setObjectName(QStringLiteral("restoreDevices"));
    connect(m_restore, &QAction::triggered, this, [this] { emit faultChosen({}); });
    for (int i = 1; i < kSimulatedFaults; ++i) {
        const auto fault = static_cast<SimulatedFault>(i);
        if (isOfObject(fault)) {
            auto* menu = new QMenu(window);
            menu->setObjectName(QLatin1String(simulatedFaultName(fault)));
            menu->setToolTipsVisible(true);
            menu->menuAction()->setCheckable(true);
            m_objectMenus.emplace_back(fault, menu);
        } else {
            auto* action = new QAction(window);
            action->setObjectName(QLatin1String(simulatedFaultName(fault)));
            add(fault, 0, action);
        }
    }
    fill();
    retranslate();
}

void FaultMenu::fill() {
    for (const auto& [fault, menu] : m_objectMenus)
        m_menu->addMenu(menu);
    m_menu->addSeparator();
    for (const Entry& entry : m_rigEntries)
        m_menu->addAction(entry.action);
    m_menu->addSeparator();
    m_menu->addAction(m_restore);
}

void FaultMenu::add(SimulatedFault fault, std::size_t object, QAction* action) {
    const ActiveFault which{fault, object};
    action->setCheckable(true);
    connect(action, &QAction::triggered, this, [this, which, action] {
        action->setChecked(isActive(which)); // until the engine tells otherwise
        emit faultChosen({which.fault, which.object, !isActive(which)});
    });
    (isOfObject(fault) ? m_objectEntries : m_rigEntries).push_back({which, action});
}

void FaultMenu::setExperiment(const Experiment& experiment) {
    const bool hasSameObjects = std::ranges::equal(experiment.objects, m_experiment.objects, {},
                                                   &ObjectSpec::name, &ObjectSpec::name);
    m_experiment = experiment;
    if (!hasSameObjects) {
        m_objectEntries.clear();
        for (const auto& [fault, menu] : m_objectMenus) {
            menu->clear();
            for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
                QString name = QString::fromStdString(experiment.objects[i].name);
                add(fault, i, menu->addAction(name.replace(u'&', QStringLiteral("&&")))); // no mnemonic
            }
        }
    }
    refresh();
}

void FaultMenu::apply(const Snapshot& snapshot) {
    Told told{snapshot.simulated, snapshot.heat, snapshot.faults};
    if (told == m_told)
        return;
    m_told = std::move(told);
    refresh();
}

bool FaultMenu::isActive(const ActiveFault& fault) const {
    return std::ranges::find(m_told.active, fault) != m_told.active.end();
}

void FaultMenu::refresh() {
    m_menu->setEnabled(m_told.isSimulated);
    setTip(m_menu->menuAction(),
           m_told.isSimulated ? QString()
                              : tr("Not on a real rig: faults are simulated on the simulated rig only."));
    for (const auto* entries : {&m_objectEntries, &m_rigEntries})
        for (const Entry& entry : *entries)
            show(entry);
    for (const auto& [fault, menu] : m_objectMenus)
        showParent(fault, menu);
    m_restore->setEnabled(!m_told.active.empty());
    setTip(m_restore, m_told.active.empty() ? tr("No simulated fault is active.") : QString());
}

void FaultMenu::show(const Entry& entry) {
    const FaultEffect effect = faultEffect(m_experiment, m_told.heat, entry.fault.fault, entry.fault.object);
    const bool isOn = isActive(entry.fault);
    entry.action->setChecked(isOn);
    const bool isOfNoUse = showsNothing(effect) || effect == FaultEffect::InPictures; // no run is changed
    entry.action->setEnabled(isOn || !isOfNoUse);
    const QString words = faultEffectWords(effect);
    setTip(entry.action, isOn ? (tr("Active. Choose it again to end it.") + u' ' + words).trimmed() : words);
}

/// As its entries: ticked with one of them, and not possible where none is, with their reason.
void FaultMenu::showParent(SimulatedFault fault, QMenu* menu) {
    bool isOn = false, isPossible = false;
    for (const Entry& entry : m_objectEntries)
        if (entry.fault.fault == fault) {
            isOn = isOn || isActive(entry.fault);
            isPossible = isPossible || entry.action->isEnabled();
        }
    menu->menuAction()->setChecked(isOn);
    menu->setEnabled(isPossible);
    const bool hasReason = !isPossible && !menu->isEmpty();
    setTip(menu->menuAction(), hasReason ? menu->actions().front()->toolTip() : QString());
}

void FaultMenu::retranslate() {
    m_menu->setTitle(tr("&Simulate fault"));
    m_restore->setText(simulatedFaultWord(SimulatedFault::None));
    for (const auto& [fault, menu] : m_objectMenus)
        menu->setTitle(simulatedFaultWord(fault));
    for (const Entry& entry : m_rigEntries)
        entry.action->setText(simulatedFaultWord(entry.fault.fault));
    refresh();
}

} // namespace bask
