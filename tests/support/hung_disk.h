#pragma once
// A disk that hangs on command: the system's calls on files, replaced in this program or, by LD_PRELOAD, in
// another one.

#include <atomic>
#include <cstddef>
#include <string>

namespace bask::test {

/// What is asked of a file. Bits of HungDisk::calls.
enum DiskCall : unsigned {
    kOpen = 1U,
    kWrite = 2U,
    kSync = 4U,
    kSpace = 8U,  ///< statvfs
    kNames = 16U, ///< stat, access, rename, unlink, mkdir, read
    kAll = 31U,
    kFull = 32U ///< writes are refused: no space left
};

/// Plain memory, shared with a program whose environment names its file (BASK_HUNG_DISK).
struct HungDisk {
    static constexpr int kLongest_s = 30;

    std::atomic<unsigned> calls; ///< these hang, for kLongest_s at most
    std::atomic<unsigned> held;  ///< so many calls have hung, or were refused, so far
    std::atomic<int> exempt;     ///< this thread's do not
    char folder[512];            ///< files below it; set before `calls`

    /// The first write of these bytes to what is no file, such as a port or a heater's guard, is timed:
    /// seconds of the monotonic clock, when the system has taken them; 0: not yet.
    char watched[32];
    std::atomic<double> written_s;
    void watchFor(const std::string& bytes);

    void hang(unsigned which, const std::string& below);
    void release();
};

/// Of this program.
HungDisk& hungDisk();

} // namespace bask::test
