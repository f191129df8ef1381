#pragma once
// The metrics of the runs that are laid over each other, as a table that can be copied and exported.

#include "engine/base/units.h"
#include "widgets/review/metric_comparison.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace bask {

/// A row for each metric and object, a column for each run and one for its difference from the run that was
/// chosen, at first the open one. Object names: "comparisonTable" (Ctrl+C copies all of it as tab-separated
/// text), "comparisonReference", "comparisonCopy", "comparisonExport", "comparisonNote".
class ComparisonView : public QWidget {
    Q_OBJECT

public:
    explicit ComparisonView(QWidget* parent = nullptr);

    void setRuns(std::vector<ComparedRun> runs);
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// The table was asked for as a file.
    void exportRequested(const QString& csv);
    /// The table is in the clipboard.
    void copied(const QString& sentence);

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void showReferences();
    void showRow(int row, const ComparedMetric& metric);
    void showNote();
    void copy();
    std::size_t reference() const; ///< index of the run that the others are compared with

    std::vector<ComparedRun> m_runs;
    std::vector<ComparedMetric> m_metrics;
    QString m_reference; ///< path of the chosen run; the first one if it is not there
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel* m_caption;
    QComboBox* m_references;
    QPushButton *m_copy, *m_export;
    QTableWidget* m_table;
    QLabel* m_note;
};

} // namespace bask
