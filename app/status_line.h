#pragma once
// The line at the bottom of the window: the source and its heat, as far as known, age of the readings or of
// each device's answers, loop rate and late steps, tracking of the source, recording, unit, language.

#include "engine/base/units.h"
#include "engine/monitor/monitor.h"
#include "engine/runtime/snapshot.h"

#include <QStatusBar>

class QLabel;
class QMenu;
class QToolButton;

namespace bask {

/// Object names: "sampleAge", "loopRate", "monitoring" (while it is on), "sourceState" and "heatWord",
/// "tracking", "recording", "unitButton", "languageButton".
class StatusLine : public QStatusBar {
    Q_OBJECT

public:
    StatusLine(QMenu* unitMenu, QMenu* languageMenu, QWidget* parent = nullptr);

    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);
    void showMonitor(const MonitorState& state);
    void setTemperatureUnit(TemperatureUnit unit);
    void showLanguage(const QString& code);

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();
    void retranslate();
    QString ageText() const;
    QString recordingText() const;
    QString sourceText() const;
    void showHeat();
    void showMonitor();
    QString trackingText() const;

    bool m_answering = true;
    bool m_any = false;
    double m_age_s = 0.0;
    double m_rate_Hz = 0.0;
    std::uint64_t m_late = 0;
    double m_speed = 1.0;
    std::size_t m_rows = 0;
    bool m_isUntilCold = false;
    QString m_recording;
    std::optional<SourceTracking> m_tracking;
    std::vector<RigDeviceState> m_devices; ///< devices of a real rig
    Snapshot m_source;                     ///< state of the source that is shown
    TemperatureUnit m_temperatureUnit = TemperatureUnit::Celsius;
    QLabel* m_ageLabel;
    QLabel* m_loopLabel;
    QLabel* m_sourceLabel;
    QLabel* m_heatMark;
    QLabel* m_heatLabel;
    QLabel* m_trackingLabel;
    QLabel* m_recordingLabel;
    QLabel* m_monitorMark;
    QLabel* m_monitorLabel;
    MonitorState m_monitor;
    QToolButton* m_unit;
    QToolButton* m_language;
};

} // namespace bask
