#include "engine/devices/video_camera.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace bask {
namespace {

constexpr double kFirstPause_s = 0.25, kLongestPause_s = 2.0; // between attempts to open
constexpr double kFrozen_s = 3.0;                             // of the same picture: opened again
constexpr double kRepeated_s = 0.005; // a device that repeats itself may do so at once

std::atomic<int> g_hanging{0};

std::chrono::duration<double> seconds(double time_s) {
    return std::chrono::duration<double>(time_s);
}

// The reason within a CameraNotOpened.
std::string wordsOf(const Error& error) {
    return error.message.args.size() > 1 ? error.message.args[1].text() : describe(error);
}

} // namespace

/// What the capture thread and the camera share; it outlives either.
class VideoCamera::Capture {
public:
    explicit Capture(std::uint64_t frames) : m_frames(frames) {}

    // -- by the camera ---------------------------------------------------------------------------------

    static void begin(const std::shared_ptr<Capture>& capture, Opener opener) {
        if (g_hanging >= kMaxHanging) {
            capture->m_words = "too many captures hang in the system; start Bask again";
            capture->m_ended = true;
            return;
        }
        std::thread([capture, opener = std::move(opener)] {
            capture->run(opener);
            capture->end();
        }).detach();
    }

    /// True when the thread has come to its end within the time; one that has not is counted and left.
    bool finish(double patience_s) {
        std::unique_lock lock(m_mutex);
        m_stopped = true;
        m_wake.notify_all();
        if (m_wake.wait_for(lock, seconds(patience_s), [this] { return m_ended; }))
            return true;
        m_left = true;
        ++g_hanging;
        return false;
    }

    std::shared_ptr<CameraFrame> take() {
        const std::lock_guard lock(m_mutex);
        return std::exchange(m_arrived, nullptr);
    }
    std::string words() const {
        const std::lock_guard lock(m_mutex);
        return m_words;
    }
    /// Also when it was never begun.
    bool hangs(double now_s) const {
        const std::lock_guard lock(m_mutex);
        return m_ended || (m_readingSince_s && now_s - *m_readingSince_s > kHanging_s);
    }
    std::uint64_t frames() const {
        const std::lock_guard lock(m_mutex);
        return m_frames;
    }

private:
    // -- by the thread ---------------------------------------------------------------------------------

    void run(const Opener& opener) {
        double pause_s = kFirstPause_s;
        while (!isStopped()) {
            try {
                auto source = opener([this] { return isStopped(); });
                if (!source)
                    say(wordsOf(source.error()));
                else if (play(**source))
                    pause_s = kFirstPause_s;
            } catch (const std::exception& problem) {
                say(problem.what());
            }
            pause(pause_s);
            pause_s = std::min(2.0 * pause_s, kLongestPause_s);
        }
    }

    /// Until the source gives nothing new any more; true when it gave a picture.
    bool play(FrameSource& source) {
        const double period_s = source.period_s();
        std::vector<std::uint8_t> before;
        bool anyCame = false;
        double lastNew_s = m_clock.now_s(), due_s = lastNew_s;
        while (!isStopped()) {
            auto caught = read(source);
            if (!caught) {
                say(wordsOf(caught.error()));
                break;
            }
            const double now_s = m_clock.now_s();
            if (period_s > 0.0 || caught->picture.values != before) {
                before = caught->picture.values;
                lastNew_s = now_s;
                anyCame = true;
                publish(std::move(*caught));
                due_s = std::max(due_s + period_s, now_s - period_s);
                if (due_s > now_s)
                    pause(due_s - now_s);
                continue;
            }
            say("it gives the same picture again and again");
            if (now_s - lastNew_s > kFrozen_s)
                break;
            pause(kRepeated_s);
        }
        return anyCame;
    }

    Result<CaughtPicture> read(FrameSource& source) {
        if (!source.isWaitedFor())
            markReading(m_clock.now_s());
        auto caught = source.next();
        markReading({});
        return caught;
    }
    void markReading(std::optional<double> since_s) {
        const std::lock_guard lock(m_mutex);
        m_readingSince_s = since_s;
    }
    void publish(CaughtPicture&& caught) {
        auto frame = std::make_shared<CameraFrame>();
        frame->caught_s = caught.caught_s;
        frame->picture = std::move(caught.picture);
        const std::lock_guard lock(m_mutex);
        frame->number = ++m_frames;
        m_arrived = std::move(frame);
        m_words.clear();
    }
    void say(std::string words) {
        const std::lock_guard lock(m_mutex);
        m_words = std::move(words);
    }
    void pause(double time_s) {
        std::unique_lock lock(m_mutex);
        m_wake.wait_for(lock, seconds(time_s), [this] { return m_stopped; });
    }
    bool isStopped() const {
        const std::lock_guard lock(m_mutex);
        return m_stopped;
    }
    void end() {
        const std::lock_guard lock(m_mutex);
        m_ended = true;
        if (m_left)
            --g_hanging;
        m_wake.notify_all();
    }

    SteadyClock m_clock;
    mutable std::mutex m_mutex;
    std::condition_variable m_wake;
    bool m_stopped = false, m_ended = false, m_left = false;
    std::shared_ptr<CameraFrame> m_arrived; ///< that the camera has not taken yet
    std::uint64_t m_frames;
    std::string m_words;                    ///< why nothing new comes
    std::optional<double> m_readingSince_s; ///< the system has not answered since
};

VideoCamera::VideoCamera(std::string name, const Clock& clock)
    : VideoCamera(name, clock, [name](const std::function<bool()>& isStopped) {
          return openFrameSource(name, isStopped);
      }) {}

VideoCamera::VideoCamera(std::string name, const Clock& clock, Opener opener)
    : m_name(std::move(name)), m_clock(clock), m_opener(std::move(opener)), m_began_s(m_steady.now_s()),
      m_capture(std::make_shared<Capture>(0)) {
    Capture::begin(m_capture, m_opener);
}

VideoCamera::~VideoCamera() {
    (void)m_capture->finish(kFarewell_s);
}

int VideoCamera::hanging() {
    return g_hanging;
}

Result<std::shared_ptr<const CameraFrame>> VideoCamera::newest() {
    if (auto frame = m_capture->take()) {
        frame->time_s = m_clock.now_s() - (m_steady.now_s() - frame->caught_s);
        m_newest = std::move(frame);
    }
    const double now_s = m_steady.now_s();
    if (m_newest && now_s - m_newest->caught_s <= kLost_s)
        return m_newest;
    beginAgainWhenHanging(now_s);
    return absence(now_s);
}

void VideoCamera::beginAgainWhenHanging(double now_s) {
    if (!m_capture->hangs(now_s) || g_hanging >= kMaxHanging)
        return;
    auto next = std::make_shared<Capture>(m_capture->frames());
    (void)m_capture->finish(0.0);
    m_capture = std::move(next);
    Capture::begin(m_capture, m_opener);
}

Error VideoCamera::absence(double now_s) const {
    const std::string words = m_capture->words();
    const MessageCode code = m_newest ? MessageCode::CameraLost : MessageCode::CameraNotOpened;
    if (!m_newest && words.empty() && now_s - m_began_s <= kOpening_s)
        return {MessageCode::CameraOpening, "", {m_name}};
    return {code, "", {m_name, words.empty() ? "it does not answer" : words}};
}

} // namespace bask
