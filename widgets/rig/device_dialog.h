#pragma once
// Sets up one device in steps: which device, its connection, a test reading, which of its parts are used.

#include "engine/base/units.h"
#include "widgets/common/device_words.h"

#include <QDialog>

#include <map>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QGridLayout;
class QLabel;
class QPushButton;

namespace bask {

class AxisTable;
class MessageBar;
class ParameterForm;
class SerialForm;
class ThermalCameraForm;
class UnitFinder;
class WholeNumberField;

/// Not modal. Object names: "driver", "port", "portDescription", "refreshPorts", those of SerialForm and
/// AxisTable, ThermalCameraForm and UnitFinder, "homing", "profile", "profileFile", "channel.0" ..., "probe",
/// "tryDevice", "tryResult", "useDevice", "cancelDevice", "deviceMessage"; and those of the drivers'
/// parameters: "unit", "watchdog" ...
class DeviceDialog : public QDialog {
    Q_OBJECT

public:
    /// `rig`: contains the device of this role if it is already set up.
    DeviceDialog(DeviceRole role, const RigSpec& rig, const std::vector<std::string>& objects,
                 QWidget* parent = nullptr);

    DeviceRole role() const { return m_role; }
    /// Returns a rig with this device alone.
    RigSpec device() const;

    void setPorts(const std::vector<SerialPort>& ports);
    /// Shows the answer of the tried device.
    void setTried(const TriedDevice& tried);
    /// Shows the state of the search for units.
    void setSearch(const ModbusSearchState& state);
    void showError(const QString& sentence);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Uses a Modbus device described by its own file.
    void useProfileFile(const QString& path);

signals:
    void portsWanted();
    void tryWanted(const bask::RigSpec& device);
    void searchWanted(const bask::ModbusSearchSpec& spec);
    void searchEnded();
    void useWanted(const bask::RigSpec& device);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void buildDevice();
    void buildConnection();
    void buildTrial();
    void buildUse();
    QLabel* addStep();
    void addParameters(SetupStep step);
    void fill(const RigSpec& rig);
    void offerProfiles();
    void chooseProfileFile();
    void takeDriver();
    void tryDevice();
    void search();
    void endSearch();
    void takeFound(int unit, const QString& profile, const SerialSettings& line);
    /// Facts of the chosen driver; a camera has one without a link.
    const DriverFacts& driver() const;
    bool isCamera() const { return m_role == DeviceRole::Camera || m_role == DeviceRole::ThermalCamera; }
    bool isModbus() const { return driver().isModbus; }
    bool hasLine() const; ///< whether the device is on a serial line
    bool hasPort() const;
    void showParts();
    void showPort();
    void sayNotTried();
    QString triedText(const TriedDevice& tried) const;
    void retranslate();
    void retranslateParts();

    DeviceRole m_role;
    std::vector<std::string> m_objects;
    std::vector<ModbusProfile> m_profiles; ///< the listed profiles
    std::vector<SerialPort> m_ports;
    std::string m_searched; ///< port of the search, of which units are shown; empty: none
    bool m_arePortsKnown = false;
    bool m_isTried = false;                           ///< its answer is shown
    std::map<const ParameterFacts*, double> m_values; ///< values of all drivers' parameters, SI
    TemperatureUnit m_unit = TemperatureUnit::Celsius;

    QFormLayout* m_form = nullptr;
    QLabel *m_deviceStep = nullptr, *m_connectionStep = nullptr, *m_trialStep = nullptr, *m_useStep = nullptr;
    QComboBox *m_driver, *m_port, *m_profile, *m_homing;
    QLabel *m_homingLabel, *m_driverLabel, *m_portLabel, *m_portDescription, *m_lineLabel, *m_axesLabel,
        *m_profileLabel, *m_channelsLabel, *m_result;
    QPushButton *m_refresh, *m_profileFile, *m_try, *m_use, *m_cancel;
    QWidget *m_portPart, *m_profilePart, *m_channelsPart, *m_trialPart;
    SerialForm* m_line;
    AxisTable* m_axes;
    ThermalCameraForm* m_thermal;
    UnitFinder* m_finder;
    QCheckBox *m_probe, *m_unattended;
    ParameterForm* m_parameters = nullptr;
    std::vector<WholeNumberField*> m_channels;
    MessageBar* m_message;
};

} // namespace bask
