#pragma once
// One object of a run at a glance: its line's sample, temperature, target, error, rate and what it is doing,
// in a word.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"

#include <QFrame>

#include <deque>
#include <limits>
#include <utility>
#include <vector>

class QLabel;
class QPushButton;

namespace bask {

/// What an object is doing, judged from its newest reading; or why nobody knows.
enum class ObjectActivity {
    Waiting,
    SensorInvalid,
    SensorStale,
    SensorDistrusted,
    Heating,
    Cooling,
    Steady,
    Settling,
    Settled
};

/// How far an object's reading is believed, as the engine tells.
struct SensorView {
    SensorTrust trust = SensorTrust::Trusted;
    double age_s = std::numeric_limits<double>::infinity();   ///< of the newest believed reading
    double told_K = std::numeric_limits<double>::quiet_NaN(); ///< newest value, believed or not; NaN: none
    bool operator==(const SensorView&) const = default;
};

/// A temperature that is not known, or no more, is grey with its age; one that is not believed is struck out,
/// and a person can confirm it. Object names: the tile "objectTile.<index>"; inside "tileName", "tileState",
/// "tileTemperature", "tileAge", "confirmSensor", "tileTarget", "tileError", "tileRate".
class ObjectTile : public QFrame {
    Q_OBJECT
public:
    static constexpr double kSettledAfter_s = 10.0; ///< in the band before the word is "Settled"
    static constexpr double kRateOver_s = 10.0;     ///< the rate shown and judged is the mean of so long

    explicit ObjectTile(int index, QWidget* parent = nullptr);

    void setName(const QString& name);
    /// `time_s` is that of the reading, of any clock: it tells how long the object has been in its band.
    void setSample(double time_s, const ObjectSample& sample, const SensorView& sensor = {});
    /// Any moment of a record: row `k`, this object being number `i` of each. What it was doing is judged as
    /// it would have been live, which takes the rows of the last kSettledAfter_s and the one before.
    void setMoment(const std::vector<TraceSample>& samples, std::size_t k, std::size_t i);
    /// Back to "no reading yet"; the target is kept.
    void clear(double target_K);
    void setTemperatureUnit(TemperatureUnit unit);
    ObjectActivity activity() const { return m_activity; }

signals:
    /// A person says that the sensor is right.
    void confirmRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslateUi();
    void restyle();
    void showValues();
    void showTemperature();
    ObjectActivity judge(double time_s, const ObjectSample& sample);
    void takeRate(double time_s, const ObjectSample& sample);
    double rate_K_s() const; ///< NaN: none

    int m_index;
    QString m_name;
    ObjectSample m_sample;
    SensorView m_sensor;
    ObjectActivity m_activity = ObjectActivity::Waiting;
    double m_inBandSince_s = -1.0;
    std::deque<std::pair<double, double>> m_rates; ///< of the last kRateOver_s: time, K/s
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_swatch, *m_nameLabel, *m_stateIcon, *m_stateLabel, *m_temperature, *m_age;
    QPushButton* m_confirm;
    QLabel *m_targetCaption, *m_errorCaption, *m_rateCaption, *m_target, *m_error, *m_rate;
};

QString activityWord(ObjectActivity activity);
/// Its temperature is not known.
bool isUnknown(ObjectActivity activity);

} // namespace bask
