#pragma once
// What a run was worth in numbers, a row a metric and a column an object, each with its definition.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QStringList>
#include <QWidget>

class QLabel;
class QTableWidget;

namespace bask {

/// Object names: "metricsTable" (copied with Ctrl+C as tab-separated text), "metricsDetails".
class MetricsPanel : public QWidget {
    Q_OBJECT

public:
    explicit MetricsPanel(QWidget* parent = nullptr);

    /// Names in the order of the metrics' objects.
    void setMetrics(const QStringList& names, RunMetrics metrics);
    void clear();
    void setTemperatureUnit(TemperatureUnit unit);

signals:
    /// The definitions in full are wanted.
    void detailsRequested();

protected:
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void refresh();

    QStringList m_names;
    RunMetrics m_metrics;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QTableWidget* m_table;
    QLabel* m_details;
};

} // namespace bask
