#pragma once
// The first five minutes, as in the manual: one task at a time, which is ticked when it is done.

#include "app/edit_history.h"
#include "engine/base/units.h"
#include "engine/runtime/snapshot.h"

#include <QObject>

#include <optional>

namespace bask {

class MessageBar;

/// Shown in a bar above the pages; it never does anything itself and never blocks a person. For a simulated
/// rig only; its last steps are about a rig at serial ports that `bask simulate-rig` plays.
class Coach : public QObject {
    Q_OBJECT

public:
    enum class Step {
        Harmonics,
        Undo,
        TooHot,
        Feasible,
        Arm,
        Start,
        Note,
        Gain,
        Fault,
        Acknowledge,
        Restore,
        Resume,
        Stop,
        Review,
        Thermal,
        SerialRig,
        Connect,
        Find
    };
    static constexpr int kSteps = 18;

    explicit Coach(MessageBar& bar, QObject* parent = nullptr);

    /// Asks whether to begin.
    void offer();
    void begin();
    /// The current step; empty if it has not begun or has ended.
    std::optional<Step> step() const { return m_step; }

    // What a person did
    void see(const EditStep& edit);
    void seeUndone(const EditStep& edit);
    void seeVerdict(bool isFeasible);
    void see(const Snapshot& snapshot);
    void seeReview();
    void seeThermalPicture();

    void setTemperatureUnit(TemperatureUnit unit);
    void retranslate();

signals:
    /// Where the current step is done: a page, and a control on it by its object name if there is one.
    void showWanted(bask::Page page, const QString& control);
    /// The offer was answered, or the bar closed: do not ask again.
    void answered();

private:
    void done(Step step);
    void seeDevices(const Snapshot& snapshot);
    bool isRunOver() const;
    void say();
    QString words() const;
    void act();
    void skip();
    void end();

    MessageBar& m_bar;
    bool m_isOffer = false;
    std::optional<Step> m_step;
    bool m_isHarmless = true; ///< the rig is simulated, or its devices are
    RunState m_state = RunState::Idle;
    bool m_hasRun = false; ///< a run has begun since the coach began
    bool m_isFaultOn = false;
    bool m_hasFound = false; ///< a search for devices has found one since it was told how
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
