#pragma once
// The poses of camera and source from markers: listed, measured, judged, checked.

#include "engine/base/message_code.h"
#include "engine/calibration/hand_eye.h"
#include "engine/calibration/relative_pose.h"
#include "engine/model/experiment.h"
#include "engine/vision/vision_view.h"
#include "widgets/common/latest_job.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QPushButton;

namespace bask {

class MarkerEditor;
class SurveyBar;
class VerdictBox;

/// Object names: those of MarkerEditor and SurveyBar; "placeHere", "placeTour", "placeCheck", those of a
/// VerdictBox "place"; "sourceMeasure", "sourceFollow", those of a VerdictBox "source".
class RigPanel : public QWidget {
    Q_OBJECT

public:
    static constexpr int kFramesHere = 30;
    static constexpr int kFramesOnTour = 8;

    explicit RigPanel(QWidget* parent = nullptr);
    ~RigPanel() override;

    void setExperiment(const Experiment& experiment);
    /// Each frame counts once.
    void setView(const VisionView& view);
    /// Coordinates of the end-effector in R; `mayMove`: no run is armed or on, no stop latched.
    void setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove);

signals:
    void visionEdited(const bask::VisionSpec& vision);
    /// Sends both: calibrations with their dates, and the source's pose in R.
    void sourceMeasured(const bask::VisionSpec& vision, const bask::Vector6d& pose);
    void followWanted(bool follow); ///< whether to follow the source during runs
    void moveWanted(const bask::Vector6d& coordinates);
    void holdWanted(); ///< stop the robot where it is
    /// This part of the panel must be seen.
    void attentionWanted(QWidget* part);

protected:
    void changeEvent(QEvent* event) override;

private:
    enum class Task { None, PlaceHere, PlaceTour, PlaceCheck, Source };
    struct Outcome {
        std::optional<HandEye> place;
        PoseSpread spread; ///< spread of `place` at the source
        std::optional<HandEyeCheck> check;
        std::optional<RelativePose> source;
        Pose X_RS = Pose::Identity(); ///< pose of the source, from `source`
        Message trouble;              ///< code None if there was none
    };

    QWidget* buildPlace();
    QWidget* buildSource();
    void begin(Task task);
    void forget(); ///< forgets measurements with another camera or other markers
    void solve();
    void take(Task task, Outcome outcome);
    void usePlace();
    void useSource();
    bool isPlaceUsed() const;  ///< whether m_place is in use
    bool isSourceUsed() const; ///< whether m_source is in use
    void showPlace();
    void showSource();
    void showEnabled();
    QString whyNot() const; ///< why measuring is not possible now
    void retranslate();

    Experiment m_experiment;
    std::uint64_t m_frame = 0; ///< number of the last frame
    std::string m_cameraName;  ///< camera of the last view
    Message m_problem;         ///< why pictures cannot be used for measuring; code None if they can
    bool m_hasFrame = false;
    Vector6d m_robot = Vector6d::Zero();
    bool m_mayMove = false;

    Task m_task = Task::None;
    LatestJob<Outcome> m_solving;
    std::optional<HandEye> m_place;      ///< the last measurement
    PoseSpread m_placeSpread;            ///< spread of m_place at the source
    std::optional<HandEyeCheck> m_check; ///< check of m_place, or of the pose in use
    std::optional<RelativePose> m_source;
    Pose m_X_RS = Pose::Identity();

    MarkerEditor* m_markers;
    QLabel *m_markersTitle, *m_placeTitle, *m_sourceTitle;
    QLabel *m_placeHint, *m_sourceHint;
    QPushButton *m_here, *m_tour, *m_checkButton;
    VerdictBox* m_placeBox;
    QPushButton* m_measure;
    VerdictBox* m_sourceBox;
    QCheckBox* m_follow;
    SurveyBar* m_bar;
};

} // namespace bask
