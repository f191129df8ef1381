// bask-mqtt.so: see broker_link.h.

#include "engine/monitor/broker_link.h"

#include <mosquitto.h>

#include <cerrno>
#include <csignal>
#include <cstring>

#include <ctime>
#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace bask {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kKeepAlive_s = 5; // the least that mosquitto takes: a network that is gone is seen
constexpr const char* kNoAnswer = "no answer";
constexpr const char* kSystemCertificates = "/etc/ssl/certs";

/// A connection that is lost while TLS writes to it raises SIGPIPE in this thread, which would end the
/// program.
class NoSigpipe {
public:
    NoSigpipe() {
        sigset_t waiting;
        ::sigpending(&waiting);
        m_wasWaiting = sigismember(&waiting, SIGPIPE) == 1;
        sigemptyset(&m_pipe);
        sigaddset(&m_pipe, SIGPIPE);
        ::pthread_sigmask(SIG_BLOCK, &m_pipe, &m_before);
    }
    ~NoSigpipe() {
        const timespec atOnce{};
        if (!m_wasWaiting)
            static_cast<void>(::sigtimedwait(&m_pipe, nullptr, &atOnce));
        ::pthread_sigmask(SIG_SETMASK, &m_before, nullptr);
    }
    NoSigpipe(const NoSigpipe&) = delete;
    NoSigpipe& operator=(const NoSigpipe&) = delete;

private:
    sigset_t m_pipe{}, m_before{};
    bool m_wasWaiting = false;
};

/// What the library changes for the whole program is taken back.
mosquitto* newClient(const std::string& id, void* owner) {
    struct sigaction before {};
    ::sigaction(SIGPIPE, nullptr, &before);
    mosquitto* const client = mosquitto_new(id.c_str(), true, owner);
    ::sigaction(SIGPIPE, &before, nullptr);
    return client;
}

/// Returns why not, empty: a connection could be made; it is closed again.
std::string tryAddress(const addrinfo& address) {
    const int socket = ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket < 0)
        return std::strerror(errno);
    int problem = ::connect(socket, address.ai_addr, address.ai_addrlen) == 0 ? 0 : errno;
    if (problem == EINPROGRESS) {
        pollfd wait{socket, POLLOUT, 0};
        const auto patience = std::chrono::milliseconds(BrokerLink::kPatience).count();
        socklen_t size = sizeof problem;
        if (::poll(&wait, 1, static_cast<int>(patience)) < 1)
            problem = ETIMEDOUT;
        else
            ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &problem, &size);
    }
    ::close(socket);
    return problem == 0 ? std::string() : std::strerror(problem);
}

/// Where a host takes connections.
struct Reached {
    std::string address; ///< in numbers
    bool isIpv6 = false;
};

/// Returns why a host takes none; where it does, empty, and `reached` is the first of its addresses that
/// does. The library's own connection waits for minutes where nobody answers, and does not say why it failed.
std::string tryHost(const std::string& host, int port, Reached& reached) {
    addrinfo wanted{}, *found = nullptr;
    wanted.ai_family = AF_UNSPEC;
    wanted.ai_socktype = SOCK_STREAM;
    if (const int code = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found);
        code != 0)
        return ::gai_strerror(code);
    std::string problem = "it has no address";
    for (const addrinfo* each = found; each != nullptr && !problem.empty(); each = each->ai_next) {
        char number[NI_MAXHOST] = "";
        problem = tryAddress(*each);
        ::getnameinfo(each->ai_addr, each->ai_addrlen, number, sizeof number, nullptr, 0, NI_NUMERICHOST);
        reached = {number, each->ai_family == AF_INET6};
    }
    ::freeaddrinfo(found);
    return problem;
}

class MosquittoLink final : public BrokerLink {
public:
    MosquittoLink() {
        static const int kReady = mosquitto_lib_init();
        static_cast<void>(kReady);
    }
    ~MosquittoLink() override {
        const NoSigpipe guard;
        if (m_client != nullptr)
            mosquitto_destroy(m_client);
    }
    MosquittoLink(const MosquittoLink&) = delete;
    MosquittoLink& operator=(const MosquittoLink&) = delete;

