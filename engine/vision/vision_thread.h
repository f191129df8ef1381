#pragma once
// A camera looked at on a thread of its own: the source followed for the control loop, pictures with what is
// in them for the window.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/source_tracker.h"
#include "engine/vision/vision_view.h"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bask {

/// What is looked for.
struct VisionTask {
    MarkerLayout layout;
    std::optional<CameraModel> camera; ///< as calibrated
    std::optional<Pose> X_RC;          ///< where it stands, as calibrated
    bool follow = false;               ///< the source, which takes both
    bool show = false;                 ///< pictures with all markers, for the window
    std::optional<Board> board;        ///< looked for in pictures that are shown
};

/// Camera and clock are borrowed. setTask(), newest() and read() never wait for a picture to be looked at.
/// Without a task the camera is left alone.
class VisionThread final : public SourceTracker {
public:
    /// Pictures shown have all markers looked for at most so often, which takes longer than following.
    static constexpr double kShow_s = 0.07;
    static constexpr double kCompare_s = 1.0;
    static constexpr double kMaxLead_s = 0.4; ///< of PartTracker::kPredicted_s

    VisionThread(Camera& camera, std::string cameraName, const Clock& clock);
    ~VisionThread() override; ///< waits for the picture that is being looked at

    void setTask(const VisionTask& task);
    /// The newest look by the last task; null until there is one, and while nothing is shown. A camera that
    /// is lost leaves its last picture.
    std::shared_ptr<const VisionView> newest() const;
    /// The source as followed, carried on to now.
    Result<PoseReading> read() override;
    /// How far a clock that runs faster than the computer's may go before it waits for pictures to be looked
    /// at; negative when it is too far already, infinite where the source is not followed.
    double lead_s() const;

private:
    void run(const std::stop_token& stop);
    void look(const VisionTask& task, std::optional<PartTracker>& tracker);
    void loseCamera(const VisionTask& task, const Message& problem);
    void follow(PartTracker& tracker);
    void show(const VisionTask& task, const std::optional<PartTracker>& tracker);
    void publish(VisionView view);
    bool isCurrent() const { return m_number == m_taskNumber; } ///< m_mutex is held

    Camera& m_camera;
    std::string m_name;
    const Clock& m_clock;

    mutable std::mutex m_mutex; ///< over the next eight
    std::condition_variable_any m_changed;
    VisionTask m_task;
    std::uint64_t m_taskNumber = 0;
    std::shared_ptr<const VisionView> m_newest;
    std::optional<PartTracker> m_tracker; ///< as after the last picture
    TrackState m_trackState = TrackState::Searching;
    double m_latency_s = 0.0;
    double m_looked_s = -1e300; ///< light of the picture that was followed in last

    // The thread's own.
    std::uint64_t m_number = 0;                 ///< of the task that is done
    std::shared_ptr<const CameraFrame> m_frame; ///< looked at last for this task
    double m_compared_s = -1e300;               ///< when a board that was found was compared last
    double m_shown_s = -1e300;                  ///< when one was shown last, SteadyClock
    double m_period_s = 0.0;                    ///< between pictures that were looked at, smoothed
    double m_last_s = -1e300;
    std::optional<TrackState> m_followed;

    std::jthread m_thread; ///< last: it uses the rest
};

} // namespace bask
