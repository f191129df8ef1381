#pragma once
// The bar that is always visible: SIMULATED or LIVE, the run's state, its verbs in order of use, the clock,
// STOP.

#include "app/actions.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace bask {

class RunStateChip;
class StopButton;

/// Object names: "rigTag", "runStateChip", "armButton", "startButton", "holdButton" (Hold or Resume),
/// "stopRunButton", "resetButton" (only while it can be pressed), "runClock", "stopButton".
class StateBar : public QFrame {
    Q_OBJECT

public:
    explicit StateBar(Actions& actions, QWidget* parent = nullptr);

    void apply(const Snapshot& snapshot);
    void setAnswering(bool answering);
    RunStateChip* chip() const { return m_chip; }

signals:
    void stopRequested();
    void reasonActivated(int index);

protected:
    void changeEvent(QEvent* event) override;

private:
    QToolButton* makeButton(QAction* action, const char* name);
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
    StopButton* m_emergency;
};

} // namespace bask
