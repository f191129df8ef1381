#pragma once
// The Rig page: the rig and its devices, the conditions for a run, manual control of robot and heat, the
// source and the limits.

#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/runtime/command.h"
#include "engine/runtime/snapshot.h"

#include <QPointer>
#include <QWidget>

#include <map>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QScrollArea;
class QTabWidget;

namespace bask {

class CheckList;
class DeviceConsole;
class DeviceDialog;
class HeatPanel;
class JogPanel;
class LimitsPanel;
class MessageBar;
class ReadingPanel;
class RigDevices;
class SafetyPanel;
class ZeroPanel;

/// Setters in, signals out. An edit is one experimentEdited with the whole value; the receiver answers a
/// refused one with showError before it returns, else with setExperiment.
///
/// Object names: "rigMessage" (MessageBar), "rigTabs", "manualReason", "limitQuestion", and those of
/// RigDevices, ZeroPanel, ReadingPanel, CheckList, JogPanel, HeatPanel, LimitsPanel, SafetyPanel and
/// DeviceDialog.
class RigPage : public QWidget {
    Q_OBJECT

public:
    explicit RigPage(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    /// `editable`: no run is armed or on.
    void apply(const Snapshot& snapshot, bool editable);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Sets why the current edit is refused.
    void showError(const QString& sentence) { m_refusal = sentence; }
    /// Uses the devices of a rig file, with as many channels as there are sensors.
    void useRig(const RigSpec& rig);

signals:
    void experimentEdited(const bask::Experiment& experiment);
    void commandIssued(const bask::Command& command);
    void homeRequested(); ///< the window asks first
    void openRigRequested();
    void saveRigRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    QScrollArea* scrolled(QWidget* content);
    QWidget* buildLeft();
    QWidget* buildManual();
    QWidget* buildLimits();
    void connectAll();
    bool edit(const Experiment& experiment); ///< returns false if refused; the page shows why
    void editLimits(const Experiment& experiment, const QString& words);
    void useSimulated();
    void setUp(DeviceRole role);
    void endTrial();
    void openConsole();
    void closeDialog();
    void showTried(const TriedDevice& tried);
    void confirmProgram(const std::string& command);
    void take(DeviceRole role, const RigSpec& device);
    void remove(DeviceRole role);
    void readObject(std::size_t object, ReadBy readBy);
    std::vector<int> channelsAsBefore(const std::vector<ObjectSpec>& objects);
    void showManual();
    void retranslate();

    Experiment m_experiment;
    std::optional<RigSpec> m_kept;            ///< the real rig, while the simulated one is in use
    std::optional<RobotLimits> m_keptRobot{}; ///< robot limits of the kept rig
    std::map<std::string, int> m_channels;    ///< of sensors that are or were used, by their objects
    RunState m_state = RunState::Idle;
    PlaceState m_place = PlaceState::Sure;
    MessageCode m_remedy{};
    bool m_editable = true;
    QString m_refusal;          ///< refusal of the newest edit; empty if it was accepted
    bool m_isTrying = false;    ///< the engine keeps a device open for the dialog
    bool m_isSearching = false; ///< for Modbus units, for the dialog
    int m_searchNumber = 0;
    bool m_isProgramAsked = false; ///< about the program that is tried
    TemperatureUnit m_unit = TemperatureUnit::Celsius;

    MessageBar* m_message;
    RigDevices* m_devices;
    CheckList* m_checks;
    QTabWidget* m_tabs;
    QLabel *m_reason, *m_robotTitle, *m_heatTitle;
    JogPanel* m_jog;
    HeatPanel* m_heat;
    LimitsPanel* m_limits;
    SafetyPanel* m_safety;
    ZeroPanel* m_zero;
    ReadingPanel* m_readings;
    QPointer<DeviceDialog> m_dialog;
    QPointer<DeviceConsole> m_console;
};

} // namespace bask
