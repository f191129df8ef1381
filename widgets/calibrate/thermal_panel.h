#pragma once
// Where the thermal camera is, by the outlines of the objects that the robot holds: measured, judged, used.

#include "engine/model/experiment.h"
#include "engine/thermography/silhouette_pose.h"
#include "engine/thermography/thermal_view.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <optional>
#include <vector>

class QLabel;
class QPushButton;

namespace bask {

class SurveyBar;
class VerdictBox;

/// For a rig with a thermal camera. Object names: "thermalTour", those of a VerdictBox "thermal" and of
/// SurveyBar.
class ThermalPanel : public QWidget {
    Q_OBJECT

public:
    explicit ThermalPanel(QWidget* parent = nullptr);
    ~ThermalPanel() override;

    void setExperiment(const Experiment& experiment);
    /// Each picture counts once.
    void setView(const ThermalView& view);
    /// Coordinates of the end-effector in R; `mayMove`: no run is armed or on, no stop latched.
    void setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove);
    /// Whether a calibration board is looked for, which hides the objects.
    void setBoardWanted(bool isWanted);

signals:
    void calibrated(const bask::ThermalCalibration& calibration);
    void moveWanted(const bask::Vector6d& coordinates);
    void holdWanted(); ///< stop the robot where it is
    /// This part of the panel must be seen.
    void attentionWanted(QWidget* part);

protected:
    void changeEvent(QEvent* event) override;

private:
    void begin();
    void solve();
    void take(Result<SilhouettePose> result);
    void use();
    ThermalCalibration calibration() const;
    void showPose();
    void showEnabled();
    QString whyNot() const; ///< why measuring is not possible now
    void retranslate();

    Experiment m_experiment;
    ThermalView m_view;
    Vector6d m_robot = Vector6d::Zero();
    bool m_mayMove = false;
    bool m_isBoardWanted = false;
    std::vector<SilhouetteView> m_views;
    std::optional<SilhouettePose> m_found;
    LatestJob<Result<SilhouettePose>> m_solving;

    QLabel *m_title, *m_hint;
    QPushButton* m_tour;
    SurveyBar* m_bar;
    VerdictBox* m_box;
};

} // namespace bask
