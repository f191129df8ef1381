#pragma once
// The Targets page: a row per object with its target, the range that can be reached and the verdict in words;
// whether all can be held together, why not, and the nearest targets that can.

#include "engine/base/units.h"
#include "engine/control/reachable_pairs.h"
#include "engine/model/experiment.h"

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
/// as stale, as are all between setStale(true) and the next setVerdicts.
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
    /// Of the experiment's objects, in their order; of another number of them it is taken as none.
    void setVerdict(const JointVerdict& verdict);
    void setStale(bool stale);
    /// Of the verdict shown, once predictionWanted() is answered: when all have settled on the simulated rig;
    /// empty: not within the experiment's duration limit.
    void setPrediction(const std::optional<double>& settling_s);
    /// The prediction does not hold any more, although the verdict does; asks for another.
    void dropPrediction();
    /// Maps of all pairs of the experiment's objects.
    void setPairs(const std::vector<ReachableMap>& maps);
    /// Targets may be edited during a run too; `why` is shown when they may not.
    void setEditable(bool editable, const QString& why = {});
    /// Whether runs may get another start now; `why` not.
    void setStartable(bool startable, const QString& why = {});
    void setTemperatureUnit(TemperatureUnit unit);

    std::vector<double> targets_K() const;
    /// Targets that the nearest feasible ones shall leave as they are.
    std::vector<bool> kept() const;
    /// Of another experiment none is.
    void clearKept();

signals:
    void targetsEdited(const std::vector<double>& targets_K);
    /// Targets while one is typed or dragged: their verdict is wanted, no more. At the end follows
    /// targetsEdited, unless they are as before, or triesDropped: the drag was broken off, and the page wants
    /// the experiment as it is.
    void targetsTried(const std::vector<double>& targets_K);
    void triesDropped();
    /// The targets can be held and the page is looked at.
    void predictionWanted();
    void keptChanged(const std::vector<bool>& kept);
    void startWanted(const bask::Vector6d& pose);
    void pairsWanted(bool shown);
    void problem(const QString& sentence);
    void told(const QString& sentence);

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

    Experiment m_experiment;       ///< its targets as they are shown, perhaps only tried
    std::vector<double> m_given_K; ///< its targets as they were given or told last
    std::optional<JointVerdict> m_verdict;
    bool m_stale = true;
    std::optional<std::optional<double>> m_prediction_s; ///< of the verdict; empty: not known yet
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
