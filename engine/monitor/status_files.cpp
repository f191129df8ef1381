#include "engine/monitor/status_files.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
#include <unistd.h>

namespace bask {
namespace {

/// Nothing that a signal would wait for, as in writeTextFile(): the disk may hang. By way of a folder of its
/// own, and through no link: others may write into this one, too.
Result<void> replace(const std::string& folder, const char* name, const std::string& text) {
    const std::string path = folder + '/' + name;
    const auto failed = [&](int reason) {
        return Error(MessageCode::FileUnwritable, path, {std::strerror(reason)});
    };
    const auto hidden = HiddenFolder::in(folder);
    if (!hidden)
        return Error(MessageCode::FileUnwritable, path, hidden.error().message.args);
    const std::string part = hidden->place(name);
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
