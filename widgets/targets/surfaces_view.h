#pragma once
// The targets' surfaces in 3-D with what steers the view: what they are drawn over, what is held, the
// direction, the cut, the point picked, and what is exported.

#include "engine/base/units.h"
#include "engine/control/joint_feasibility.h"
#include "engine/exchange/target_surfaces.h"
#include "engine/model/experiment.h"
#include "widgets/common/latest_job.h"
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

/// Values in; fields and surfaces are computed off the GUI thread and while the view is shown, fields anew
/// only when the geometry or what is held changes. Playing ends when the view is hidden. Object names:
/// "surfaceSpace" (what the surfaces are drawn over, in PoseSubset's order), "targetScene" and those of the
/// rows: ViewBar, HeldControls, ExportBar, CutControls, PickedPanel.
class SurfacesView : public QWidget {
    Q_OBJECT

public:
    explicit SurfacesView(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    /// Surfaces of the verdict's targets, held as its pose is unless a slider holds another value.
    void setVerdict(const JointVerdict& verdict);
    void setStale(bool stale);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Whether runs may get another start now; `why` not.
    void setStartable(bool startable, const QString& why);

    /// What the export's dialogs end in.
    void savePicture(const QString& path, QSize size);
    void saveAnimation(const QString& folder, QSize size);

signals:
    /// The point picked shall be where runs start.
    void startWanted(const bask::Vector6d& pose);
    void problem(const QString& sentence);
    void told(const QString& sentence);

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
        std::vector<Isosurface> surfaces;
        Error problem; ///< without a code: none
    };
    void connectControls();
    PoseSubset subset() const;
    bool ready() const;
    Vector6d foundPose() const;
    Vector6d fixedPose() const;
    std::optional<Sweep> sweep() const;
    void compute();
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
    std::array<std::optional<double>, 6> m_fixedManually; ///< others are as the verdict's pose
    std::shared_ptr<const Fields> m_fields; ///< of the experiment, m_fieldsFixed and m_fieldsSubset
    Vector6d m_fieldsFixed = Vector6d::Zero();
    PoseSubset m_fieldsSubset = PoseSubset::Translation;
    bool m_stale = false;  ///< the verdict
    bool m_behind = false; ///< the surfaces, behind the verdict
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
