#pragma once
// One device of the rig: what it is, on which port, how it is now.

#include "widgets/rig/device_words.h"

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

    /// Empty: the rig is simulated.
    void setRig(const std::optional<RigSpec>& rig);
    /// As the engine tells it; empty: it does not.
    void setState(const std::optional<RigDeviceState>& state);
    /// Whether it may be set up or removed now.
    void setEditable(bool editable);

signals:
    void setUpWanted(bask::DeviceRole role);
    void removeWanted(bask::DeviceRole role);
    /// Another device than before answers there, and is the right one.
    void acceptWanted(bask::DeviceRole role);

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void showDevice();
    void showState();
    void showMark();
    void retranslate();

    DeviceRole m_role;
    std::optional<RigSpec> m_rig;
    std::optional<RigDeviceState> m_state;
    bool m_editable = true;
    int m_shownMark = -1;
    QLabel *m_title, *m_driver, *m_mark, *m_word, *m_age, *m_problem;
    QPushButton *m_accept, *m_setUp, *m_remove;
};

} // namespace bask
