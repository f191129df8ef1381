#include "engine/monitor/status_files.h"

#include "engine/base/message_code.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace bask {
namespace {

/// Nothing that a signal would wait for, as in writeTextFile(): the disk may hang. Its own name for each
/// writing, and through no link: others may write into the folder, too.
Result<void> replace(const std::string& folder, const char* name, const std::string& text) {
    static std::atomic<int> number = 0;
    const std::string path = folder + '/' + name;
    const std::string part =
        folder + "/." + name + '.' + std::to_string(::getpid()) + '-' + std::to_string(++number);
    const auto failed = [&](int reason) {
        ::unlink(part.c_str());
        return Error(MessageCode::FileUnwritable, path, {std::strerror(reason)});
    };
    ::unlink(part.c_str()); // of an earlier process of this number
    const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (file < 0)
        return failed(errno);
    errno = ENOSPC; // of a short write
    const bool isWritten = ::write(file, text.data(), text.size()) == static_cast<ssize_t>(text.size());
    const int writeError = isWritten ? 0 : errno;
    const int closed = ::close(file);
    if (!isWritten || closed != 0)
        return failed(isWritten ? errno : writeError);
    if (::rename(part.c_str(), path.c_str()) != 0)
        return failed(errno);
    return {};
}

} // namespace

Result<void> writeStatusFiles(const MonitorStatus& status, const std::string& folder) {
    auto done = replace(folder, kStatusFile, statusJson(status) + '\n');
    return done ? replace(folder, kMetricsFile, statusMetrics(status)) : done;
}

Result<void> tryStatusFolder(const std::string& folder) {
    constexpr const char* kTest = ".bask-test";
    auto done = replace(folder, kTest, "test\n");
    ::unlink((folder + '/' + kTest).c_str());
    return done;
}

} // namespace bask
