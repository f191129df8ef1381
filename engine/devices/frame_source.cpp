#include "engine/devices/frame_source.h"

#include "engine/base/clock.h"
#include "engine/base/message_code.h"
#include "engine/media/media.h"
#include "engine/shape/contour_import.h"

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <poll.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr double kPicturePeriod_s = 0.1;
constexpr int kMinSide_px = 32;
constexpr std::uint64_t kMaxPixels = 64'000'000;
constexpr double kOldestStamp_s = 0.5; // a driver's time stamp farther back is on another clock

std::string sizeText(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height) + " pixels";
}

// Why pictures of a size cannot be used; empty when they can.
std::string sizeProblem(int width, int height) {
    if (width < kMinSide_px || height < kMinSide_px)
        return "its pictures have only " + sizeText(width, height);
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return pixels > kMaxPixels ? "its pictures have " + sizeText(width, height) + ", too many" : "";
}

// The libraries write to stderr what is told in words here. FFmpeg's level is read once, from the
// environment.
void silenceLibraries() {
    static std::once_flag once;
    std::call_once(once, [] {
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
        setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    });
}

class PictureSource final : public FrameSource {
public:
    PictureSource(std::string name, std::vector<std::string> paths)
        : m_name(std::move(name)), m_paths(std::move(paths)) {}

    Result<CaughtPicture> next() override {
        const std::string& path = m_paths[m_next];
        m_next = (m_next + 1) % m_paths.size();
        auto picture = readGreyPicture(path);
        if (!picture)
            return captureRefusal(m_name, describe(picture.error()));
        if (const std::string problem = sizeProblem(picture->width, picture->height); !problem.empty())
            return captureRefusal(m_name, problem);
        if (m_width > 0 && (picture->width != m_width || picture->height != m_height))
            return captureRefusal(m_name, path + " has " + sizeText(picture->width, picture->height) +
                                              ", those before " + sizeText(m_width, m_height));
        m_width = picture->width;
        m_height = picture->height;
        return CaughtPicture{std::move(*picture), SteadyClock().now_s()};
    }
    double period_s() const override { return kPicturePeriod_s; }
    std::size_t count() const { return m_paths.size(); }

private:
    std::string m_name;
    std::vector<std::string> m_paths;
    std::size_t m_next = 0;
    int m_width = 0, m_height = 0;
};

bool isPictureName(const fs::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char c) { return std::tolower(c); });
    const auto known = {".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff"};
    return std::ranges::find(known, ending) != known.end();
}

