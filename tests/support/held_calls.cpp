#include "tests/support/held_calls.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <future>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <thread>

#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bask::test {

struct HeldCalls::Shared {
    void listen(int listener) {
        for (;;) {
            seccomp_notif asked{};
            if (::ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) {
                if (errno == EINTR || errno == ENOENT)
                    continue;
                return;
            }
            if (isHolding)
                ++held;
            for (int i = 0; i < kLongest_ms && isHolding; ++i)
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            seccomp_notif_resp answer{};
            answer.id = asked.id;
            answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
            (void)::ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &answer);
        }
    }

    static constexpr int kLongest_ms = 10000;
    std::atomic<bool> isHolding = false;
    std::atomic<int> held = 0;
};

HeldCalls::HeldCalls() : m_shared(std::make_shared<Shared>()) {}

HeldCalls::~HeldCalls() {
    release();
}

std::string HeldCalls::begin(Which which) {
    std::promise<int> opened;
    std::thread([state = m_shared, listener = opened.get_future()]() mutable {
        state->listen(listener.get()); // it was begun before the filter is: it is not asked itself
    }).detach();
    const auto argument = static_cast<unsigned>(
        offsetof(seccomp_data, args) + 8 * static_cast<std::size_t>(which.place < 0 ? 0 : which.place));
    std::array program{
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(which.number), 0, 3),
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, argument),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, which.value, 0,
                             static_cast<unsigned char>(which.place < 0 ? 0 : 1)),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog all{static_cast<unsigned short>(program.size()), program.data()};
    int listener = -1;
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        listener = static_cast<int>(
            ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &all));
    const int reason = errno;
    opened.set_value(listener);
    return listener < 0 ? std::strerror(reason) : std::string();
}

void HeldCalls::hold() {
    m_shared->isHolding = true;
}

void HeldCalls::release() {
    m_shared->isHolding = false;
}

int HeldCalls::held() const {
    return m_shared->held;
}

} // namespace bask::test
