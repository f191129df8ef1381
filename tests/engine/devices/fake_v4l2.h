#pragma once
// A V4L2 camera without a kernel's: this program's own open, ioctl and mmap stand before those of the C
// library, also for OpenCV's backend, and answer for one device.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

namespace bask::test {

enum class FakeCameraMood {
    Good,
    Silent,  ///< no frame comes
    Gone,    ///< unplugged: ENODEV
    Constant ///< all bytes of a frame are the same
};

/// The device that /dev/video77 is. Set what it sends before it is opened.
struct FakeCamera {
    static constexpr const char* kName = "/dev/video77";

    std::uint32_t format = 0; ///< V4L2_PIX_FMT_...: the only one that it gives
    int width = 0, height = 0;
    std::string frame;        ///< bytes that it sends
    std::size_t changing = 0; ///< of them, whose lowest bits count up, as noise would
    double period_s = 0.02;
    std::atomic<int> opened{0}, sent{0};

    /// Any thread, at any time.
    void setMood(FakeCameraMood mood);
    FakeCameraMood mood() const { return m_mood; }

private:
    std::atomic<FakeCameraMood> m_mood{FakeCameraMood::Good};
};
FakeCamera& fakeCamera();

} // namespace bask::test
