#include "engine/devices/thermal_frame_source.h"

#include "engine/base/clock.h"
#include "engine/devices/frame_source.h"
#include "engine/media/media.h"
#include "engine/thermography/frame_file.h"

#include <opencv2/videoio.hpp>

#include <filesystem>
#include <utility>
#include <vector>

namespace bask {
namespace {

using FramesOpened = Result<std::unique_ptr<ThermalFrameSource>>;

Result<CaughtThermalFrame> caughtNow(const std::string& name, Result<ThermalFrame> frame) {
    if (!frame)
        return captureRefusal(name, describe(frame.error()));
    return CaughtThermalFrame{std::move(*frame), SteadyClock().now_s()};
}

class RecordedFrames final : public ThermalFrameSource {
public:
    RecordedFrames(std::string name, ThermalProfile profile, std::vector<TimedFrame> frames)
        : m_name(std::move(name)), m_profile(std::move(profile)), m_frames(std::move(frames)) {}

    Result<CaughtThermalFrame> next() override {
        const std::size_t now = std::exchange(m_next, (m_next + 1) % m_frames.size());
        m_period_s = m_next > now ? m_frames[m_next].time_s - m_frames[now].time_s : kAgain_s;
        return caughtNow(m_name, readFrame(m_frames[now].path, m_profile));
    }
    double period_s() const override { return m_period_s; }

private:
    static constexpr double kAgain_s = 0.5; // from the last frame to the first one

    std::string m_name;
    ThermalProfile m_profile;
    std::vector<TimedFrame> m_frames;
    std::size_t m_next = 0;
    double m_period_s = kAgain_s;
};

class LiveFrames final : public ThermalFrameSource {
public:
    LiveFrames(std::string name, ThermalProfile profile)
        : m_name(std::move(name)), m_profile(std::move(profile)) {}

    Result<void> open() {
        if (!m_capture->open(cameraDevice(m_name), cv::CAP_V4L2, {}))
            return captureRefusal(m_name, "no camera answers there");
        // The numbers themselves, not a picture made of them; another format might have as many bytes.
        m_capture->set(cv::CAP_PROP_CONVERT_RGB, 0);
        const int fourcc = fourCharacterCode(m_profile.pixelFormat);
        const int rows = m_profile.skipTop + m_profile.height + m_profile.skipBottom;
        m_capture->set(cv::CAP_PROP_FOURCC, fourcc);
        m_capture->set(cv::CAP_PROP_FRAME_WIDTH, m_profile.width);
        m_capture->set(cv::CAP_PROP_FRAME_HEIGHT, rows);
        const int given = static_cast<int>(m_capture->get(cv::CAP_PROP_FRAME_HEIGHT));
        if (static_cast<int>(m_capture->get(cv::CAP_PROP_FOURCC)) != fourcc ||
            static_cast<int>(m_capture->get(cv::CAP_PROP_FRAME_WIDTH)) != m_profile.width ||
            (given != rows && given != rows + m_profile.optionalBottom))
            return captureRefusal(m_name, "it gives no frames of \"" + m_profile.name + "\"");
        if (const auto first = next(); !first)
            return first.error();
        return {};
    }

    Result<CaughtThermalFrame> next() override {
        cv::Mat image;
        if (!m_capture->read(image) || image.empty())
            return captureRefusal(m_name, "it has ended");
        if (!image.isContinuous())
            image = image.clone();
        const std::string_view bytes(reinterpret_cast<const char*>(image.data),
                                     image.total() * image.elemSize());
        return caughtNow(m_name, frameOfBytes(bytes, m_profile, m_name));
    }

private:
    std::string m_name;
    ThermalProfile m_profile;
    std::unique_ptr<VideoInput> m_capture = makeVideoInput();
};

FramesOpened openLive(const std::string& name, const ThermalProfile& profile) {
    auto source = std::make_unique<LiveFrames>(name, profile);
    if (auto opened = source->open(); !opened)
        return opened.error();
    return FramesOpened(std::move(source));
}

FramesOpened openRecorded(const std::string& name, const ThermalProfile& profile, bool isFolder) {
    std::vector<TimedFrame> frames{{name, 0.0}};
    if (isFolder) {
        auto listed = framesOfFolder(name, profile);
        if (!listed)
            return captureRefusal(name, describe(listed.error()));
        frames = std::move(*listed);
    }
    if (auto first = readFrame(frames.front().path, profile); !first)
        return captureRefusal(name, describe(first.error()));
    return FramesOpened(std::make_unique<RecordedFrames>(name, profile, std::move(frames)));
}

} // namespace

bool isSamePicture(const CaughtThermalFrame& a, const CaughtThermalFrame& b) {
    return a.frame.picture == b.frame.picture;
}

FramesOpened openThermalFrames(const std::string& name, const ThermalProfile& profile) {
    namespace fs = std::filesystem;
    if (name.empty())
        return captureRefusal(name, "no camera is named");
    std::error_code problem;
    const fs::file_type type = fs::status(name, problem).type();
    try {
        if (isCameraNumber(name) || type == fs::file_type::character)
            return openLive(name, profile);
        if (type == fs::file_type::directory || type == fs::file_type::regular)
            return openRecorded(name, profile, type == fs::file_type::directory);
    } catch (const std::exception& failure) {
        return captureRefusal(name, failure.what());
    }
    return captureRefusal(name, "there is no such file or device");
}

} // namespace bask
