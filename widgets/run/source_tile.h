#pragma once
// The source of a run in one line: temperature, trend in the words of the objects' tiles, set point, rate.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/device_words.h"
#include "widgets/common/object_tile.h"
#include "widgets/common/reading_trend.h"

#include <QFrame>

class QLabel;

namespace bask {

/// A temperature that is not known, or no longer, is grey with its age; a source that heats unasked says so
/// in place of its trend. Object names: "sourceTile"; inside "sourceTileState", "sourceTileTemperature",
/// "sourceTileAge", "sourceTileSetPoint", "sourceTileRate".
class SourceTile : public QFrame {
    Q_OBJECT

public:
    explicit SourceTile(QWidget* parent = nullptr);

    /// Goes back to "no reading yet".
    void clear();
    void apply(const Snapshot& snapshot);
    void setTemperatureUnit(TemperatureUnit unit);
    ObjectActivity activity() const { return m_activity; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    ObjectActivity judge() const;
    void showState();
    void showValues();
    void retranslateUi();
    void restyle();

    ReadingTrend m_trend;
    std::optional<double> m_now_K; ///< empty if it is not known
    double m_last_K, m_age_s, m_goal_K;
    double m_read_s; ///< time of the newest reading on the rig's clock
    ObjectActivity m_activity = ObjectActivity::Waiting;
    ShownHeat m_heat = ShownHeat::Unknown;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_name, *m_stateIcon, *m_state, *m_temperature, *m_age;
    QLabel *m_setPointCaption, *m_setPoint, *m_rateCaption, *m_rate;
};

} // namespace bask
