#pragma once
// Table of how a run ended: per object its target, final temperature, error and settling time.

#include "engine/base/units.h"
#include "engine/recording/run_metrics.h"

#include <QTableWidget>

#include <optional>

namespace bask {

/// How one object ended. NaN where nothing is known.
struct FinalValue {
    QString name;
    double target_K = 0.0;
    double final_K = 0.0;
    bool isTrue = false; ///< the plant's own temperature, else the estimate
    std::optional<double> settling_s;
};
std::vector<FinalValue> finalValues(const QStringList& names, const RunMetrics& metrics);

/// One row an object; read-only, copied with Ctrl+C as tab-separated text.
class FinalValuesTable : public QTableWidget {
    Q_OBJECT

public:
    explicit FinalValuesTable(QWidget* parent = nullptr);

    void setValues(std::vector<FinalValue> values);
    void setTemperatureUnit(TemperatureUnit unit);

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void refresh();

    std::vector<FinalValue> m_values;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
