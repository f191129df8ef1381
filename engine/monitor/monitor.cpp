#include "engine/monitor/monitor.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/base/program_part.h"
#include "engine/base/thread_name.h"
#include "engine/monitor/broker_link.h"
#include "engine/monitor/status_files.h"
#include "engine/protocols/network_address.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <csignal>
#include <deque>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

namespace bask {
namespace {

using Steady = std::chrono::steady_clock;
using std::chrono::milliseconds;
using StatusPointer = std::shared_ptr<const MonitorStatus>;

constexpr milliseconds kLook{50};           ///< between two looks at what is to be published
constexpr milliseconds kBetweenTries{1000}; ///< to connect
constexpr milliseconds kSlow{5000};         ///< without an answer of a broker
constexpr milliseconds kClosing{700};       ///< for the last messages: within Monitor::kGoodbye

/// A thread that publishes, and what waits for it.
class Post {
public:
    void put(const StatusPointer& status, const std::vector<MonitorEvent>& more) {
        const std::lock_guard lock(m_mutex);
        m_latest = status;
        m_events.insert(m_events.end(), more.begin(), more.end());
        trim();
    }
    StatusPointer latest() const {
        const std::lock_guard lock(m_mutex);
        return m_latest;
    }
    std::optional<MonitorEvent> takeEvent() {
        const std::lock_guard lock(m_mutex);
        if (m_events.empty())
            return std::nullopt;
        MonitorEvent event = std::move(m_events.front());
        m_events.pop_front();
        return event;
    }
    /// Events that were taken and did not arrive.
    void giveBack(const std::vector<MonitorEvent>& events) {
        const std::lock_guard lock(m_mutex);
        m_events.insert(m_events.begin(), events.begin(), events.end());
        trim();
    }
    void dropEvents() {
        const std::lock_guard lock(m_mutex);
        m_events.clear();
    }
    void countSent() {
        const std::lock_guard lock(m_mutex);
        ++m_sent;
    }
    void tell(const Message& problem, bool isConnected) {
        const std::lock_guard lock(m_mutex);
        m_problem = problem;
        m_isConnected = isConnected;
    }
    std::uint64_t leftOut() const {
        const std::lock_guard lock(m_mutex);
        return m_leftOut;
    }
    void describeBroker(MonitorState& state) const {
        const std::lock_guard lock(m_mutex);
        state.hasBroker = true;
        state.isConnected = m_isConnected;
        state.brokerProblem = m_problem;
        state.sent = m_sent;
        state.leftOut = m_leftOut;
    }
    Message problem() const {
        const std::lock_guard lock(m_mutex);
        return m_problem;
    }

    void finish() {
        const std::lock_guard lock(m_mutex);
        m_isOver = true;
        m_changed.notify_all();
    }
    bool isOver() const {
        const std::lock_guard lock(m_mutex);
        return m_isOver;
    }
    /// Waits, and returns whether it is to end.
    bool pause(milliseconds time) {
        std::unique_lock lock(m_mutex);
        return m_changed.wait_for(lock, time, [this] { return m_isOver; });
    }
    void setDone() {
        const std::lock_guard lock(m_mutex);
        m_isDone = true;
        m_changed.notify_all();
    }
    void waitUntilDone(milliseconds bound) {
        std::unique_lock lock(m_mutex);
        m_changed.wait_for(lock, bound, [this] { return m_isDone; });
    }

private:
    void trim() {
        for (; m_events.size() > Monitor::kMaxWaiting; ++m_leftOut)
            m_events.pop_front();
    }

    mutable std::mutex m_mutex; ///< held for moments only
    std::condition_variable m_changed;
    StatusPointer m_latest;
    std::deque<MonitorEvent> m_events;
    bool m_isOver = false, m_isDone = false, m_isConnected = false;
    Message m_problem;
    std::uint64_t m_sent = 0, m_leftOut = 0;
};

using PostPointer = std::shared_ptr<Post>;

/// Signals are for the program's own threads: those started meanwhile take none.
class NoSignals {
public:
    NoSignals() {
        sigset_t all;
        sigfillset(&all);
        ::pthread_sigmask(SIG_SETMASK, &all, &m_before);
    }
    ~NoSignals() { ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }
    NoSignals(const NoSignals&) = delete;
    NoSignals& operator=(const NoSignals&) = delete;

private:
    sigset_t m_before{};
};

template <class Work> PostPointer start(const char* name, Work work) {
    auto post = std::make_shared<Post>();
    const NoSignals guard;
    std::thread([post, name, work = std::move(work)] {
        nameThread(name);
        work(*post);
        post->setDone();
    }).detach();
    return post;
}

Result<BrokerAccess> accessOf(const BrokerSettings& settings) {
    const auto address = networkAddress(settings.address, settings.usualPort());
    if (!address)
        return Error(MessageCode::MonitorAddressWrong, {}, {settings.address});
    BrokerAccess access;
    access.host = address->host;
    access.port = address->port;
    access.usesTls = settings.usesTls;
    access.caFile = settings.caFile;
    access.user = settings.user;
    if (!settings.passwordFile.empty()) {
        auto password = readPassword(settings.passwordFile);
        if (!password)
            return password.error();
        access.password = std::move(*password);
    }
    static std::atomic<int> number = 0; // the same client twice would end the other one's connection
    access.clientId =
        "bask-" + hostName() + '-' + std::to_string(::getpid()) + '-' + std::to_string(++number);
    return access;
}

Message noBroker(const BrokerSettings& settings, const std::string& why) {
    return {MessageCode::MonitorNoBroker, {settings.address, why}};
}

/// What goes to a broker while it is connected.
class Publisher {
public:
    Publisher(Post& post, BrokerLink& link, const BrokerSettings& settings)
        : m_post(post), m_link(link), m_settings(settings) {}

