#pragma once
// The Run page: tiles of the objects and the source, traces, the 3-D scene, controller and gains, notes.

#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/model/predicted_run.h"
#include "engine/runtime/snapshot.h"
#include "engine/thermography/thermal_view.h"
#include "widgets/common/object_tile.h"
#include "widgets/plots/trace_store.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTabWidget;
class QToolButton;

namespace bask {

class ControllerPanel;
class ElidedLabel;
class PlotPlace;
class TileGrid;
class SceneView;
class SourceTile;
class ThermalPictureView;
class TracePlot;

/// Shows what snapshots say and never anything else. Object names: "runPage"; tiles "objectTile.<i>" and
/// "sourceTile"; plots "plot." and the key of their column or "speed" ("plot.measured_K"), their tabs
/// "plotTabs", the last of which is "thermalPictureView" for a rig with a thermal camera, and among which
/// "plot.shade" is where an object may be in the shade of another; "followLive",
/// "followWindow", "showPrediction", "jumpToLive"; "runScene", "viewTop", "viewSide", "viewIsometric";
/// "activeLimits"; "controllerPanel" (see there); "noteEdit", "noteAdd"; "simulationSpeed".
class RunPage : public QWidget {
    Q_OBJECT
public:
    explicit RunPage(QWidget* parent = nullptr);
    ~RunPage() override;

    /// Clears everything and shows the experiment's objects with their targets.
    void setExperiment(const Experiment& experiment);
    /// Takes everything new in the snapshot; a new runId begins a new trace. Cheap: drawing is done later in
    /// the event loop.
    void apply(const Snapshot& snapshot);
    /// Shows the predicted run behind the traces and in the scene; one without samples removes it, as
    /// setExperiment() does.
    void setPrediction(const PredictedRun& run);
    /// Whether its place is on screen: in the page, or in the window of a plot that was taken out.
    bool isPredictionSeen() const;
    /// Whether it is shown there, as a person has chosen.
    bool isPredictionShown() const;
    /// Says whether the engine answers: while it does not nobody knows how hot the source is.
    void setAnswering(bool answering);
    void setTemperatureUnit(TemperatureUnit unit);
    TemperatureUnit temperatureUnit() const { return m_unit; }
    /// Returns what the tiles show now.
    std::vector<ShownObject> shownObjects() const;
    /// Shows a recorded moment on all plots (from the event list).
    void showMoment(double time_s);

public slots:
    /// Shows what the rig's thermal camera sees.
    void setThermalView(const bask::ThermalView& view);

signals:
    /// All of the snapshot is shown.
    void applied(const bask::Snapshot& snapshot);
    void controllerApplied(const bask::ControllerSettings& settings);
    void noteAdded(const QString& text);
    /// A person confirms that the sensor of an object is correct.
    void sensorConfirmed(std::size_t object);
    void simulationSpeedChosen(double factor);
    /// The thermal picture is seen, or no longer.
    void thermalPictureWatched(bool isWatched);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* makePlots();
    QWidget* makeSide();
    PlotPlace* makePlot(Quantity quantity);
    void connectPlots();
    void setFollow(bool follow);
    void showBehind();
    void showScene(const Snapshot& snapshot);
    void showPlan();
    void showTiles(const Snapshot& snapshot);
    void showLimits(const Snapshot& snapshot);
    void showShade(const Snapshot& snapshot);
    void addMarkers(const std::vector<TraceEvent>& events, const std::vector<TraceNote>& notes);
    void beginTrace();
    void showThermalTab(bool hasCamera);
    void nameRun();
    void addNote();
    void retranslateUi();
    void restyle();

    QString m_title; ///< of the experiment
    std::vector<double> m_targets_K;
    std::vector<QString> m_names;
    std::optional<std::uint64_t> m_runId;
    std::vector<TraceEvent> m_events; ///< events of the run, to translate them again
    std::vector<TraceNote> m_notes;
    PredictedRun m_prediction;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;

    TileGrid* m_tiles = nullptr;
    SourceTile* m_source = nullptr;
    std::shared_ptr<TraceStore> m_traces = std::make_shared<TraceStore>(); ///< shared by all plots
    std::vector<TracePlot*> m_plots; ///< temperature first, then those of the tabs
    std::vector<PlotPlace*> m_places;
    QTabWidget* m_tabs = nullptr;
    int m_shadeTab = -1;
    ThermalPictureView* m_thermal = nullptr; ///< in no tab without a thermal camera
    QCheckBox* m_follow = nullptr;
    QLabel* m_windowLabel = nullptr;
    QComboBox* m_window = nullptr;
    QCheckBox* m_showPrediction = nullptr;
    QPushButton* m_jump = nullptr;
    SceneView* m_scene = nullptr;
    QLabel* m_sceneLabel = nullptr;
    QToolButton *m_viewTop = nullptr, *m_viewSide = nullptr, *m_viewIsometric = nullptr;
    QLabel* m_placeMark = nullptr;
    ElidedLabel* m_limits = nullptr; ///< also shows when the robot's position is not known
    QLabel* m_shade = nullptr;       ///< of one object by the others; empty if there is none
    ControllerPanel* m_controller = nullptr;
    QLabel* m_noteLabel = nullptr;
    QLineEdit* m_note = nullptr;
    QPushButton* m_noteAdd = nullptr;
    QWidget* m_speedRow = nullptr;
    QLabel* m_speedLabel = nullptr;
    QComboBox* m_speed = nullptr;
};

} // namespace bask
