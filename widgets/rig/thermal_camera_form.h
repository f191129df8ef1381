#pragma once
// Which thermal camera it is, and where it stands.

#include "engine/model/thermal_camera_spec.h"

#include <QWidget>

#include <array>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace bask {

/// Object names: "thermalProfile", "thermalProfileFile", "poseKnown", "thermalPose.x" ...
class ThermalCameraForm : public QWidget {
    Q_OBJECT

public:
    explicit ThermalCameraForm(QWidget* parent = nullptr);

    void setCamera(const ThermalCameraSpec& camera);
    /// Returns the camera without its device. Another profile has another lens.
    ThermalCameraSpec camera() const;
    /// Uses a camera described by a file of its own. Returns why it cannot be used; empty if it can.
    QString useProfileFile(const QString& path);

signals:
    void failed(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    ThermalCameraSpec m_camera; ///< as it was set up
    std::vector<ThermalProfile> m_profiles;
    QComboBox* m_profile;
    QPushButton* m_file;
    QCheckBox* m_isPoseKnown;
    QLabel *m_profileLabel, *m_hint;
    std::array<QLabel*, 6> m_names{};
    std::array<QDoubleSpinBox*, 6> m_pose{};
};

} // namespace bask
