#pragma once
// The bar that is always visible: SIMULATED or LIVE, the run's state, its verbs in order of use, the clock,
// the most serious alarm, STOP.

#include "app/actions.h"

#include <QFrame>

#include <array>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QSpacerItem;
class QToolButton;

namespace bask {

class AlarmButton;
class RunStateChip;
class StopButton;

/// Object names: "rigTag" with "tagWord" and "faultWord" (only while a simulated fault is active),
/// "runStateChip", "armButton", "startButton", "holdButton" (Hold or Resume), "stopRunButton",
/// "retreatButton", "resetButton", "runClock", "alarmButton" (only with alarms), "operatorButton" (only if
/// operator or sample are known), "stopButton". In a narrow window first the alarm's text, sample and name
/// give way, then the verbs lose their icons, get smaller letters and, from some 900 px down, lose their
/// words, then clock and operator disappear; below some 600 px the verbs have a row of their own. SIMULATED
/// or LIVE, the state and STOP are always there in words. The verbs have the same places in every state and
/// with every alarm.
class StateBar : public QFrame {
    Q_OBJECT

public:
    explicit StateBar(Actions& actions, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override;

    void apply(const Snapshot& snapshot);
    void focusChip();
    void setAnswering(bool answering);
    void setTemperatureUnit(TemperatureUnit unit);
    RunStateChip* chip() const { return m_chip; }

signals:
    void stopRequested();
    /// A verb was clicked that is not possible now.
    void verbRefused(bask::Verb verb);
    void reasonActivated(int index);
    void alarmChosen(quint64 id);
    void labelsRequested();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QToolButton* makeButton(QAction* action, const char* name);
    void fit();
    void shorten(int parts);
    int roomNeeded(int parts) const;
    void setTwoRows(bool areTwo);
    void reserveHold();
    void showTag();
    void showFault();
    void showLabels();
    void showUntilCold();
    void showChip();
    void retranslate();

    Actions& m_actions;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    bool m_simulated = true;
    bool m_answering = true;
    int m_shortParts = 0;
    RunState m_state = RunState::Idle;
    std::vector<Message> m_reasons;
    int m_gravest = 0;                      ///< priority of the gravest of them
    QString m_placeSureAgain;               ///< what a reason about the place says; empty before
    QString m_fitted;                       ///< the last content that was fitted, and its width
    QHBoxLayout *m_row, *m_below, *m_verbs; ///< the verbs are in one of the others
    bool m_areTwoRows = false;
    std::array<QSpacerItem*, 3> m_gaps{}; ///< between the parts of the row
    QFrame* m_tag;
    QGridLayout* m_tagGrid;
    QLabel* m_tagIcon;
    QLabel* m_tagWord;
    QLabel* m_faultWord; ///< under the word of the tag, where it takes no room from the verbs
    QStringList m_faults;
    RunStateChip* m_chip;
    QToolButton *m_arm, *m_start, *m_hold, *m_stop, *m_retreat, *m_reset;
    QLabel* m_clockCaption;
    QLabel* m_clock;
    QLabel* m_untilCold;    ///< under the clock, which goes on when the run has ended
    QString m_untilColdTip; ///< empty if nothing is recorded after a run
    QToolButton* m_operator;
    RunLabels m_labels;
    AlarmButton* m_alarm;
    StopButton* m_emergency;
};

} // namespace bask
