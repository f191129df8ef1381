#pragma once
// Catches pictures on a thread of its own, whatever the system does there: opens again, tells a loss in time,
// leaves a capture that hangs.

#include "engine/base/clock.h"
#include "engine/base/left_out_pictures.h"
#include "engine/base/message_code.h"
#include "engine/base/result.h"
#include "engine/base/thread_name.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace bask {

/// Pictures one after another, from a device, a stream or files. `Caught` has a member caught_s, the exposure
/// time on SteadyClock, and a function isSamePicture(const Caught&, const Caught&). Use it on one thread,
/// which it may block for as long as the system takes.
template <class Caught> class CaptureSource {
public:
    virtual ~CaptureSource() = default;
    /// Returns the next picture. Errors: CameraNotOpened with the reason; the source cannot be used after
    /// that. Any other error is one of this picture alone, and the next one may be good.
    virtual Result<Caught> next() = 0;
    /// Returns the time from the last picture of a recording, good or not, to the next one; 0 for a live
    /// camera, where noise makes any two pictures different.
    virtual double period_s() const { return 0.0; }
    /// Returns whether it is better to wait for a next() that does not return, because it will continue where
    /// it stopped.
    virtual bool isWaitedFor() const { return false; }
};

template <class Caught>
using CaptureOpener =
    std::function<Result<std::unique_ptr<CaptureSource<Caught>>>(const std::function<bool()>& isStopped)>;

/// Number of abandoned captures of the process that have not returned.
std::atomic<int>& hangingCaptures();
/// Returns a CameraNotOpened with the reason in words.
Error captureRefusal(const std::string& name, const std::string& words);
/// Returns the reason within a CameraNotOpened.
std::string captureProblem(const Error& error);

/// A picture with its number, which grows with every picture of a camera.
template <class Caught> struct NumberedPicture {
    Caught caught;
    std::uint64_t number = 0;
    double period_s = 0.0; ///< to the next one of a recording; 0: live
};

