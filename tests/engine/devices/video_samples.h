#pragma once
// Pictures, videos and FIFOs that tests write, and waiting for a camera without sleeping blindly.

#include "engine/base/clock.h"

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace bask::test {

/// A folder of its own, gone with the test.
class ScratchFolder {
public:
    ScratchFolder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "bask_camera_XXXXXX").string();
        m_path = ::mkdtemp(pattern.data());
    }
    ~ScratchFolder() { std::filesystem::remove_all(m_path); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    std::string operator/(const std::string& name) const { return (m_path / name).string(); }
    std::string path() const { return m_path.string(); }

private:
    std::filesystem::path m_path;
};

/// Evenly grey, so that a picture tells which it is even after compression.
inline cv::Mat even(int grey, cv::Size size = {320, 240}) {
    return cv::Mat(size, CV_8UC3, cv::Scalar::all(grey));
}

/// Picture k is 40 + 10 k grey.
inline void writeVideo(const std::string& path, int pictures, double rate_Hz = 50.0,
                       cv::Size size = {320, 240}) {
    // Not by FFmpeg, which asks once, here or in Bask, what it may write to stderr (OpenCV 4.10).
    cv::VideoWriter writer(path, cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate_Hz,
                           size, true);
    for (int k = 0; k < pictures; ++k)
        writer.write(even(40 + 10 * k, size));
}

inline void writeText(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// Asks every few milliseconds until `condition` holds; false after limit_s.
template <class Condition> bool waitUntil(Condition condition, double limit_s = 20.0) {
    const SteadyClock clock;
    for (const double end_s = clock.now_s() + limit_s; !condition();) {
        if (clock.now_s() > end_s)
            return false;
        ::poll(nullptr, 0, 2);
    }
    return true;
}

/// A process that writes JPEG pictures into a FIFO, 30 a second, each another one.
class FifoWriter {
public:
    explicit FifoWriter(const std::string& fifo) {
        // As large as a camera's: FFmpeg looks at the first megabyte before it believes in a video.
        std::vector<std::vector<unsigned char>> pictures(20);
        cv::RNG random(7);
        for (auto& picture : pictures) {
            cv::Mat noise(480, 640, CV_8UC3);
            random.fill(noise, cv::RNG::UNIFORM, 0, 255);
            cv::imencode(".jpg", noise, picture);
        }
        m_process = ::fork();
        if (m_process != 0)
            return;
        std::signal(SIGPIPE, SIG_DFL);
        const int out = ::open(fifo.c_str(), O_WRONLY);
        for (std::size_t k = 0; out >= 0; ++k) {
            const auto& bytes = pictures[k % pictures.size()];
            for (std::size_t at = 0; at < bytes.size();) {
                const ssize_t put = ::write(out, bytes.data() + at, bytes.size() - at);
                if (put <= 0)
                    ::_exit(1);
                at += static_cast<std::size_t>(put);
            }
            ::poll(nullptr, 0, 33);
        }
        ::_exit(1);
    }
    ~FifoWriter() { end(); }
    FifoWriter(const FifoWriter&) = delete;
    FifoWriter& operator=(const FifoWriter&) = delete;

    void stop() const { ::kill(m_process, SIGSTOP); }
    void goOn() const { ::kill(m_process, SIGCONT); }
    void end() {
        if (m_process <= 0)
            return;
        ::kill(m_process, SIGKILL);
        ::waitpid(m_process, nullptr, 0);
        m_process = 0;
    }

private:
    pid_t m_process = 0;
};

} // namespace bask::test
