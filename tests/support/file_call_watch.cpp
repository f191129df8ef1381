#include "tests/support/file_call_watch.h"

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>
#include <future>
#include <linux/filter.h>
#include <linux/magic.h>
#include <linux/seccomp.h>
#include <mutex>
#include <thread>
#include <utility>

#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/statfs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bask::test {
namespace {

enum class By { Path, PathAt, File, Nothing };
struct FileCall {
    int number;
    const char* name;
    By by;
};

/// Calls by a number of a file that is open count where that is a file or a folder, not a socket or a
/// terminal.
constexpr std::array kCalls{
    FileCall{SYS_open, "open", By::Path},
    FileCall{SYS_openat, "openat", By::PathAt},
    FileCall{SYS_openat2, "openat2", By::PathAt},
    FileCall{SYS_creat, "creat", By::Path},
    FileCall{SYS_stat, "stat", By::Path},
    FileCall{SYS_lstat, "lstat", By::Path},
    FileCall{SYS_newfstatat, "newfstatat", By::PathAt},
    FileCall{SYS_statx, "statx", By::PathAt},
    FileCall{SYS_access, "access", By::Path},
    FileCall{SYS_faccessat, "faccessat", By::PathAt},
    FileCall{SYS_faccessat2, "faccessat2", By::PathAt},
    FileCall{SYS_readlink, "readlink", By::Path},
    FileCall{SYS_readlinkat, "readlinkat", By::PathAt},
    FileCall{SYS_statfs, "statfs", By::Path},
    FileCall{SYS_rename, "rename", By::Path},
    FileCall{SYS_renameat, "renameat", By::PathAt},
    FileCall{SYS_renameat2, "renameat2", By::PathAt},
    FileCall{SYS_unlink, "unlink", By::Path},
    FileCall{SYS_unlinkat, "unlinkat", By::PathAt},
    FileCall{SYS_link, "link", By::Path},
    FileCall{SYS_linkat, "linkat", By::PathAt},
    FileCall{SYS_symlink, "symlink", By::Path},
    FileCall{SYS_mkdir, "mkdir", By::Path},
    FileCall{SYS_mkdirat, "mkdirat", By::PathAt},
    FileCall{SYS_rmdir, "rmdir", By::Path},
    FileCall{SYS_truncate, "truncate", By::Path},
    FileCall{SYS_chmod, "chmod", By::Path},
    FileCall{SYS_chdir, "chdir", By::Path},
    FileCall{SYS_getcwd, "getcwd", By::Nothing},
    FileCall{SYS_sync, "sync", By::Nothing},
    FileCall{SYS_syncfs, "syncfs", By::File},
    FileCall{SYS_fsync, "fsync", By::File},
    FileCall{SYS_fdatasync, "fdatasync", By::File},
    FileCall{SYS_fstatfs, "fstatfs", By::File},
    FileCall{SYS_fstat, "fstat", By::File},
    FileCall{SYS_ftruncate, "ftruncate", By::File},
    FileCall{SYS_fallocate, "fallocate", By::File},
    FileCall{SYS_flock, "flock", By::File},
    FileCall{SYS_getdents64, "getdents64", By::File},
    FileCall{SYS_lseek, "lseek", By::File},
    FileCall{SYS_read, "read", By::File},
    FileCall{SYS_pread64, "pread64", By::File},
    FileCall{SYS_write, "write", By::File},
    FileCall{SYS_pwrite64, "pwrite64", By::File},
    FileCall{SYS_writev, "writev", By::File},
};

/// The kernel's own tables wait for no disk: the C library looks into them.
bool isOfKernel(const std::string& path) {
    return path.starts_with("/proc/sys/");
}

bool isFile(int number) {
    struct stat there {};
    struct statfs system {};
    return ::fstat(number, &there) == 0 && (S_ISREG(there.st_mode) || S_ISDIR(there.st_mode)) &&
           ::fstatfs(number, &system) == 0 && system.f_type != PROC_SUPER_MAGIC;
}

/// The caller waits meanwhile and is of this process, so its memory can be read here.
std::string words(const seccomp_data& data) {
    for (const FileCall& call : kCalls) {
        if (call.number != data.nr)
            continue;
        const auto path = [&](std::size_t i) {
            const auto* text = reinterpret_cast<const char*>(data.args[i]);
            const std::string name = text == nullptr ? "" : text;
            return isOfKernel(name) ? std::string() : std::string(call.name) + ' ' + name;
        };
        switch (call.by) {
        case By::Path:
            return path(0);
        case By::PathAt:
            return path(1);
        case By::File:
            return isFile(static_cast<int>(data.args[0]))
                       ? std::string(call.name) + ' ' + std::to_string(data.args[0])
                       : std::string();
        case By::Nothing:
            return call.name;
        }
    }
    return {};
}

/// Asks about kCalls, lets everything else pass.
std::vector<sock_filter> filter() {
    std::vector<sock_filter> out{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
    for (std::size_t i = 0; i < kCalls.size(); ++i)
        out.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(kCalls[i].number),
                               static_cast<unsigned char>(kCalls.size() - i), 0));
    out.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
    out.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_USER_NOTIF));
    return out;
}

} // namespace

struct FileCallWatch::Shared {
    void listen(int listener) {
        for (;;) {
            seccomp_notif asked{};
            if (::ioctl(listener, SECCOMP_IOCTL_NOTIF_RECV, &asked) != 0) {
                if (errno == EINTR || errno == ENOENT)
                    continue;
                return;
            }
            if (asked.pid == static_cast<unsigned>(thread))
                if (auto call = words(asked.data); !call.empty()) {
                    const std::lock_guard lock(mutex);
                    calls.push_back(std::move(call));
                }
            seccomp_notif_resp answer{};
            answer.id = asked.id;
            answer.flags = SECCOMP_USER_NOTIF_FLAG_CONTINUE;
            (void)::ioctl(listener, SECCOMP_IOCTL_NOTIF_SEND, &answer);
        }
    }

    long thread = 0;
    std::mutex mutex;
    std::vector<std::string> calls;
};

FileCallWatch::FileCallWatch() : m_shared(std::make_shared<Shared>()) {}

std::string FileCallWatch::watchThisThread() {
    m_shared->thread = ::syscall(SYS_gettid);
    std::promise<int> opened;
    std::thread([state = m_shared, listener = opened.get_future()]() mutable {
        state->listen(listener.get()); // it was begun before the filter is: it is not asked itself
    }).detach();
    auto program = filter();
    const sock_fprog all{static_cast<unsigned short>(program.size()), program.data()};
    int listener = -1;
    if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0)
        listener = static_cast<int>(
            ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_NEW_LISTENER, &all));
    const int reason = errno;
    opened.set_value(listener);
    return listener < 0 ? std::strerror(reason) : std::string();
}

std::vector<std::string> FileCallWatch::take() {
    const std::lock_guard lock(m_shared->mutex);
    return std::exchange(m_shared->calls, {});
}

} // namespace bask::test
