#pragma once
// The replay of a recorded run: transport, tiles, traces and scene, with the widgets of the Run page.

#include "engine/base/clock.h"
#include "engine/base/message.h"
#include "engine/base/units.h"
#include "engine/recording/recorded_session.h"
#include "widgets/review/overlaid_runs.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QGridLayout;
class QTabWidget;

namespace bask {

class ComparisonView;
class PlotPlace;
class TileGrid;
class RecordedPictures;
class SceneView;
class ThermalPictureView;
class TracePlot;
class TransportBar;

/// Object names: those of TransportBar; tiles "reviewTile.<i>"; plots "review." and the key of their column
/// or "speed" ("review.measured_K"), their tabs "reviewTabs", that of "review.shade" where an object may be
/// in the shade of another; "reviewScene" once it was looked at;
/// "reviewPicture" of a run with thermal pictures; with overlays those of ComparisonView, a button to
/// take each away "overlay.<letter>", and "overlayExport".
class ReplayView : public QWidget {
    Q_OBJECT

public:
    static constexpr int kMaxOverlays = 4;

    explicit ReplayView(QWidget* parent = nullptr);
    ~ReplayView() override;

    /// Shows a run from its beginning, paused, without overlays. Its samples are read when they are shown.
    void setRun(std::shared_ptr<RecordedSession> run);
    /// Sets some samples of the whole run: the path of the objects in the scene.
    void setWay(std::vector<TraceSample> way);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

    /// Draws another run over this one. Returns false if there is no room, or it is already shown.
    bool addOverlay(std::shared_ptr<RecordedSession> run);
    void removeOverlay(const QString& path);
    /// Whether the run of this file lies over the open one.
    bool isOver(const QString& path) const;
    /// Sets the metrics of the open run or of one over it, for their comparison; null: they cannot be
    /// computed.
    void setMetrics(const QString& path, const RunMetrics* metrics);
    /// Returns an overlay whose metrics are not known yet, other than that of a path; null if there is none.
    std::shared_ptr<RecordedSession> uncounted(const QString& except = {}) const {
        return m_runs.uncounted(except);
    }
    ComparisonView* comparison() const { return m_comparison; }

    /// Moves the replay there, and also plots that do not show that moment.
    void seek(double time_s);
    void togglePlay();
    void pause();
    double position_s() const;

signals:
    /// A moment of the run cannot be read; sent once for each run.
    void readFailed(const bask::Error& error);
    void overlaysChanged();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Plot {
        PlotPlace* place;
        TracePlot* plot;
        bool isFilled; ///< a plot is filled when it is first shown
    };

    PlotPlace* makePlot(Quantity quantity);
    void connectPlots();
    void fill(Plot& plot);
    void fillShown();
    void makeScene();
    void fillScene();
    void moveTo(double time_s);
    void showMoment(double time_s);
    void nameRun();
    void showScene();
    void showPictureTab();
    void showPicture(double time_s);
    void tellFailure(const Error& error);
    void showOverlays();
    void nameOverlays();
    void showLegend(const QStringList& keys);
    void showComparison();
    void clearTiles();
    void addMarkers(TracePlot& plot) const;
    void showTiles(double time_s);
    bool isSceneShown() const;
    void retranslate();

    SteadyClock m_clock;
    OverlaidRuns m_runs;
    std::shared_ptr<RecordedSession> m_run; ///< the open one; null if there is none
    std::vector<TraceSample> m_way;
    QStringList m_names;
    std::optional<TraceSample> m_sample; ///< the shown sample
    bool m_isFailureTold = false;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    /// visible range of the time axis; empty for the whole run
    std::optional<std::pair<double, double>> m_visible_s;

    TransportBar* m_transport;
    QWidget* m_legend;
    QGridLayout* m_legendLayout;
    TileGrid* m_tiles;
    std::vector<Plot> m_plots; ///< temperature first, then the tabs' in order
    QTabWidget* m_tabs = nullptr;
    int m_shadeTab = -1;
    QWidget* m_sceneTab;
    SceneView* m_scene = nullptr;
    ThermalPictureView* m_picture; ///< in no tab without thermal pictures
    std::unique_ptr<RecordedPictures> m_pictures;
    ComparisonView* m_comparison; ///< in no tab without overlays
};

} // namespace bask
