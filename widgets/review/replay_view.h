#pragma once
// A recorded run played again: transport, tiles, traces and scene, by the widgets of the Run page.

#include "engine/base/clock.h"
#include "engine/base/message.h"
#include "engine/base/units.h"
#include "engine/recording/recorded_session.h"

#include <QWidget>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QGridLayout;
class QTabWidget;

namespace bask {

class TileGrid;
class SceneView;
class TracePlot;
class TransportBar;

/// Object names: those of TransportBar; tiles "reviewTile.<i>"; plots "review." and the key of their column
/// or "speed" ("review.measured_K"), their tabs "reviewTabs"; "reviewScene" once it was looked at; a button
/// to take an overlay away "overlay.<letter>".
class ReplayView : public QWidget {
    Q_OBJECT

public:
    static constexpr int kMaxOverlays = 4;

    explicit ReplayView(QWidget* parent = nullptr);
    ~ReplayView() override;

    /// Shows a run from its beginning, paused, without overlays. Its samples are read where they are looked
    /// at.
    void setRun(std::shared_ptr<RecordedSession> run);
    /// Some samples of the whole run: the way of the objects in the scene.
    void setWay(std::vector<TraceSample> way);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

    /// Draws another run over this one, if there is room: false when there is none, or when it is there
    /// already.
    bool addOverlay(std::shared_ptr<RecordedSession> run);
    void removeOverlay(const QString& path);

    /// Moves the replay there, and the plots where they do not show that moment.
    void seek(double time_s);
    void togglePlay();
    void pause();
    double position_s() const;

signals:
    /// A moment of the run cannot be read; told once a run.
    void readFailed(const bask::Error& error);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Plot {
        TracePlot* plot;
        bool isFilled; ///< a plot is filled when it is looked at first
    };
    struct Overlay {
        std::shared_ptr<RecordedSession> run;
        QString mark;
    };

    TracePlot* makePlot(Quantity quantity);
    void connectPlots();
    void fill(Plot& plot);
    void fillShown();
    void makeScene();
    void fillScene();
    void showMoment(double time_s);
    void showScene();
    void showOverlays();
    void clearTiles();
    void addMarkers(TracePlot& plot) const;
    void showTiles(double time_s);
    bool isSceneShown() const;
    void retranslate();

    SteadyClock m_clock;
    std::shared_ptr<RecordedSession> m_run; ///< null: none
    std::vector<TraceSample> m_way;
    std::vector<Overlay> m_overlays;
    QStringList m_names;
    std::optional<TraceSample> m_sample; ///< shown
    bool m_isFailureTold = false;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    std::optional<std::pair<double, double>> m_visible_s; ///< on the time axis; empty: the whole run

    TransportBar* m_transport;
    QWidget* m_legend;
    QGridLayout* m_legendLayout;
    TileGrid* m_tiles;
    std::vector<Plot> m_plots; ///< temperature first, then the tabs' in order
    QTabWidget* m_tabs = nullptr;
    QWidget* m_sceneTab;
    SceneView* m_scene = nullptr;
};

} // namespace bask