/// Two pictures of a live camera are never equal, so a repeated picture is ignored. A picture that cannot be
/// used is left out and counted; a live camera that gives no other for kLost_s is opened again. A capture
/// that hangs is abandoned and another one is started, at most kMaxHanging in the process; after that it
/// waits. Use it on one thread, which it never keeps waiting.
template <class Caught> class BackgroundCapture {
public:
    static constexpr double kLost_s = 1.0;
    static constexpr double kOpening_s = 5.0; ///< CameraOpening is returned for this long without an answer
    static constexpr double kHanging_s = 3.0; ///< longest time without an answer of the system
    static constexpr double kFarewell_s = 0.5;
    static constexpr int kMaxHanging = 8;

    /// Opens by `opener` on the capture's thread. `name` is told in errors.
    BackgroundCapture(std::string name, CaptureOpener<Caught> opener)
        : m_name(std::move(name)), m_opener(std::move(opener)), m_began_s(m_clock.now_s()),
          m_thread(std::make_shared<Thread>(0, LeftOutPictures())) {
        Thread::begin(m_thread, m_opener);
    }
    /// Waits for at most kFarewell_s.
    ~BackgroundCapture() { (void)m_thread->finish(kFarewell_s); }
    BackgroundCapture(const BackgroundCapture&) = delete;
    BackgroundCapture& operator=(const BackgroundCapture&) = delete;

    /// Returns the newest picture, the same one again until there is a newer one. Errors: CameraOpening
    /// before the first picture; CameraNotOpened, and CameraLost if none came for kLost_s (of a slower
    /// recording for two of its periods), with the reason.
    Result<std::shared_ptr<const NumberedPicture<Caught>>> newest() {
        if (auto arrived = m_thread->take())
            m_newest = std::move(arrived);
        const double now_s = m_clock.now_s();
        if (m_newest && now_s - m_newest->caught.caught_s <= std::max(kLost_s, 2.0 * m_newest->period_s))
            return m_newest;
        beginAgainWhenHanging(now_s);
        return absence(now_s);
    }

    /// Returns what was left out so far.
    LeftOutPictures leftOut() const { return m_thread->leftOut(); }

private:
    static std::chrono::duration<double> seconds(double time_s) {
        return std::chrono::duration<double>(time_s);
    }

    /// What the thread and its owner share; it outlives either.
    class Thread {
    public:
        Thread(std::uint64_t pictures, LeftOutPictures leftOut)
            : m_pictures(pictures), m_leftOut(std::move(leftOut)) {}

        // -- by the owner ------------------------------------------------------------------------------

        static void begin(const std::shared_ptr<Thread>& thread, CaptureOpener<Caught> opener) {
            if (hangingCaptures() >= kMaxHanging) {
                thread->m_words = "too many captures hang in the system; start Bask again";
                thread->m_ended = true;
                return;
            }
            std::thread([thread, opener = std::move(opener)] {
                nameThread("capture");
                thread->run(opener);
                thread->end();
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
            ++hangingCaptures();
            return false;
        }

        std::shared_ptr<const NumberedPicture<Caught>> take() {
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
        std::uint64_t pictures() const {
            const std::lock_guard lock(m_mutex);
            return m_pictures;
        }
        LeftOutPictures leftOut() const {
            const std::lock_guard lock(m_mutex);
            return m_leftOut;
        }

    private:
        static constexpr double kFirstPause_s = 0.25, kLongestPause_s = 2.0; // between attempts to open
        static constexpr double kFrozen_s = 3.0;     // of the same picture: opened again
        static constexpr double kRepeated_s = 0.005; // a device that repeats itself may do so at once

        // -- by the thread -----------------------------------------------------------------------------

        void run(const CaptureOpener<Caught>& opener) {
            double pause_s = kFirstPause_s;
            while (!isStopped()) {
                try {
                    auto source = opener([this] { return isStopped(); });
                    if (!source)
                        say(captureProblem(source.error()));
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
        bool play(CaptureSource<Caught>& source) {
            std::shared_ptr<const NumberedPicture<Caught>> before;
            double lastNew_s = m_clock.now_s(), due_s = lastNew_s;
            const auto keepTime = [&](double now_s, double period_s) {
                due_s = std::max(due_s + period_s, now_s - period_s);
                if (due_s > now_s)
                    pause(due_s - now_s);
            };
            while (!isStopped()) {
                auto caught = read(source);
                const double now_s = m_clock.now_s(), period_s = source.period_s();
                if (!caught) {
                    say(captureProblem(caught.error()));
                    const bool isOver = caught.error().code() == MessageCode::CameraNotOpened;
                    if (!isOver)
                        leaveOut(caught.error());
                    if (isOver || (period_s == 0.0 && now_s - lastNew_s > kLost_s))
                        break;
                    keepTime(now_s, std::max(period_s, kRepeated_s));
                    continue;
                }
                if (period_s > 0.0 || !before || !isSamePicture(*caught, before->caught)) {
                    lastNew_s = now_s;
                    before = publish(std::move(*caught), period_s);
                    keepTime(now_s, period_s);
                    continue;
                }
                say("it gives the same picture again and again");
                if (now_s - lastNew_s > kFrozen_s)
                    break;
                pause(kRepeated_s);
            }
            return before != nullptr;
        }

        Result<Caught> read(CaptureSource<Caught>& source) {
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
        std::shared_ptr<const NumberedPicture<Caught>> publish(Caught&& caught, double period_s) {
            auto picture = std::make_shared<NumberedPicture<Caught>>();
            picture->caught = std::move(caught);
            picture->period_s = period_s;
            const std::lock_guard lock(m_mutex);
            picture->number = ++m_pictures;
            m_arrived = picture;
            m_words.clear();
            return picture;
        }
        void say(std::string words) {
            const std::lock_guard lock(m_mutex);
            m_words = std::move(words);
        }
        void leaveOut(const Error& reason) {
            const std::lock_guard lock(m_mutex);
            ++m_leftOut.count;
            m_leftOut.last = reason;
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
                --hangingCaptures();
            m_wake.notify_all();
        }

        SteadyClock m_clock;
        mutable std::mutex m_mutex;
        std::condition_variable m_wake;
        bool m_stopped = false, m_ended = false, m_left = false;
        std::shared_ptr<const NumberedPicture<Caught>> m_arrived; ///< that the owner has not taken yet
        std::uint64_t m_pictures;
        LeftOutPictures m_leftOut;
        std::string m_words;                    ///< why nothing new comes
        std::optional<double> m_readingSince_s; ///< the system has not answered since
    };

    void beginAgainWhenHanging(double now_s) {
        if (!m_thread->hangs(now_s) || hangingCaptures() >= kMaxHanging)
            return;
        auto next = std::make_shared<Thread>(m_thread->pictures(), m_thread->leftOut());
        (void)m_thread->finish(0.0);
        m_thread = std::move(next);
        Thread::begin(m_thread, m_opener);
    }

    Error absence(double now_s) const {
        const std::string words = m_thread->words();
        const MessageCode code = m_newest ? MessageCode::CameraLost : MessageCode::CameraNotOpened;
        if (!m_newest && words.empty() && now_s - m_began_s <= kOpening_s)
            return {MessageCode::CameraOpening, "", {m_name}};
        return {code, "", {m_name, words.empty() ? "it does not answer" : words}};
    }

    std::string m_name;
    SteadyClock m_clock;
    CaptureOpener<Caught> m_opener;
    double m_began_s;
    std::shared_ptr<Thread> m_thread;
    std::shared_ptr<const NumberedPicture<Caught>> m_newest;
};

} // namespace bask
