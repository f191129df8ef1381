#pragma once
// One object of a run: its line's sample, temperature, target, error, rate, and its activity in a word.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/reading_trend.h"

#include <QFrame>

#include <limits>
#include <vector>

class QLabel;
class QPushButton;

namespace bask {

/// The activity of an object, from its newest reading; or why it is not known.
enum class ObjectActivity {
    Waiting,
    SensorInvalid,
    SensorStale,
    SensorDistrusted,
    Heating,
    Cooling,
    Steady,
    Settling,
    Settled,
    AboveWarning, ///< above its warning limit, whatever it does there
    AboveTrip
};

/// How far an object's reading is trusted by the engine.
struct SensorView {
    SensorTrust trust = SensorTrust::Trusted;
    double age_s = std::numeric_limits<double>::infinity(); ///< age of the newest accepted reading
    /// newest value, trusted or not; NaN if there is none
    double told_K = std::numeric_limits<double>::quiet_NaN();
    /// standard uncertainty of the reading; NaN if it is not known
    double uncertainty_K = std::numeric_limits<double>::quiet_NaN();
    /// how long its alarm says that the value has been the same, s; NaN without such an alarm
    double sameFor_s = std::numeric_limits<double>::quiet_NaN();
    bool operator==(const SensorView&) const = default;
};

/// What a tile shows of its object: other views of the same run show this and judge nothing again.
struct ShownObject {
    static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN(); ///< shown as a dash

    QString name;
    ObjectActivity activity = ObjectActivity::Waiting;
    double temperature_K = kNothing; ///< of an unknown one the last that was told
    double target_K = kNothing;
    /// Of a reading that is not known, of a frozen one how long it has been the same; empty if there was
    /// none, and for the newest reading, which is not believed.
    QString age;
    int decimals = 1; ///< of its temperatures: what the uncertainty of its readings allows

    /// Returns "+0.3 K", that of the two temperatures as they are shown; a dash without a known reading.
    QString errorText(TemperatureUnit unit) const;
};

/// A temperature that is not, or no longer, known is grey with its age, see ShownObject; an untrusted one is
/// struck out, and a person can confirm it. Object names: the tile "objectTile.<index>"; inside "tileName",
/// "tileState", "tileTemperature", "tileAge", "confirmSensor", "tileTarget", "tileError", "tileRate".
class ObjectTile : public QFrame {
    Q_OBJECT
public:
    static constexpr double kSettledAfter_s = 10.0; ///< time in the band before the word is "Settled"

    explicit ObjectTile(int index, QWidget* parent = nullptr);

    void setName(const QString& name);
    /// Above these, K, the tile has the colour, the mark and the word of the limit; infinite at first.
    void setLimits(double warning_K, double trip_K);
    /// `time_s` is the time of the reading on any clock: it determines how long the object has been in its
    /// band.
    void setSample(double time_s, const ObjectSample& sample, const SensorView& sensor = {});
    /// Shows any moment of a record: row `k`, with this object as number `i` in each row. Its activity is
    /// judged as during the run, which needs the rows of the last kSettledAfter_s and the one before.
    void setMoment(const std::vector<TraceSample>& samples, std::size_t k, std::size_t i);
    /// Sets the standard uncertainty of a record's readings, K; NaN: it is not known.
    void setRecordedUncertainty(double u_K);
    /// Goes back to "no reading yet" and shows this target.
    void clear(double target_K);
    void setTemperatureUnit(TemperatureUnit unit);
    ObjectActivity activity() const { return m_activity; }
    ShownObject shown() const;

    static QString targetWord(); ///< "Target"
    static QString errorWord();  ///< "Error"
    /// Returns "Object bunny", for a screen reader.
    static QString nameWords(const QString& name);

signals:
    /// A person confirms that the sensor is correct.
    void confirmRequested();

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslateUi();
    void restyle();
    void showValues();
    void showTemperature(const ShownObject& now);
    QString cameraText() const;
    QString ageText() const;
    QString uncertaintyTip() const;
    QString uncertaintyText() const;
    void takeUncertainty();
    ObjectActivity judge(double time_s, const ObjectSample& sample);
    void takeRate(double time_s, const ObjectSample& sample);

    int m_index;
    QString m_name;
    ObjectSample m_sample;
    SensorView m_sensor;
    double m_believed_K = std::numeric_limits<double>::quiet_NaN(); ///< newest reading that was believed
    double m_recorded_K = std::numeric_limits<double>::quiet_NaN(); ///< uncertainty of a record's readings
    /// the standard uncertainty that is told, in the reader's unit
    double m_told_u = std::numeric_limits<double>::quiet_NaN();
    int m_decimals = 1;
    ObjectActivity m_activity = ObjectActivity::Waiting;
    double m_inBandSince_s = -1.0;
    double m_warning_K = std::numeric_limits<double>::infinity();
    double m_trip_K = std::numeric_limits<double>::infinity();
    ReadingTrend m_trend;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel *m_swatch, *m_nameLabel, *m_stateIcon, *m_stateLabel, *m_temperature, *m_age;
    QPushButton* m_confirm;
    QLabel *m_targetCaption, *m_errorCaption, *m_rateCaption, *m_target, *m_error, *m_rate;
};

QString activityWord(ObjectActivity activity);
/// Returns the mark beside the word.
QPixmap activityPixmap(ObjectActivity activity, bool dark, const QColor& ink, double devicePixelRatio);
/// Returns the priority of the alarm that tells the same, with whose mark and colour it is shown; 0 for none.
int activityPriority(ObjectActivity activity);
/// Paints ground and frame of a tile as its object's state asks for: a limit in its alarm's colour, what is
/// not known with a frame of dashes. `frame`: its width, px.
void paintTileGround(QPainter& painter, const QWidget& tile, ObjectActivity activity, double frame);
/// Returns whether the object's temperature is not known.
bool isUnknown(ObjectActivity activity);

} // namespace bask
