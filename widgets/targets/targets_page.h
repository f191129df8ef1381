#pragma once
// The Targets page: whether all can be held together, why not, and the nearest targets that can; a row for
// each object with its target, the reachable range and the verdict in words.

#include "engine/base/units.h"
#include "engine/control/reachable_pairs.h"
#include "engine/model/mounting_check.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QTabWidget;

namespace bask {

class PairsView;
class QuantitySpinBox;
class ReachBar;
class SurfacesView;

/// Setters in, signals out. A verdict counts only for the target it was made for: a row edited since is shown
/// as stale, as are all between setStale(true) and the next setVerdicts. The rows scroll under the verdict on
/// all of them, which is always seen.
///
/// Object names for tests, i being the row from 0: "target<i>" (spin box), "reach<i>" (bar), "verdict<i>"
/// (word), "verdictDetail<i>", "nearest<i>" (button), "keep<i>"; "jointVerdict", "jointDetail", "useNearest",
/// "infeasibleNote", "targetsNote", "targetViews" (tabs) and those of SurfacesView and PairsView.
class TargetsPage : public QWidget {
    Q_OBJECT

public:
    explicit TargetsPage(QWidget* parent = nullptr);
    ~TargetsPage() override;

    void setExperiment(const Experiment& experiment);
    /// Sets the verdict on the experiment's objects, in their order; one with another number of objects
    /// counts as none. `shade`: who shades whom at its pose.
    void setVerdict(const JointVerdict& verdict, const std::vector<MountingRemark>& shade = {});
    void setStale(bool stale);
    /// Sets the prediction for the shown verdict, after predictionWanted(): the time when all have settled on
    /// the simulated rig; empty if not within the experiment's duration limit.
    void setPrediction(const std::optional<double>& settling_s);
    /// Removes the prediction, which is no longer valid although the verdict is; requests another one.
    void dropPrediction();
    /// Sets the maps of all pairs of the experiment's objects.
    void setPairs(const std::vector<ReachableMap>& maps);
    /// Sets whether targets may be edited, also during a run; `why` is shown if they may not.
    void setEditable(bool editable, const QString& why = {});
    /// Sets whether the start of runs may be changed now; `why`: why not.
    void setStartable(bool startable, const QString& why = {});
    void setTemperatureUnit(TemperatureUnit unit);

    std::vector<double> targets_K() const;
    /// Targets that the nearest feasible ones must keep.
    std::vector<bool> kept() const;
    /// Keeps no target; for another experiment.
    void clearKept();

signals:
    void targetsEdited(const std::vector<double>& targets_K);
    /// Targets while one is typed or dragged: their verdict is wanted, no more. At the end follows
    /// targetsEdited, unless they are as before, or triesDropped: the drag was broken off, and the page wants
    /// the experiment as it is.
    void targetsTried(const std::vector<double>& targets_K);
    void triesDropped();
    /// A prediction is wanted: the targets can be held and the page is visible.
    void predictionWanted();
    void keptChanged(const std::vector<bool>& kept);
    void startWanted(const bask::Vector6d& pose);
    void pairsWanted(bool shown);
    void problem(const QString& sentence);
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    struct Row;
    void buildRows();
    void addRow(int index);
    void editTarget(std::size_t row, double target_K);
    void tryTarget(std::size_t row, double target_K);
    void commit();
    void askPrediction();
    void useNearest(std::size_t row);
    void useNearestTogether();
    void dragPair(int first, int second, double first_K, double second_K);
    bool rowStale(std::size_t row) const;
    void showRow(std::size_t row);
    void showAxis();
    void showJoint();
    QString objectName(std::size_t row) const;
    QString jointDetail() const;
    QString predictionText() const;
    void showAll();
    void refreshTexts();

    Experiment m_experiment;       ///< the experiment with the shown targets, perhaps only tried
    std::vector<double> m_given_K; ///< its targets as last set or sent
    std::optional<JointVerdict> m_verdict;
    std::vector<MountingRemark> m_shade; ///< at its pose
    bool m_stale = true;
    /// prediction for the verdict; empty if not known yet
    std::optional<std::optional<double>> m_prediction_s;
    bool m_editable = true;
    QString m_why;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;

    std::vector<Row> m_rows;
    QWidget* m_table = nullptr;
    QGridLayout* m_grid = nullptr;
    std::vector<QLabel*> m_headers;
    QLabel* m_title;
    QLabel* m_note;
    QLabel* m_jointIcon;
    QLabel* m_joint;
    QLabel* m_jointDetail;
    QPushButton* m_useNearest;
    QLabel* m_explanationTitle;
    QLabel* m_explanation;
    QLabel* m_infeasibleTitle;
    QLabel* m_infeasible;
    SurfacesView* m_surfaces;
    PairsView* m_pairs;
    QTabWidget* m_views;
};

} // namespace bask