    void work() {
        std::erase_if(m_sent, [&](const auto& sent) { return !m_link.unanswered().contains(sent.first); });
        sendEvents();
        sendState(false);
        const auto now = Steady::now();
        if (m_link.unanswered().empty() || *m_link.unanswered().begin() != m_oldest) {
            m_oldest = m_link.unanswered().empty() ? 0 : *m_link.unanswered().begin();
            m_answeredAt = now;
        }
        const bool isSlow = now - m_answeredAt > kSlow;
        m_post.tell(
            isSlow ? Message{MessageCode::MonitorSlow, {m_settings.address, std::to_string(m_post.leftOut())}}
                   : Message{},
            true);
    }

    /// Everything that waits, and the last status.
    void close() {
        const auto until = Steady::now() + kClosing;
        const auto isOn = [&] {
            return m_link.state() == BrokerLink::State::Connected && Steady::now() < until;
        };
        bool isClosed = false;
        while (isOn() && !(isClosed && m_link.unanswered().empty())) {
            sendEvents();
            if (!isClosed && !m_link.isBusy()) {
                sendState(true);
                isClosed = publish("presence", "closed", true) != 0;
            }
            m_link.work(kLook);
        }
        m_link.end();
    }

    /// The connection is lost: events that the broker has not acknowledged go out once more.
    void giveBack() {
        std::vector<MonitorEvent> events;
        for (auto& [id, event] : m_sent)
            events.push_back(std::move(event));
        m_post.giveBack(events);
    }

private:
    void sendEvents() {
        while (!m_link.isBusy()) {
            auto event = m_post.takeEvent();
            if (!event)
                return;
            const int id = publish("event", eventJson(*event), false);
            m_sent.emplace_back(id, std::move(*event));
            if (id == 0)
                return;
        }
    }

    void sendState(bool isClosing) {
        const StatusPointer status = m_post.latest();
        if (!status || m_link.isBusy())
            return;
        if (status != m_seen) {
            m_seen = status;
            if (std::string alarms = alarmsJson(*status);
                alarms != m_alarms && publish("alarms", alarms, true) != 0)
                m_alarms = std::move(alarms);
        }
        const auto now = Steady::now();
        if (!isClosing && status->snapshot.state == m_state && now - m_statusAt < Monitor::kPeriod)
            return;
        MonitorStatus told = *status;
        told.isClosed = isClosing;
        if (publish("status", statusJson(told), true) == 0)
            return;
        m_state = status->snapshot.state;
        m_statusAt = now;
    }

    int publish(const char* topic, const std::string& payload, bool isRetained) {
        const int id = m_link.publish(m_settings.topic + '/' + topic, payload, isRetained);
        if (id != 0)
            m_post.countSent();
        return id;
    }

    Post& m_post;
    BrokerLink& m_link;
    const BrokerSettings& m_settings;
    std::deque<std::pair<int, MonitorEvent>> m_sent; ///< not acknowledged; number 0: not sent
    StatusPointer m_seen;
    std::string m_alarms;
    RunState m_state = RunState::Idle;
    int m_oldest = 0; ///< of the messages that are not acknowledged
    Steady::time_point m_statusAt = Steady::now() - Monitor::kPeriod, m_answeredAt = Steady::now();
};

/// One connection, until it fails or the end. Returns why it failed.
Message publishUntilLost(Post& post, const BrokerSettings& settings) {
    auto access = accessOf(settings);
    if (!access)
        return noBroker(settings, describe(access.error()));
    access->presenceTopic = settings.topic + "/presence";
    auto link = makeBrokerLink();
    if (!link)
        return link.error().message;
    (*link)->begin(*access);
    Publisher publisher(post, **link, settings);
    while ((*link)->state() != BrokerLink::State::Failed && !post.isOver()) {
        if ((*link)->state() == BrokerLink::State::Connected)
            publisher.work();
        (*link)->work(kLook);
    }
    if ((*link)->state() == BrokerLink::State::Connected)
        publisher.close();
    else
        publisher.giveBack();
    return noBroker(settings, (*link)->problem());
}

void runBroker(Post& post, const BrokerSettings& settings) {
    do {
        post.tell(publishUntilLost(post, settings), false);
    } while (!post.pause(kBetweenTries));
}

void runFiles(Post& post, const std::string& folder) {
    bool isOver = false;
    while (!isOver) {
        isOver = post.pause(Monitor::kPeriod);
        post.dropEvents(); // they are for a broker
        const StatusPointer status = post.latest();
        if (!status)
            continue;
        MonitorStatus told = *status;
        told.isClosed = isOver;
        const auto written = writeStatusFiles(told, folder);
        post.tell(written ? Message{} : Message{MessageCode::MonitorNoFile, {describe(written.error())}},
                  false);
    }
}

/// Two of one topic, or of one folder, would overwrite one another.
template <class Run> auto after(const PostPointer& before, Run run) {
    return [before, run = std::move(run)](Post& post) {
        if (before)
            before->waitUntilDone(Monitor::kGoodbye);
        run(post);
    };
}

} // namespace

struct Monitor::Posts {
    mutable std::mutex mutex;
    PostPointer broker, files;

