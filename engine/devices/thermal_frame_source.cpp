#include "engine/devices/thermal_frame_source.h"

#include "engine/base/clock.h"
#include "engine/devices/frame_source.h"
#include "engine/media/media.h"
#include "engine/thermography/frame_file.h"

#include <opencv2/videoio.hpp>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

namespace bask {
namespace {

using FramesOpened = Result<std::unique_ptr<ThermalFrameSource>>;

Result<CaughtThermalFrame> caughtNow(Result<ThermalFrame> frame) {
    if (!frame)
        return frame.error();
    return CaughtThermalFrame{std::move(*frame), SteadyClock().now_s()};
}

class RecordedFrames final : public ThermalFrameSource {
public:
    RecordedFrames(std::string name, ThermalProfile profile, std::vector<TimedFrame> frames)
        : m_name(std::move(name)), m_profile(std::move(profile)), m_frames(std::move(frames)) {}

    Result<CaughtThermalFrame> next() override {
        const std::size_t now = std::exchange(m_next, (m_next + 1) % m_frames.size());
        m_period_s = m_next > now ? m_frames[m_next].time_s - m_frames[now].time_s : kAgain_s;
        auto caught = caughtNow(frameAt(now));
        m_bad = caught ? 0 : m_bad + 1;
        if (m_bad >= m_frames.size())
            return captureRefusal(m_name, describe(caught.error()));
        return caught;
    }
    double period_s() const override { return m_period_s; }

    /// Refuses a recording that begins with many frames that cannot be used, with what is wrong with the
    /// first one: its profile, as a rule.
    Result<void> check() const {
        constexpr std::size_t kTried = 100;
        std::optional<Error> first;
        for (std::size_t k = 0; k < std::min(kTried, m_frames.size()); ++k) {
            const auto frame = frameAt(k);
            if (frame)
                return {};
            if (!first)
                first = frame.error();
        }
        return captureRefusal(m_name, describe(*first));
    }

private:
    Result<ThermalFrame> frameAt(std::size_t index) const {
        return readFrame(m_frames[index].path, m_profile, m_frames[index].number);
    }

    static constexpr double kAgain_s = 0.5; // from the last frame to the first one

    std::string m_name;
    ThermalProfile m_profile;
    std::vector<TimedFrame> m_frames;
    std::size_t m_next = 0;
    std::size_t m_bad = 0; ///< one after another; a whole round of them is an end
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
        return awaitFrame();
    }

    Result<CaughtThermalFrame> next() override {
        cv::Mat image;
        if (!m_capture->read(image) || image.empty())
            return captureRefusal(m_name, "it has ended");
        if (!image.isContinuous())
            image = image.clone();
        const std::string_view bytes(reinterpret_cast<const char*>(image.data),
                                     image.total() * image.elemSize());
        return caughtNow(frameOfBytes(bytes, m_profile, m_name));
    }

private:
    /// A camera that has just been opened closes its shutter, or sends pictures of nothing.
    Result<void> awaitFrame() {
        constexpr double kAwaited_s = 1.0;
        const SteadyClock clock;
        const double begun_s = clock.now_s();
        for (;;) {
            const auto frame = next();
            if (frame)
                return {};
            if (frame.error().code() == MessageCode::CameraNotOpened)
                return frame.error();
            if (clock.now_s() - begun_s > kAwaited_s)
                return captureRefusal(m_name, describe(frame.error()));
        }
    }

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
    auto frames = isFolder ? framesOfFolder(name, profile) : framesOfFile(name, profile);
    if (!frames)
        return captureRefusal(name, describe(frames.error()));
    auto source = std::make_unique<RecordedFrames>(name, profile, std::move(*frames));
    if (const auto checked = source->check(); !checked)
        return checked.error();
    return FramesOpened(std::move(source));
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
