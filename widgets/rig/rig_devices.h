#pragma once
// The choice of the rig: the simulated one, or a real one with a device for each role.

#include "widgets/common/device_words.h"

#include <QWidget>

#include <array>
#include <optional>

class QLineEdit;
class QPushButton;
class QRadioButton;

namespace bask {

class DeviceCard;

/// Object names: "useSimulated", "useReal", "rigName", "openRig", "saveRig", "openConsole" and those of
/// DeviceCard.
class RigDevices : public QWidget {
    Q_OBJECT

public:
    explicit RigDevices(QWidget* parent = nullptr);

    void setRig(const std::optional<RigSpec>& rig);
    /// Sets the devices' states reported by the engine, by role.
    void setStates(const std::vector<RigDeviceState>& states);
    /// Hides the card of a device that the simulated rig does not have.
    void showRole(DeviceRole role, bool show);
    void setEditable(bool editable);

signals:
    void simulatedWanted();
    void realWanted();
    void named(const QString& name);
    void openWanted();
    void saveWanted();
    void consoleWanted();
    void setUpWanted(bask::DeviceRole role);
    void removeWanted(bask::DeviceRole role);
    void acceptWanted(bask::DeviceRole role);
    void confirmWanted(bask::DeviceRole role);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void showChoice();

    std::optional<RigSpec> m_rig;
    bool m_editable = true;
    QRadioButton *m_simulated, *m_real;
    QLineEdit* m_name;
    QPushButton *m_open, *m_save, *m_console;
    std::array<DeviceCard*, kDeviceRoles.size()> m_cards{};
};

} // namespace bask
