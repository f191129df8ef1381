#pragma once
// A file that one process has to itself, however that process ends.

#include <QFile>

#include <fcntl.h>

#include <sys/file.h>
#include <unistd.h>

namespace bask {

/// The file, with O_CREAT made if need be, open and locked: until it is closed or this process is gone. -1:
/// another process has it, or there can be none.
inline int openLocked(const QString& path, int make = O_CREAT) {
    const int file = ::open(QFile::encodeName(path).constData(), O_RDWR | make | O_CLOEXEC, 0600);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0) {
        ::close(file);
        return -1;
    }
    return file;
}

} // namespace bask
