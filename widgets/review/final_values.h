#pragma once
// Table of the final values of a run: for each object its target, final reading, error and settling time, and
// the true temperature where it is recorded.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QStringList>
#include <QTableWidget>

#include <optional>

namespace bask {

/// The final values of one object; NaN if unknown.
struct FinalValue {
    QString name;
    double target_K = 0.0;
    double final_K = 0.0; ///< by its thermometer
    double true_K = 0.0;
    std::optional<double> settling_s;
    int decimals = 2; ///< of what was read, as metricDecimals
};
std::vector<FinalValue> finalValues(const QStringList& names, const RunMetrics& metrics,
                                    TemperatureUnit unit);

/// One row for each object; read-only, copied with Ctrl+C as tab-separated text.
class FinalValuesTable : public QTableWidget {
    Q_OBJECT

public:
    explicit FinalValuesTable(QWidget* parent = nullptr);

    /// Without objects in `metrics`: no rows.
    void setRun(const QStringList& names, const RunMetrics& metrics);
    void setTemperatureUnit(TemperatureUnit unit);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();

    QStringList m_names;
    RunMetrics m_metrics;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
