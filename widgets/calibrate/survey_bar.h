#pragma once
// A survey that is on: where the robot is sent, how far it is, and the button that cancels it.

#include "widgets/calibrate/rig_survey.h"

#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;

namespace bask {

/// From begin() it is busy until end() or cancel(); between surveys it may say something else. A survey ends
/// when it is seen no more: the robot does not move where nobody can cancel that. Object names:
/// "surveyStatus", "surveyProgress", "surveyCancel".
class SurveyBar : public QWidget {
    Q_OBJECT

public:
    explicit SurveyBar(QWidget* parent = nullptr);

    /// As RigSurvey::begin().
    void begin(std::vector<Vector6d> goals, int frames);
    /// A robot that stops elsewhere, or that a run takes (`mayMove` false), cancels the survey; the latter
    /// without a hold, which would be the run's.
    void setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove);
    /// As RigSurvey::addFrame().
    void addFrame(double time_s, const MarkerFrame& frame);
    void cancel();
    /// The result is there: says a sentence, or nothing.
    void end(const QString& sentence);
    /// Says a sentence while nothing is on.
    void say(const QString& sentence);
    /// Says why no survey can begin, unless one is on; an empty reason takes back the last one.
    void sayReason(const QString& reason);

    bool isBusy() const { return m_isBusy; }
    QString sentence() const;
    const RigSurvey& survey() const { return m_survey; }
    QPushButton* cancelButton() const { return m_cancel; }
    QLabel* statusLabel() const { return m_status; }

signals:
    void moveWanted(const bask::Vector6d& coordinates);
    void holdWanted(); ///< stop the robot where it is
    void frameTaken(); ///< it counts, and is of the pose of the last view
    void finished();   ///< all frames are there; it is busy until end()
    void cancelled();

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void setBusy(bool isBusy);
    void advance();
    void showSurvey();
    void retranslate();

    RigSurvey m_survey;
    bool m_isBusy = false;
    bool m_isReason = false; ///< what it says is a reason
    QLabel* m_status;
    QProgressBar* m_progress;
    QPushButton* m_cancel;
};

} // namespace bask
