// bask-pictures.so: see media.h.

#include "engine/media/media.h"

#include <opencv2/imgcodecs.hpp>

namespace bask {
namespace {

class OpenCvCodecs final : public PictureCodecs {
public:
    cv::Mat decode(const cv::Mat& bytes, int flags) const override { return cv::imdecode(bytes, flags); }
    bool encode(const std::string& ending, const cv::Mat& image, std::vector<unsigned char>& bytes,
                const std::vector<int>& options) const override {
        return cv::imencode(ending, image, bytes, options);
    }
};

} // namespace
} // namespace bask

extern "C" const bask::PictureCodecs* baskPictureCodecs() {
    static const bask::OpenCvCodecs kCodecs;
    return &kCodecs;
}
