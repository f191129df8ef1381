#pragma once
// One device of the rig: its kind, port and present state.

#include "engine/base/message_code.h"
#include "widgets/common/device_words.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace bask {

/// Object names end in the role's ("robot"): "card.", "driver.", "state.", "age.", "problem.", "accept.",
/// "setUp.", "remove.".
class DeviceCard : public QWidget {
    Q_OBJECT

public:
    explicit DeviceCard(DeviceRole role, QWidget* parent = nullptr);

    /// Sets the rig; empty if it is simulated.
    void setRig(const std::optional<RigSpec>& rig);
    /// Sets the state reported by the engine; empty if it reports none.
    void setState(const std::optional<RigDeviceState>& state);
    /// Sets whether the device may be set up or removed now.
    void setEditable(bool editable);

signals:
    void setUpWanted(bask::DeviceRole role);
    void removeWanted(bask::DeviceRole role);
    /// A person accepts the different device that answers there.
    void acceptWanted(bask::DeviceRole role);
    /// A person wants to confirm the program of this device.
    void confirmWanted(bask::DeviceRole role);

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showDevice();
    void showState();
    void showAgeTip();
    void showAccept(MessageCode problem);
    void showMark();
    void retranslate();

    DeviceRole m_role;
    std::optional<RigSpec> m_rig;
    std::optional<RigDeviceState> m_state;
    bool m_editable = true;
    bool m_isProgram = false; ///< whether the button confirms a program
    int m_shownMark = -1;
    QLabel *m_title, *m_driver, *m_mark, *m_word, *m_age, *m_problem;
    QPushButton *m_accept, *m_setUp, *m_remove;
};

} // namespace bask
