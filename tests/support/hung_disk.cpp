// Compiled into a test, and as a library for LD_PRELOAD: it uses nothing of the project and of Qt.

#include "tests/support/hung_disk.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>

#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace bask::test {
namespace {

HungDisk g_own{};
HungDisk* g_disk = &g_own;

/// Before main(): memory that the test shares.
[[gnu::constructor]] void attach() {
    const char* const name = std::getenv("BASK_HUNG_DISK");
    if (name == nullptr)
        return;
    const auto file = static_cast<int>(::syscall(SYS_openat, AT_FDCWD, name, O_RDWR | O_CLOEXEC, 0));
    void* const memory = ::mmap(nullptr, sizeof(HungDisk), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file < 0 || memory == MAP_FAILED)
        std::abort(); // a test without its fault would pass
    g_disk = static_cast<HungDisk*>(memory);
    ::syscall(SYS_close, file);
}

bool isBelow(const char* path) {
    return std::strncmp(path, g_disk->folder, std::strlen(g_disk->folder)) == 0;
}

/// A relative path is below the working folder.
bool isMeant(const char* path) {
    if (path == nullptr)
        return false;
    if (path[0] == '/')
        return isBelow(path);
    char folder[512] = {};
    return ::syscall(SYS_getcwd, folder, sizeof folder) > 0 && isBelow(folder);
}

bool isMeant(int file) {
    struct stat there {};
    if (::syscall(SYS_fstat, file, &there) != 0 || !(S_ISREG(there.st_mode) || S_ISDIR(there.st_mode)))
        return false;
    char link[64], path[512] = {};
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
    return ::syscall(SYS_readlink, link, path, sizeof path - 1) > 0 && isBelow(path);
}

/// True: the call is to be refused.
template <class File> bool hold(unsigned call, File file) {
    const int error = errno;
    bool isHeld = false;
    for (int i = 0; i < HungDisk::kLongest_s * 100; ++i) {
        const unsigned calls = g_disk->calls.load(std::memory_order_relaxed);
        const bool isRefused = (calls & kFull) != 0 && call == kWrite;
        if ((calls & call) == 0 && !isRefused)
            break;
        if (!isHeld && (::syscall(SYS_gettid) == g_disk->exempt || !isMeant(file)))
            break;
        if (!isHeld)
            ++g_disk->held;
        isHeld = true;
        if (isRefused)
            return true;
        constexpr timespec kTurn{0, 10'000'000};
        ::nanosleep(&kTurn, nullptr);
    }
    errno = error;
    return false;
}

void noteWritten(const void* bytes, std::size_t count) {
    if (g_disk->watched[0] == 0 || g_disk->written_s != 0.0 ||
        ::memmem(bytes, count, g_disk->watched, std::strlen(g_disk->watched)) == nullptr)
        return;
    timespec now{};
    ::clock_gettime(CLOCK_MONOTONIC, &now);
    g_disk->written_s = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Function> Function* next(const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

HungDisk& hungDisk() {
    return *g_disk;
}

void HungDisk::hang(unsigned which, const std::string& below) {
    below.copy(folder, sizeof folder - 1);
    folder[below.size()] = 0;
    held = 0;
    calls = which;
}

void HungDisk::watchFor(const std::string& bytes) {
    bytes.copy(watched, sizeof watched - 1);
    watched[bytes.size()] = 0;
    written_s = 0.0;
}

void HungDisk::release() {
    calls = 0;
}

} // namespace bask::test

using namespace bask::test; // NOLINT: below is the system's own namespace

// Each holds the call and then hands it on.
#define BASK_HOLD(call, file, result, name, parameters, arguments)                                           \
    extern "C" result name parameters {                                                                      \
        static auto* const real = next<result parameters>(#name);                                            \
        if (hold(call, file)) {                                                                              \
            errno = ENOSPC;                                                                                  \
            return -1;                                                                                       \
        }                                                                                                    \
        return real arguments;                                                                               \
    }

#define BASK_OPEN(name)                                                                                      \
    extern "C" int name(const char* path, int flags, ...) {                                                  \
        std::va_list rest;                                                                                   \
        va_start(rest, flags);                                                                               \
        const int mode = (flags & (O_CREAT | O_TMPFILE)) != 0 ? va_arg(rest, int) : 0;                       \
        va_end(rest);                                                                                        \
        (void)hold(kOpen, path);                                                                             \
        return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));                         \
    }

extern "C" ssize_t write(int file, const void* bytes, size_t count) {
    if (hold(kWrite, file)) {
        errno = ENOSPC;
        return -1;
    }
    const auto written = static_cast<ssize_t>(::syscall(SYS_write, file, bytes, count));
    if (written > 0)
        noteWritten(bytes, count);
    return written;
}
/// To a guard, which has the port.
extern "C" ssize_t send(int file, const void* bytes, size_t count, int flags) {
    const auto sent = static_cast<ssize_t>(::syscall(SYS_sendto, file, bytes, count, flags, nullptr, 0));
    if (sent > 0)
        noteWritten(bytes, count);
    return sent;
}
BASK_OPEN(open)
BASK_OPEN(open64)
BASK_HOLD(kWrite, file, ssize_t, pwrite64, (int file, const void* bytes, size_t count, off64_t at),
          (file, bytes, count, at))
BASK_HOLD(kWrite, file, int, ftruncate64, (int file, off64_t size), (file, size))
BASK_HOLD(kWrite, file, int, posix_fallocate64, (int file, off64_t at, off64_t size), (file, at, size))
BASK_HOLD(kSync, file, int, fsync, (int file), (file))
BASK_HOLD(kSync, file, int, fdatasync, (int file), (file))
BASK_HOLD(kSpace, path, int, statvfs, (const char* path, struct statvfs* out), (path, out))
BASK_HOLD(kSpace, path, int, statvfs64, (const char* path, struct statvfs64* out), (path, out))
BASK_HOLD(kNames, path, int, access, (const char* path, int mode), (path, mode))
BASK_HOLD(kNames, path, int, unlink, (const char* path), (path))
BASK_HOLD(kNames, path, int, rename, (const char* path, const char* to), (path, to))
BASK_HOLD(kNames, path, int, mkdir, (const char* path, mode_t mode), (path, mode))
BASK_HOLD(kNames, path, int, stat, (const char* path, struct stat* out), (path, out))
BASK_HOLD(kNames, path, int, stat64, (const char* path, struct stat64* out), (path, out))
BASK_HOLD(kNames, path, int, lstat, (const char* path, struct stat* out), (path, out))
BASK_HOLD(kNames, path, int, lstat64, (const char* path, struct stat64* out), (path, out))
BASK_HOLD(kNames, path, int, statx, (int at, const char* path, int flags, unsigned mask, struct statx* out),
          (at, path, flags, mask, out))
BASK_HOLD(kNames, file, ssize_t, pread64, (int file, void* bytes, size_t count, off64_t at),
          (file, bytes, count, at))
