#pragma once
// The metrics of a run, a row for each metric and a column for each object, with definitions.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QTableWidget;

namespace bask {

/// Where the columns do not fit beside each other, names and numbers take several lines. Object names:
/// "metricsTable" (copied with Ctrl+C as tab-separated text), "metricsDetails".
class MetricsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MetricsPanel(QWidget* parent = nullptr);

    /// Sets the metrics; names in the order of their objects.
    void setMetrics(const QStringList& names, RunMetrics metrics);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// The full definitions were requested.
    void detailsRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();
    void fit(); ///< columns and rows to the room

    QStringList m_names;
    RunMetrics m_metrics;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QTableWidget* m_table;
    QLabel* m_details;
};

} // namespace bask
