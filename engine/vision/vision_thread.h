#pragma once
// Processes a camera on its own thread: tracks the source for the control loop, and provides pictures with
// their markers for the window.

#include "engine/base/clock.h"
#include "engine/devices/camera.h"
#include "engine/devices/source_tracker.h"
#include "engine/vision/vision_view.h"

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace bask {

/// What the thread does.
struct VisionTask {
    MarkerLayout layout;
    std::optional<CameraModel> camera; ///< the calibrated camera
    std::optional<Pose> X_RC;          ///< the camera's calibrated pose
    bool follow = false;               ///< track the source, which needs both
    bool show = false;                 ///< provide pictures with all markers, for the window
    std::optional<Board> board;        ///< board to search in these pictures
};

/// Camera and clock must outlive it. setTask(), newest() and read() never wait for a picture to be processed.
/// Without a task the camera is not used.
class VisionThread final : public SourceTracker {
public:
    /// Smallest time between searches for all markers in shown pictures, which take longer than tracking.
    static constexpr double kShow_s = 0.07;
    static constexpr double kCompare_s = 1.0;
    static constexpr double kMaxLead_s = 0.4; ///< part of PartTracker::kPredicted_s

    VisionThread(Camera& camera, std::string cameraName, const Clock& clock);
    ~VisionThread() override; ///< waits until the present picture is processed

    void setTask(const VisionTask& task);
    /// Returns the newest result of the last task; null until there is one, and while nothing is shown. If
    /// the camera is lost, its last picture remains.
    std::shared_ptr<const VisionView> newest() const;
    /// Returns the tracked source, extrapolated to now.
    Result<PoseReading> read() override;
    /// Returns how far a clock that runs faster than the computer's may advance before it must wait for
    /// pictures to be processed. Negative if it is already too far, infinite if the source is not tracked.
    double lead_s() const;

private:
    void run(const std::stop_token& stop);
    void look(const VisionTask& task, std::optional<PartTracker>& tracker);
    void loseCamera(const VisionTask& task, const Message& problem);
    void follow(PartTracker& tracker);
    void show(const VisionTask& task, const std::optional<PartTracker>& tracker);
    void publish(VisionView view);
    bool isCurrent() const { return m_number == m_taskNumber; } ///< m_mutex must be locked

    Camera& m_camera;
    std::string m_name;
    const Clock& m_clock;

    mutable std::mutex m_mutex; ///< protects the next eight members
    std::condition_variable_any m_changed;
    VisionTask m_task;
    std::uint64_t m_taskNumber = 0;
    std::shared_ptr<const VisionView> m_newest;
    std::optional<PartTracker> m_tracker; ///< state after the last picture
    TrackState m_trackState = TrackState::Searching;
    double m_latency_s = 0.0;
    double m_looked_s = -1e300; ///< exposure time of the last picture used for tracking

    // Used only by the thread.
    std::uint64_t m_number = 0;                 ///< number of the task in progress
    std::shared_ptr<const CameraFrame> m_frame; ///< the last frame processed for this task
    double m_compared_s = -1e300;               ///< time of the last comparison of a detected board
    double m_shown_s = -1e300;                  ///< time of the last shown picture, SteadyClock
    double m_period_s = 0.0;                    ///< time between processed pictures, smoothed
    double m_last_s = -1e300;
    std::optional<TrackState> m_followed;

    std::jthread m_thread; ///< declared last, because it uses the other members
};

} // namespace bask
