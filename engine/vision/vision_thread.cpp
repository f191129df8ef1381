#include "engine/vision/vision_thread.h"

#include "engine/base/message_code.h"
#include "engine/base/thread_name.h"
#include "engine/vision/camera_source_tracker.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>

namespace bask {
namespace {

constexpr std::chrono::milliseconds kPoll{2};
constexpr std::chrono::milliseconds kPollLost{50};
constexpr double kSmoothing = 0.1; // of the rate

double now_s() {
    return SteadyClock().now_s();
}

ViewedMarker viewed(const FoundMarker& found, const VisionTask& task) {
    ViewedMarker view;
    view.marker = found;
    const auto listed = std::ranges::find(task.layout.markers, found.id, &PlacedMarker::id);
    if (listed == task.layout.markers.end())
        return view;
    view.part = listed->part;
    view.side_m = listed->side_m;
    if (task.camera)
        view.poses = markerPoses(found.corners_px, listed->side_m, *task.camera);
    return view;
}

} // namespace

VisionThread::VisionThread(Camera& camera, std::string cameraName, const Clock& clock)
    : m_camera(camera), m_name(std::move(cameraName)), m_clock(clock),
      m_thread([this](const std::stop_token& stop) {
          nameThread("vision");
          run(stop);
      }) {}

VisionThread::~VisionThread() {
    m_thread.request_stop();
    m_changed.notify_all();
}

void VisionThread::setTask(const VisionTask& task) {
    {
        const std::lock_guard lock(m_mutex);
        m_task = task;
        ++m_taskNumber;
        m_tracker.reset();
        m_newest.reset();
        m_looked_s = -1e300;
    }
    m_changed.notify_all();
}

std::shared_ptr<const VisionView> VisionThread::newest() const {
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

Result<PoseReading> VisionThread::read() {
    const std::lock_guard lock(m_mutex);
    if (!m_tracker)
        return PoseReading();
    const double time_s = m_clock.now_s();
    return readingOf(m_tracker->at(time_s), m_trackState, *m_task.X_RC, time_s, m_latency_s);
}

double VisionThread::lead_s() const {
    const std::lock_guard lock(m_mutex);
    return m_task.follow ? m_looked_s + kMaxLead_s - m_clock.now_s() : HUGE_VAL;
}

void VisionThread::run(const std::stop_token& stop) {
    VisionTask task;
    std::optional<PartTracker> tracker;
    while (!stop.stop_requested()) {
        {
            std::unique_lock lock(m_mutex);
            const auto isWanted = [this] { return m_task.follow || m_task.show; };
            if (!m_changed.wait(lock, stop, isWanted))
                return;
            if (!isCurrent()) {
                m_number = m_taskNumber;
                task = m_task;
                m_frame.reset(); // looked at anew, also when the camera has no newer one
                m_shown_s = -1e300;
                m_compared_s = -1e300;
                m_followed.reset();
                tracker.reset();
                if (task.follow && task.camera && task.X_RC)
                    tracker.emplace(task.layout, Part::Source, *task.camera);
            }
        }
        try {
            look(task, tracker);
        } catch (const std::exception& exception) { // this picture's alone; the run goes on without
            if (tracker)
                tracker->forget();
            loseCamera(task, {MessageCode::ReasonInternalFault, {exception.what()}});
        }
    }
}

void VisionThread::look(const VisionTask& task, std::optional<PartTracker>& tracker) {
    const auto frame = m_camera.newest();
    if (!frame)
        return loseCamera(task, frame.error().message);
    if (*frame == m_frame) {
        std::this_thread::sleep_for(kPoll);
        return;
    }
    m_frame = *frame;
    const double start_s = now_s();
    const double period_s = start_s - m_last_s;
    m_last_s = start_s;
    m_period_s = m_period_s > 0.0 && period_s < 1.0 ? m_period_s + kSmoothing * (period_s - m_period_s)
                                                    : std::min(period_s, 1.0);
    if (tracker && checkSize(*task.camera, m_frame->picture.width, m_frame->picture.height))
        follow(*tracker);
    if (task.show && start_s - m_shown_s >= kShow_s) {
        m_shown_s = start_s;
        show(task, tracker);
    }
}

void VisionThread::loseCamera(const VisionTask& task, const Message& problem) {
    if (task.show) {
        VisionView view;
        view.frame = m_frame;
        view.problem = problem;
        publish(std::move(view));
        m_shown_s = -1e300; // the first picture after it is shown whenever it comes
    }
    {
        const std::lock_guard lock(m_mutex);
        m_trackState = TrackState::Predicting;
    }
    std::this_thread::sleep_for(kPollLost);
}

void VisionThread::follow(PartTracker& tracker) {
    m_followed = tracker.step(*m_frame).state;
    const double latency_s = now_s() - m_frame->caught_s;
    const std::lock_guard lock(m_mutex);
    if (!isCurrent()) // another task came meanwhile, perhaps without the camera's place
        return;
    m_tracker = tracker;
    m_trackState = *m_followed;
    m_latency_s = latency_s;
    m_looked_s = m_frame->time_s;
}

void VisionThread::show(const VisionTask& task, const std::optional<PartTracker>& tracker) {
    const GreyPicture& picture = m_frame->picture;
    VisionView view;
    view.frame = m_frame;
    VisionTask known = task;
    if (known.camera)
        if (const auto fits = checkSize(*known.camera, picture.width, picture.height); !fits) {
            if (!task.board) // else it is being calibrated anew
                view.problem = fits.error().message;
            known.camera.reset();
        }
    for (const FoundMarker& found : findMarkers(picture, task.layout.dictionary))
        view.markers.push_back(viewed(found, known));
    if (task.board) {
        view.board = findBoard(picture, *task.board, {});
        // A board may have the set one's corners in it: looked at closely now and then.
        if (!*view.board || m_shown_s - m_compared_s >= kCompare_s) {
            view.boardSeen = boardSeen(picture, *task.board);
            m_compared_s = m_shown_s;
        }
    }
    view.tracking = m_followed;
    if (tracker)
        view.source = tracker->at(m_frame->time_s);
    view.latency_s = now_s() - m_frame->caught_s;
    publish(std::move(view));
}

void VisionThread::publish(VisionView view) {
    view.cameraName = m_name;
    view.rate_Hz = m_period_s > 0.0 ? 1.0 / m_period_s : 0.0;
    auto shared = std::make_shared<const VisionView>(std::move(view));
    const std::lock_guard lock(m_mutex);
    if (isCurrent() && m_task.show)
        m_newest = std::move(shared);
}

} // namespace bask
