#pragma once
// Tools > Simulate fault: the faults of the simulated rig, which of them are active, and why one is not
// possible here.

#include "engine/runtime/command.h"
#include "engine/runtime/fault_effect.h"
#include "engine/runtime/snapshot.h"

#include <QObject>

#include <optional>
#include <vector>

class QAction;
class QMenu;
class QWidget;

namespace bask {

/// A tick is what the engine tells, not what was asked for: choosing a ticked fault asks for its end. Object
/// names: each fault's own ("sensor-lost", a menu with one entry for each object; "robot-lost"),
/// "restoreDevices", which ends all.
class FaultMenu : public QObject {
    Q_OBJECT

public:
    explicit FaultMenu(QWidget* window);

    QMenu* menu() const { return m_menu; }
    /// Offers the faults of these objects and of what their rig uses.
    void setExperiment(const Experiment& experiment);
    void apply(const Snapshot& snapshot);
    void retranslate();

signals:
    void faultChosen(const bask::SimulateFault& fault);

private:
    struct Entry {
        ActiveFault fault;
        QAction* action;
    };
    /// What the entries depend on.
    struct Told {
        bool isSimulated = true;
        HeatState heat = HeatState::Unknown;
        std::vector<ActiveFault> active;
        bool operator==(const Told&) const = default;
    };
    void add(SimulatedFault fault, std::size_t object, QAction* action);
    void fill();
    void refresh();
    void show(const Entry& entry);
    void showParent(SimulatedFault fault, QMenu* menu);
    bool isActive(const ActiveFault& fault) const;

    QMenu* m_menu;
    QAction* m_restore;
    std::vector<std::pair<SimulatedFault, QMenu*>> m_objectMenus;
    std::vector<Entry> m_rigEntries, m_objectEntries;
    Experiment m_experiment;
    Told m_told;
};

} // namespace bask
