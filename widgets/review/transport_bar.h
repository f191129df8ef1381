#pragma once
// The controls of a replay: play and pause, position, speed, and the tag that marks it as a replay.

#include "widgets/review/replay.h"

#include <QTimer>
#include <QWidget>

class QComboBox;
class QFrame;
class QLabel;
class QPushButton;
class QSlider;

namespace bask {

/// Sends the moment to show, at most 25 times a second while playing, and only while it is visible: when
/// hidden, it pauses. Object names: "replayTag", "replayPlay", "replaySlider", "replayTime", "replaySpeed".
class TransportBar : public QWidget {
    Q_OBJECT

public:
    /// The clock must outlive the bar.
    explicit TransportBar(const Clock& clock, QWidget* parent = nullptr);

    void setSpan(double begin_s, double end_s);
    void seek(double time_s);
    void togglePlay();
    void pause();
    double position_s() const { return m_replay.position_s(); }

signals:
    void moved(double time_s);

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void tick();
    void showPosition();
    void showButton();
    void retranslate();
    void restyle();

    Replay m_replay;
    QTimer m_timer;
    QFrame* m_tag;
    QLabel *m_tagIcon, *m_tagWord;
    QPushButton* m_play;
    QSlider* m_slider;
    QLabel* m_time;
    QLabel* m_speedLabel;
    QComboBox* m_speed;
};

} // namespace bask
