#pragma once
// View > Large numbers: a run as it is read from across the room, on a second screen.

#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/object_tile.h"

#include <QWidget>

#include <vector>

namespace bask {

class LargeText;
class LargeTile;
class StopButton;

/// A window of its own. F11 makes it fill the screen, F11 or Esc ends that; Esc closes one that does not.
/// With one to four objects a figure of a temperature is at least an eighth of a wide screen's height; the
/// letters of a short state and of STOP are nearly a tenth of the window's. Everything is as large as the
/// window allows, and nothing moves when an alarm comes, but that a countdown takes a part of the alarm's
/// line. Object names: "largeNumbersWindow"; "largeRig" (SIMULATED or LIVE), "largeState", "largeClock",
/// "largeSource", "largeHeat", "largeCountdown" (while the engine will act by itself), "largeAlarm",
/// "largeStop"; its tiles "largeTile.<i>" (see there).
class LargeNumbers : public QWidget {
    Q_OBJECT
public:
    explicit LargeNumbers(QWidget* parent = nullptr);

    /// `objects` as the tiles of the Run page show them.
    void apply(const Snapshot& snapshot, const std::vector<ShownObject>& objects, TemperatureUnit unit);
    /// The engine answers no more, or again: what it told last is not shown as if it were so now.
    void setAnswering(bool answering);

signals:
    void stopRequested();

protected:
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void refresh();
    void showState();
    void showSource();
    void showAlarm();
    void showCountdown();
    void closeOrShrink();
    void showTiles();
    void arrange();
    void arrangeTiles(const QRect& room, int gap);
    void sizeStop(QSize room);
    void retranslate();

    bool m_isTold = false; ///< a snapshot has come
    bool m_isAnswering = true;
    Snapshot m_last; ///< only what is shown here
    std::vector<ShownObject> m_objects;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    QColor m_alarmGround; ///< behind the alarm; invalid for none
    QRect m_rigFrame;     ///< around SIMULATED or LIVE
    LargeText *m_rig, *m_state, *m_clock, *m_source, *m_heat, *m_countdown, *m_alarm;
    StopButton* m_stop;
    std::vector<LargeTile*> m_tiles;
};

} // namespace bask
