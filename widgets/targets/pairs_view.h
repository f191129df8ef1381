#pragma once
// Maps of all pairs of objects: which of their temperatures can be combined, and where the targets are.

#include "engine/base/result.h"
#include "engine/base/units.h"
#include "engine/control/reachable_pairs.h"
#include "engine/model/experiment.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace bask {

class ReachMap;

/// Passive; the provider of the maps gets `wanted` when the view is shown or hidden. Object names, i being
/// the map from 0: "map<i>", "mapsNote", "exportMaps".
class PairsView : public QWidget {
    Q_OBJECT

public:
    explicit PairsView(QWidget* parent = nullptr);

    /// Shows maps as stale if the experiment differs by more than its targets.
    void setExperiment(const Experiment& experiment);
    /// Sets the maps of the experiment: one for each pair, first < second, in lexical order; none if no pose
    /// is allowed.
    void setMaps(const std::vector<ReachableMap>& maps);
    void setTemperatureUnit(TemperatureUnit unit);
    void setEditable(bool editable);

    /// Exports each map as a table (as `bask feasibility --reachable` writes it) and a picture, off the GUI
    /// thread, and reports when it is done. Refuses to replace other files, and then writes none.
    void exportTo(const QString& folder);

signals:
    /// Targets for two objects, while they are dragged: they may still change.
    void targetsDragged(int first, int second, double first_K, double second_K);
    void targetsPicked(int first, int second, double first_K, double second_K);
    /// The dragged targets were not chosen.
    void dragDropped();
    void wanted(bool shown);
    void problem(const QString& sentence);
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void buildMaps();
    void arrange();
    void askAndExport();
    void showAll();

    Experiment m_experiment;
    std::vector<ReachableMap> m_made;
    bool m_stale = true; ///< m_made belongs to other objects, source or robot
    bool m_editable = true;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    LatestJob<Result<void>> m_export;

    std::vector<ReachMap*> m_maps;
    QLabel* m_caption;
    QLabel* m_rareColour;
    QLabel* m_rare;
    QLabel* m_few;
    QLabel* m_colours;
    QLabel* m_many;
    QPushButton* m_exportButton;
    QLabel* m_note;
    QScrollArea* m_scroll;
    QGridLayout* m_grid;
};

} // namespace bask
