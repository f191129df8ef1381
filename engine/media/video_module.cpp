// bask-video.so: see media.h.

#include "engine/media/media.h"

#include <opencv2/videoio.hpp>

namespace bask {
namespace {

class OpenCvVideo final : public VideoInput {
public:
    bool open(const std::string& name, int api, const std::vector<int>& options) override {
        return m_capture.open(name, api, options);
    }
    bool set(int property, double value) override { return m_capture.set(property, value); }
    double get(int property) const override { return m_capture.get(property); }
    bool read(cv::Mat& image) override { return m_capture.read(image); }

private:
    cv::VideoCapture m_capture;
};

} // namespace
} // namespace bask

extern "C" bask::VideoInput* baskMakeVideoInput() {
    return new bask::OpenCvVideo;
}