Result<std::unique_ptr<FrameSource>> openFolder(const std::string& name,
                                                const std::function<bool()>& isStopped) {
    std::vector<std::string> paths;
    std::error_code problem;
    for (fs::directory_iterator entry(name, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        std::error_code unasked;
        if (entry->is_regular_file(unasked) && isPictureName(entry->path()))
            paths.push_back(entry->path().string());
    }
    if (problem)
        return captureRefusal(name, problem.message());
    if (paths.empty())
        return captureRefusal(name, "there is no picture in this folder");
    std::ranges::sort(paths);
    auto source = std::make_unique<PictureSource>(name, std::move(paths));
    for (std::size_t k = 0; k < source->count() && !isStopped(); ++k)
        if (auto picture = source->next(); !picture)
            return picture.error();
    return Result<std::unique_ptr<FrameSource>>(std::move(source));
}

enum class VideoKind { Device, Stream, Fifo, File };

class VideoSource final : public FrameSource {
public:
    VideoSource(std::string name, VideoKind kind) : m_name(std::move(name)), m_kind(kind) {}

    Result<void> open() {
        silenceLibraries();
        if (!(m_kind == VideoKind::Device ? openDevice() : openByFfmpeg()))
            return captureRefusal(m_name, m_kind == VideoKind::Device ? "no camera answers there"
                                          : m_kind == VideoKind::File ? "not a video that can be read"
                                                                      : "no video comes from there");
        const double rate_Hz = m_capture->get(cv::CAP_PROP_FPS);
        m_period_s = m_kind != VideoKind::File            ? 0.0
                     : rate_Hz >= 1.0 && rate_Hz <= 240.0 ? 1.0 / rate_Hz
                                                          : kPicturePeriod_s;
        return checkSize(static_cast<int>(m_capture->get(cv::CAP_PROP_FRAME_WIDTH)),
                         static_cast<int>(m_capture->get(cv::CAP_PROP_FRAME_HEIGHT)));
    }

    Result<CaughtPicture> next() override {
        cv::Mat image;
        if (!m_capture->read(image) && m_kind == VideoKind::File) {
            if (auto opened = open(); !opened)
                return opened.error();
            m_capture->read(image);
        }
        const double now_s = SteadyClock().now_s();
        if (image.empty())
            return captureRefusal(m_name,
                                  m_kind == VideoKind::File ? "there is no picture in it" : "it has ended");
        if (auto checked = checkSize(image.cols, image.rows); !checked)
            return checked.error();
        cv::Mat grey = image;
        if (image.channels() > 1)
            cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
        CaughtPicture caught{{grey.cols, grey.rows, bytesOf(grey)}, now_s};
        const double stamp_s =
            m_kind == VideoKind::Device ? 1e-3 * m_capture->get(cv::CAP_PROP_POS_MSEC) : 0.0;
        if (stamp_s <= now_s && stamp_s >= now_s - kOldestStamp_s)
            caught.caught_s = stamp_s;
        return caught;
    }

    double period_s() const override { return m_period_s; }
    /// A second reader of a FIFO would get halves of pictures.
    bool isWaitedFor() const override { return m_kind == VideoKind::Fifo; }

private:
    bool openDevice() {
        if (!m_capture->open(cameraDevice(m_name), cv::CAP_V4L2, {}))
            return false;
        // Uncompressed, USB 2 has room for some 10 such pictures a second only.
        m_capture->set(cv::CAP_PROP_FOURCC, fourCharacterCode("MJPG"));
        m_capture->set(cv::CAP_PROP_FRAME_WIDTH, 1280);
        m_capture->set(cv::CAP_PROP_FRAME_HEIGHT, 720);
        return true;
    }

    bool openByFfmpeg() {
        return m_capture->open(
            m_name, cv::CAP_FFMPEG,
            std::vector<int>{cv::CAP_PROP_OPEN_TIMEOUT_MSEC, 5000, cv::CAP_PROP_READ_TIMEOUT_MSEC, 2000});
    }

    Result<void> checkSize(int width, int height) {
        if (const std::string problem = sizeProblem(width, height); !problem.empty())
            return captureRefusal(m_name, problem);
        if (m_width > 0 && (width != m_width || height != m_height))
            return captureRefusal(m_name, "its pictures have " + sizeText(width, height) + " now, " +
                                              sizeText(m_width, m_height) + " before");
        m_width = width;
        m_height = height;
        return {};
    }

    std::string m_name;
    VideoKind m_kind;
    std::unique_ptr<VideoInput> m_capture = makeVideoInput();
    double m_period_s = 0.0;
    int m_width = 0, m_height = 0;
};

Result<std::unique_ptr<FrameSource>> openVideo(const std::string& name, VideoKind kind) {
    auto source = std::make_unique<VideoSource>(name, kind);
    if (auto opened = source->open(); !opened)
        return opened.error();
    return Result<std::unique_ptr<FrameSource>>(std::move(source));
}

// FFmpeg would wait for a writer inside of open(), where nobody can call it back.
Result<std::unique_ptr<FrameSource>> openFifo(const std::string& name,
                                              const std::function<bool()>& isStopped) {
    constexpr int kLook_ms = 50;
    pollfd fifo{::open(name.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC), POLLIN, 0};
    if (fifo.fd < 0)
        return captureRefusal(name, std::generic_category().message(errno));
    while ((fifo.revents & POLLIN) == 0 && !isStopped()) {
        ::poll(&fifo, 1, kLook_ms);
        if ((fifo.revents & POLLIN) == 0 && fifo.revents != 0) // its writer is gone: answers at once
            ::poll(nullptr, 0, kLook_ms);
    }
    auto source = isStopped()
                      ? Result<std::unique_ptr<FrameSource>>(captureRefusal(name, "not wanted any more"))
                      : openVideo(name, VideoKind::Fifo);
    ::close(fifo.fd);
    return source;
}

Result<std::unique_ptr<FrameSource>> openFile(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    if (!file.is_open())
        return captureRefusal(name, "it cannot be read");
    if (file.peek() == std::ifstream::traits_type::eof())
        return captureRefusal(name, "the file is empty");
    if (!isPictureName(name))
        return openVideo(name, VideoKind::File);
    auto source = std::make_unique<PictureSource>(name, std::vector{name});
    if (auto picture = source->next(); !picture)
        return picture.error();
    return Result<std::unique_ptr<FrameSource>>(std::move(source));
}

Result<std::unique_ptr<FrameSource>> openByName(const std::string& name,
                                                const std::function<bool()>& isStopped) {
    if (name.empty())
        return captureRefusal(name, "no camera is named");
    if (isCameraNumber(name))
        return openVideo(name, VideoKind::Device);
    if (name.find("://") != std::string::npos)
        return openVideo(name, VideoKind::Stream);
    std::error_code problem;
    const fs::file_status status = fs::status(name, problem);
    switch (status.type()) {
    case fs::file_type::directory:
        return openFolder(name, isStopped);
    case fs::file_type::character:
        return openVideo(name, VideoKind::Device);
    case fs::file_type::fifo:
        return openFifo(name, isStopped);
    case fs::file_type::regular:
        return openFile(name);
    case fs::file_type::not_found:
        return captureRefusal(name, "there is no such file or device");
    default:
        return captureRefusal(name, problem ? problem.message() : "neither file nor device");
    }
}

} // namespace

bool isCameraNumber(const std::string& name) {
    return !name.empty() && name.size() < 4 &&
           std::ranges::all_of(name, [](unsigned char c) { return std::isdigit(c); });
}

std::string cameraDevice(const std::string& name) {
    return isCameraNumber(name) ? "/dev/video" + name : name;
}

bool isSamePicture(const CaughtPicture& a, const CaughtPicture& b) {
    return a.picture.values == b.picture.values;
}

Result<std::unique_ptr<FrameSource>> openFrameSource(const std::string& name,
                                                     const std::function<bool()>& isStopped) {
    try {
        return openByName(name, isStopped);
    } catch (const std::exception& problem) {
        return captureRefusal(name, problem.what());
    }
}

} // namespace bask
