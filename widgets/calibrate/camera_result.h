#pragma once
// A camera's numbers with their uncertainty, the verdict on it, and what can be done with it.

#include "engine/calibration/camera_calibration.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;
class QTableWidget;

namespace bask {

QString verdictWord(Verdict verdict); ///< "Good"

/// Object names: "cameraVerdict", "cameraReason", "cameraFacts", "cameraNumbers" (table), "cameraUse",
/// "cameraSave", "cameraLoad".
class CameraResult : public QWidget {
    Q_OBJECT

public:
    explicit CameraResult(QWidget* parent = nullptr);

    /// Shows a new calibration.
    void setCalibration(const CameraCalibration& calibration);
    /// Shows a camera from a file of that name; without a name, the camera in use.
    void setCamera(const CameraModel& camera, const QString& file);
    /// Shows the camera in use, if there is one.
    void clear();
    /// Sets the distance at which errors are given in mm.
    void setDistance(double distance_m);
    void setInUse(const std::optional<CameraModel>& camera);
    const std::optional<CameraModel>& camera() const { return m_camera; }
    std::optional<Verdict> verdict() const;

signals:
    void useClicked();
    void saveClicked();
    void loadClicked();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showAll();
    void showVerdict();
    void showNumbers();
    QString factsText() const;

    std::optional<CameraModel> m_camera;
    std::optional<CameraCalibration> m_calibration; ///< calibration of the shown camera, if it was made here
    QString m_file;
    std::optional<CameraModel> m_inUse;
    double m_distance_m = 0.6;

    QLabel* m_icon;
    QLabel* m_verdict;
    QLabel* m_reason;
    QLabel* m_facts;
    QTableWidget* m_numbers;
    QPushButton* m_use;
    QPushButton* m_save;
    QPushButton* m_load;
};

} // namespace bask
