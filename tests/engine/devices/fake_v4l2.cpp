#include "tests/engine/devices/fake_v4l2.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstdarg>
#include <cstring>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <linux/videodev2.h>
#include <sys/mman.h>
#include <sys/timerfd.h>
#include <unistd.h>

namespace bask::test {

FakeCamera& fakeCamera() {
    static FakeCamera camera;
    return camera;
}

namespace {

constexpr int kBuffers = 8;

/// A timer that is due when a frame is: what select() waits for is real.
std::atomic<int> theDevice{-1};
std::array<void*, kBuffers> theBuffers{};
std::array<bool, kBuffers> isQueued{};
std::atomic<bool> isStreaming{false};

template <class Function> Function next(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

int fails(int error) {
    errno = error;
    return -1;
}

/// Frames are due while it sends any.
void setTimer() {
    const FakeCamera& camera = fakeCamera();
    const bool isSending = camera.mood() != FakeCameraMood::Silent;
    const long period_ns = isSending ? std::lround(1e9 * camera.period_s) : 0;
    const itimerspec times{{0, period_ns}, {0, period_ns}};
    timerfd_settime(theDevice, 0, &times, nullptr);
}

int openCamera() {
    const FakeCamera& camera = fakeCamera();
    if (camera.mood() == FakeCameraMood::Gone)
        return fails(ENOENT);
    const int device = timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK);
    theBuffers.fill(nullptr);
    isQueued.fill(false);
    isStreaming = false;
    theDevice = device;
    setTimer();
    ++fakeCamera().opened;
    return device;
}

void tell(v4l2_format& format) {
    const FakeCamera& camera = fakeCamera();
    format.fmt.pix.width = static_cast<std::uint32_t>(camera.width);
    format.fmt.pix.height = static_cast<std::uint32_t>(camera.height);
    format.fmt.pix.pixelformat = camera.format;
    format.fmt.pix.field = V4L2_FIELD_NONE;
    format.fmt.pix.bytesperline = static_cast<std::uint32_t>(2 * camera.width);
    format.fmt.pix.sizeimage = static_cast<std::uint32_t>(2 * camera.width * camera.height);
}

void fill(void* to) {
    FakeCamera& camera = fakeCamera();
    const int number = ++camera.sent;
    if (camera.mood() == FakeCameraMood::Constant) {
        std::memset(to, 0x75, camera.frame.size());
        return;
    }
    std::memcpy(to, camera.frame.data(), camera.frame.size());
    static_cast<unsigned char*>(to)[camera.changing] ^= static_cast<unsigned char>(number & 7);
}

int takeBuffer(v4l2_buffer& buffer) {
    FakeCamera& camera = fakeCamera();
    if (camera.mood() == FakeCameraMood::Gone)
        return fails(ENODEV);
    std::uint64_t due = 0;
    const bool isDue = ::read(theDevice, &due, sizeof due) == static_cast<ssize_t>(sizeof due);
    const auto queued = std::ranges::find(isQueued, true);
    if (!isDue || !isStreaming || queued == isQueued.end())
        return fails(EAGAIN);
    *queued = false;
    buffer.index = static_cast<std::uint32_t>(queued - isQueued.begin());
    buffer.bytesused = static_cast<std::uint32_t>(camera.frame.size());
    buffer.length = buffer.bytesused;
    buffer.flags = V4L2_BUF_FLAG_DONE;
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    buffer.timestamp = {now.tv_sec, now.tv_nsec / 1000};
    fill(theBuffers.at(buffer.index));
    return 0;
}

int control(unsigned long request, void* argument) {
    FakeCamera& camera = fakeCamera();
    if (camera.mood() == FakeCameraMood::Gone)
        return fails(ENODEV);
    switch (request) {
    case VIDIOC_QUERYCAP: {
        auto& capability = *static_cast<v4l2_capability*>(argument);
        capability = {};
        std::memcpy(capability.card, "Fake", 5);
        capability.capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
        capability.device_caps = capability.capabilities;
        return 0;
    }
    case VIDIOC_G_FMT:
    case VIDIOC_TRY_FMT:
    case VIDIOC_S_FMT: // a camera sets what it can, and says so
        tell(*static_cast<v4l2_format*>(argument));
        return 0;
    case VIDIOC_REQBUFS: {
        auto& wanted = *static_cast<v4l2_requestbuffers*>(argument);
        wanted.count = std::min<std::uint32_t>(wanted.count, kBuffers);
        return 0;
    }
    case VIDIOC_QUERYBUF: {
        auto& buffer = *static_cast<v4l2_buffer*>(argument);
        buffer.length = static_cast<std::uint32_t>(camera.frame.size());
        buffer.m.offset = buffer.index * 4096U;
        return 0;
    }
    case VIDIOC_QBUF:
        isQueued.at(static_cast<v4l2_buffer*>(argument)->index) = true;
        return 0;
    case VIDIOC_DQBUF:
        return takeBuffer(*static_cast<v4l2_buffer*>(argument));
    case VIDIOC_STREAMON:
        isStreaming = true;
        return 0;
    case VIDIOC_STREAMOFF:
        isStreaming = false;
        isQueued.fill(false);
        return 0;
    default: // it has no inputs, controls and rates to choose from
        return fails(EINVAL);
    }
}

} // namespace

void FakeCamera::setMood(FakeCameraMood mood) {
    m_mood = mood;
    if (theDevice >= 0)
        setTimer();
}

} // namespace bask::test

using namespace bask::test;

// NOLINTBEGIN: their names and arguments are the C library's
extern "C" {

int open(const char* path, int flags, ...) {
    if (std::strcmp(path, FakeCamera::kName) == 0)
        return openCamera();
    mode_t mode = 0;
    if ((flags & (O_CREAT | O_TMPFILE)) != 0) {
        va_list more;
        va_start(more, flags);
        mode = va_arg(more, mode_t);
        va_end(more);
    }
    return next<int (*)(const char*, int, mode_t)>("open")(path, flags, mode);
}

int ioctl(int device, unsigned long request, ...) {
    va_list more;
    va_start(more, request);
    void* const argument = va_arg(more, void*);
    va_end(more);
    if (device >= 0 && device == theDevice)
        return control(request, argument);
    return next<int (*)(int, unsigned long, void*)>("ioctl")(device, request, argument);
}

void* mmap(void* address, size_t length, int protection, int flags, int device, off_t offset) {
    const auto real = next<void* (*)(void*, size_t, int, int, int, off_t)>("mmap");
    if (device < 0 || device != theDevice)
        return real(address, length, protection, flags, device, offset);
    void* const buffer = real(nullptr, length, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    theBuffers.at(static_cast<std::size_t>(offset) / 4096U) = buffer;
    return buffer;
}
}
// NOLINTEND
