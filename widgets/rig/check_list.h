#pragma once
// The conditions for a run, ticked or crossed, and the engine's reasons in full.

#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/runtime/snapshot.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;

namespace bask {

/// Object names: "check.devices", "check.place", "check.sensors", "check.source", "check.recording" and
/// "reason.0" ...; each label's accessible description says what its mark does.
class CheckList : public QWidget {
    Q_OBJECT

public:
    explicit CheckList(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void apply(const Snapshot& snapshot);
    void setTemperatureUnit(TemperatureUnit unit);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Kind { Done, Wrong, Waiting, Unknown, Reason };
    struct Line {
        QLabel *mark, *text;
        int shown = -1;   ///< kind of the drawn mark
        int priority = 0; ///< of the drawn mark of a reason
    };
    Line addLine(const QString& name);
    void put(Line& line, Kind kind, const QString& text, int priority = 0);
    void refresh();
    void showDevices();
    bool isDeviceNeeded(DeviceRole role) const;
    void showPlace();
    void showSensors();
    void showSource();
    void showRecording();

    Snapshot m_last;
    double m_period_s = 1.0;
    bool m_hasSensors = true, m_isReadByCamera = false;
    double m_setPoint_K = 0.0;
    std::optional<RigSpec> m_rig;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QLabel* m_title;
    QGridLayout* m_grid;
    Line m_devices, m_place, m_sensors, m_source, m_recording;
    std::vector<Line> m_reasons;
};

} // namespace bask