    void begin(const BrokerAccess& access) override {
        const NoSigpipe guard;
        m_presence = access.presenceTopic;
        Reached reached;
        if (const std::string problem = tryHost(access.host, access.port, reached); !problem.empty())
            return fail(problem);
        m_client = newClient(access.clientId, this);
        if (m_client == nullptr)
            return fail("no memory");
        listen();
        mosquitto_int_option(m_client, MOSQ_OPT_TCP_NODELAY, 1);
        if (!access.user.empty())
            mosquitto_username_pw_set(m_client, access.user.c_str(),
                                      access.password.empty() ? nullptr : access.password.c_str());
        if (access.usesTls && !useCertificates(access.caFile))
            return;
        if (!m_presence.empty())
            mosquitto_will_set(m_client, m_presence.c_str(), 4, "gone", 1, true);
        // A certificate is for the name, which the library looks up once more: of the same family at least.
        const int code =
            mosquitto_connect_bind(m_client, access.usesTls ? access.host.c_str() : reached.address.c_str(),
                                   access.port, kKeepAlive_s, reached.isIpv6 ? "::" : "0.0.0.0");
        m_begun = Clock::now();
        if (code != MOSQ_ERR_SUCCESS)
            fail(code);
    }

    void work(std::chrono::milliseconds max) override {
        if (m_state == State::Failed)
            return;
        const NoSigpipe guard;
        if (m_state == State::Connecting && Clock::now() - m_begun > kPatience)
            return fail(kNoAnswer);
        const int code = mosquitto_loop(m_client, static_cast<int>(max.count()), 1);
        if (code != MOSQ_ERR_SUCCESS && m_state != State::Failed)
            fail(code);
    }

    State state() const override { return m_state; }
    std::string problem() const override { return m_problem; }
    bool isBusy() const override {
        return m_state != State::Connected || mosquitto_want_write(m_client) ||
               m_unanswered.size() >= kMaxUnanswered;
    }
    const std::set<int>& unanswered() const override { return m_unanswered; }

    int publish(const std::string& topic, const std::string& payload, bool isRetained) override {
        const NoSigpipe guard;
        int id = 0;
        const int code = mosquitto_publish(m_client, &id, topic.c_str(), static_cast<int>(payload.size()),
                                           payload.data(), 1, isRetained);
        if (code == MOSQ_ERR_SUCCESS)
            m_unanswered.insert(id);
        else if (m_state != State::Failed)
            fail(code);
        return code == MOSQ_ERR_SUCCESS ? id : 0;
    }

    void end() override {
        const NoSigpipe guard;
        if (m_state == State::Connected)
            mosquitto_disconnect(m_client);
    }

private:
    void listen() {
        mosquitto_connect_callback_set(m_client, [](mosquitto*, void* self, int code) {
            static_cast<MosquittoLink*>(self)->connected(code);
        });
        mosquitto_publish_callback_set(m_client, [](mosquitto*, void* self, int id) {
            static_cast<MosquittoLink*>(self)->m_unanswered.erase(id);
        });
        mosquitto_log_callback_set(m_client, [](mosquitto*, void* self, int level, const char* text) {
            std::string& first = static_cast<MosquittoLink*>(self)->m_log; // what follows follows from it
            if (level == MOSQ_LOG_ERR && first.empty())
                first = text;
        });
    }

    bool useCertificates(const std::string& file) {
        const int code =
            mosquitto_tls_set(m_client, file.empty() ? nullptr : file.c_str(),
                              file.empty() ? kSystemCertificates : nullptr, nullptr, nullptr, nullptr);
        if (code != MOSQ_ERR_SUCCESS)
            fail("the certificates in " + (file.empty() ? kSystemCertificates : file) + " cannot be read");
        return code == MOSQ_ERR_SUCCESS;
    }

    void connected(int code) {
        if (code != 0)
            return fail(mosquitto_connack_string(code));
        m_state = State::Connected;
        if (!m_presence.empty())
            publish(m_presence, "here", true);
    }

    /// The library's log says more than its codes: why a certificate is refused, say.
    void fail(int code) {
        if (code == MOSQ_ERR_KEEPALIVE) // for which the library has no words
            return fail(kNoAnswer);
        const char* const words = code == MOSQ_ERR_ERRNO ? std::strerror(errno) : mosquitto_strerror(code);
        fail(m_log.empty() ? std::string(words) : m_log);
    }
    void fail(const std::string& problem) {
        m_state = State::Failed;
        m_problem = problem;
    }

    mosquitto* m_client = nullptr;
    State m_state = State::Connecting;
    Clock::time_point m_begun = Clock::now();
    std::string m_presence, m_problem, m_log;
    std::set<int> m_unanswered;
};

} // namespace
} // namespace bask

extern "C" bask::BrokerLink* baskMakeBrokerLink() {
    return new bask::MosquittoLink;
}
