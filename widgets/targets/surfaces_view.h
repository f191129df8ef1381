#pragma once
// The targets' surfaces in 3-D with the controls of the view: drawn coordinates, fixed coordinates,
// direction, cut, picked point, and export.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment.h"
#include "widgets/common/latest_job.h"
#include "widgets/targets/surface_geometry.h"
#include "widgets/targets/sweep_player.h"

#include <QWidget>

#include <array>
#include <memory>
#include <optional>

class QComboBox;

namespace bask {

class CutControls;
class ExportBar;
class HeldControls;
class PickedPanel;
class TargetScene;
class ViewBar;

/// Takes values; fields and surfaces are computed off the GUI thread while the view is shown, fields again
/// only if the geometry or the fixed coordinates change. Where objects shade one another, surfaces on a
/// coarse grid come first, hatched until the fine ones are there; those of a played sweep are coarse. Playing
/// ends when the view is hidden. Object names: "surfaceSpace" (what the surfaces are drawn over, in
/// PoseSubset's order), "targetScene" and those of the rows: ViewBar, HeldControls, ExportBar, CutControls,
/// PickedPanel.
class SurfacesView : public QWidget {
    Q_OBJECT

public:
    explicit SurfacesView(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    /// Shows the surfaces of the verdict's targets, with fixed coordinates from its pose unless a slider sets
    /// another value.
    void setVerdict(const JointVerdict& verdict);
    void setStale(bool stale);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Sets whether the start of runs may be changed now; `why`: why not.
    void setStartable(bool startable, const QString& why);

    /// Called at the end of the export's dialogs.
    void savePicture(const QString& path, QSize size);
    void saveAnimation(const QString& folder, QSize size);

signals:
    /// The picked point was chosen as the start of runs.
    void startWanted(const bask::Vector6d& pose);
    void problem(const QString& sentence);
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    using Fields = std::vector<std::shared_ptr<const Field>>;
    struct Answer {
        std::shared_ptr<const Fields> fields;
        Vector6d fixed = Vector6d::Zero();
        PoseSubset subset = PoseSubset::Translation;
        SurfaceGrid grid = SurfaceGrid::Fine;
        std::vector<Isosurface> surfaces;
        Error problem; ///< without a code if there is none
    };
    void connectControls();
    PoseSubset subset() const;
    bool ready() const;
    Vector6d foundPose() const;
    Vector6d fixedPose() const;
    std::optional<Sweep> sweep(SurfaceGrid grid) const;
    void compute();
    void computeOn(SurfaceGrid grid);
    void take(Answer answer);
    void showVerdict();
    void showStale();
    void fix(int coordinate, double value);
    void changeSpace();
    void play(bool on);
    void endPlay();
    void endExport();
    void tellAnimation(const Error& error);
    void showControls();
    void showCut();
    void retranslate();

    Experiment m_experiment;
    std::optional<JointVerdict> m_verdict;
    std::array<std::optional<double>, 6> m_fixedManually; ///< empty ones are as in the verdict's pose
    std::shared_ptr<const Fields> m_fields;               ///< for the experiment and the three that follow
    Vector6d m_fieldsFixed = Vector6d::Zero();
    PoseSubset m_fieldsSubset = PoseSubset::Translation;
    SurfaceGrid m_fieldsGrid = SurfaceGrid::Fine;
    bool m_stale = false;  ///< whether the verdict is stale
    bool m_behind = false; ///< whether the surfaces are older than the verdict
    QString m_exportFolder;
    LatestJob<Answer> m_job;

    TargetScene* m_scene;
    SweepPlayer* m_player;
    QComboBox* m_space;
    ViewBar* m_views;
    HeldControls* m_heldControls;
    ExportBar* m_exportBar;
    CutControls* m_cut;
    PickedPanel* m_picked;
};

} // namespace bask
