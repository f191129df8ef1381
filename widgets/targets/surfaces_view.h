#pragma once
// The targets' surfaces in 3-D with what steers the view: the angle held, the direction, the point picked.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/session/experiment.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <memory>
#include <optional>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace bask {

class TargetScene;

/// Values in; fields and surfaces are computed off the GUI thread and while the view is shown, fields anew
/// only when the geometry or the angle held changes. Object names: "targetScene", "heldAngle" (slider),
/// "heldAtPose", "viewTop", "viewSide", "viewIsometric", "savePicture", "cutObject", "cutAxis", "cutPlace"
/// (slider), "picked", "startHere".
class SurfacesView : public QWidget {
    Q_OBJECT

public:
    explicit SurfacesView(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    /// Surfaces of the verdict's targets, at the angles of its pose unless the slider holds another.
    void setVerdict(const JointVerdict& verdict);
    void setStale(bool stale);
    void setTemperatureUnit(TemperatureUnit unit);
    void setEditable(bool editable);

signals:
    /// The point picked shall be where runs start.
    void startWanted(const bask::Vector6d& pose);
    void problem(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    using Fields = std::vector<std::shared_ptr<const Field>>;
    struct Answer {
        std::shared_ptr<const Fields> fields;
        Vector6d held = Vector6d::Zero();
        std::optional<std::vector<Isosurface>> surfaces; ///< empty: stopped or refused
    };
    Vector6d heldPose() const;
    void compute();
    void take(Answer answer);
    void hold(double angle_rad);
    void savePicture();
    void showControls();
    void showCut();
    void placeCut();
    void retranslate();

    Experiment m_experiment;
    std::optional<JointVerdict> m_verdict;
    int m_angle = -1;                       ///< coordinate that the slider holds; -1: none is free
    std::optional<double> m_held_rad;       ///< set by hand; empty: as the verdict's pose
    std::shared_ptr<const Fields> m_fields; ///< of the experiment and m_fieldsHeld
    Vector6d m_fieldsHeld = Vector6d::Zero();
    std::optional<Vector6d> m_picked;
    bool m_editable = true;
    LatestJob<Answer> m_job;

    TargetScene* m_scene;
    QLabel* m_heldLabel;
    QSlider* m_heldAngle;
    QPushButton* m_heldAtPose;
    QToolButton* m_top;
    QToolButton* m_side;
    QToolButton* m_isometric;
    QPushButton* m_save;
    QComboBox* m_cutObject; ///< first: no cut; then the objects
    QComboBox* m_cutAxis;
    QSlider* m_cutPlace; ///< mm along the axis
    QLabel* m_pickedWords;
    QPushButton* m_startHere;
};

} // namespace bask