    std::pair<PostPointer, PostPointer> both() const {
        const std::lock_guard lock(mutex);
        return {broker, files};
    }
    /// Returns the one before, which ends.
    PostPointer exchange(PostPointer Posts::*which, PostPointer now) {
        const std::lock_guard lock(mutex);
        return std::exchange(this->*which, std::move(now));
    }

    MonitorSettings settings; ///< for the thread of use()
    PostPointer lastBroker, lastFiles;
};

Monitor::Monitor() : m_posts(std::make_shared<Posts>()) {}

Monitor::~Monitor() {
    const auto [broker, files] = m_posts->both();
    use({});
    const auto until = Steady::now() + kGoodbye;
    for (const PostPointer& post : {broker, files})
        if (post)
            post->waitUntilDone(
                std::max(milliseconds(0), std::chrono::duration_cast<milliseconds>(until - Steady::now())));
}

void Monitor::use(const MonitorSettings& settings) {
    const MonitorSettings before = std::exchange(m_posts->settings, settings);
    const auto change = [&](PostPointer Posts::*which, PostPointer& last, const char* name, bool isOn,
                            auto run) {
        if (const PostPointer old = m_posts->exchange(which, nullptr)) {
            old->finish();
            last = old;
        }
        if (isOn)
            m_posts->exchange(which, start(name, after(last, std::move(run))));
    };
    if (settings.activeBroker() != before.activeBroker())
        change(&Posts::broker, m_posts->lastBroker, "mqtt", settings.activeBroker().has_value(),
               [broker = settings.broker](Post& post) { runBroker(post, broker); });
    if (settings.activeFolder() != before.activeFolder())
        change(&Posts::files, m_posts->lastFiles, "status files", settings.activeFolder().has_value(),
               [folder = settings.statusFolder](Post& post) { runFiles(post, folder); });
}

MonitorState Monitor::state() const {
    MonitorState state;
    const auto [broker, files] = m_posts->both();
    state.isOn = broker || files;
    if (broker)
        broker->describeBroker(state);
    if (files)
        state.fileProblem = files->problem();
    return state;
}

EngineWatch Monitor::inlet() const {
    const auto isWanted = [posts = m_posts] {
        const auto [broker, files] = posts->both();
        return broker || files;
    };
    return {isWanted, [posts = m_posts](const Snapshot& snapshot) {
                const auto [broker, files] = posts->both();
                if (!broker && !files)
                    return;
                const double now_s = utcNow_s();
                auto status = std::make_shared<MonitorStatus>(MonitorStatus{now_s, false, snapshot});
                std::vector<MonitorEvent> events;
                for (const TraceEvent& event : snapshot.newEvents)
                    events.push_back({now_s, event});
                status->snapshot.newEvents.clear();
                status->snapshot.traffic.reset(); // it lives as long as the engine
                for (const PostPointer& post : {broker, files})
                    if (post)
                        post->put(status, events);
            }};
}

Result<void> tryMonitor(const MonitorSettings& settings) {
    if (auto valid = validate(settings); !valid)
        return valid;
    if (const auto folder = settings.activeFolder())
        if (auto tried = tryStatusFolder(*folder); !tried)
            return tried;
    const auto broker = settings.activeBroker();
    if (!broker)
        return {};
    const auto access = accessOf(*broker);
    if (!access)
        return access.error();
    auto link = makeBrokerLink();
    if (!link)
        return link.error();
    (*link)->begin(*access);
    const auto until = Steady::now() + 2 * BrokerLink::kPatience;
    bool isSent = false;
    while ((*link)->state() != BrokerLink::State::Failed && Steady::now() < until) {
        (*link)->work(kLook);
        if ((*link)->state() != BrokerLink::State::Connected)
            continue;
        isSent = isSent || (*link)->publish(broker->topic + "/test", "Bask was here", false) != 0;
        if (isSent && (*link)->unanswered().empty()) {
            (*link)->end();
            return {};
        }
    }
    const std::string why =
        (*link)->state() == BrokerLink::State::Failed ? (*link)->problem() : "it does not acknowledge";
    const Message problem = noBroker(*broker, why);
    return Error(problem.code, {}, problem.args);
}

} // namespace bask
