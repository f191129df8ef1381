#pragma once
// A file that one process owns until that process ends, in whatever way.

#include <QFile>

#include <fcntl.h>

#include <sys/file.h>
#include <unistd.h>

namespace bask {

/// Opens and locks the file; with O_CREAT it is created if necessary. The lock lasts until it is closed or
/// this process ends. Returns -1 if another process has locked it, or it cannot be opened.
inline int openLocked(const QString& path, int make = O_CREAT) {
    const int file = ::open(QFile::encodeName(path).constData(), O_RDWR | make | O_CLOEXEC, 0600);
    if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) != 0) {
        ::close(file);
        return -1;
    }
    return file;
}

} // namespace bask
