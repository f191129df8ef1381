#pragma once
// The bar that is always visible: SIMULATED or LIVE, the run's state, its verbs in order of use, the clock,
// the gravest alarm, STOP.

#include "app/actions.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace bask {

class AlarmButton;
class RunStateChip;
class StopButton;

/// Object names: "rigTag", "runStateChip", "armButton" and "startButton" (but for faults), "holdButton" (Hold
/// or Resume), "stopRunButton", "resetButton" (only while it can be pressed), "runClock", "alarmButton" (only
/// with alarms), "stopButton".
class StateBar : public QFrame {
    Q_OBJECT

public:
    explicit StateBar(Actions& actions, QWidget* parent = nullptr);

    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);
    void setTemperatureUnit(TemperatureUnit unit);
    RunStateChip* chip() const { return m_chip; }

signals:
    void stopRequested();
    void reasonActivated(int index);
    void alarmChosen(quint64 id);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* makeButton(QAction* action, const char* name);
    void fitVerbs(bool hasAlarms);
    void showTag();
    void showChip();
    void retranslate();

    Actions& m_actions;
    bool m_simulated = true;
    bool m_answering = true;
    RunState m_state = RunState::Idle;
    std::vector<Message> m_reasons;
    QFrame* m_tag;
    QLabel* m_tagIcon;
    QLabel* m_tagWord;
    RunStateChip* m_chip;
    QToolButton *m_arm, *m_start, *m_hold, *m_stop, *m_reset;
    QLabel* m_clockCaption;
    QLabel* m_clock;
    AlarmButton* m_alarm;
    StopButton* m_emergency;
};

} // namespace bask
