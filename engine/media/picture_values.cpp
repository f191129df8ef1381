#include "engine/media/media.h"

#include <opencv2/core.hpp>

namespace bask {
namespace {

template <class T> std::vector<T> valuesOf(const cv::Mat_<T>& picture) {
    std::vector<T> values;
    values.reserve(picture.total());
    for (int y = 0; y < picture.rows; ++y)
        values.insert(values.end(), picture[y], picture[y] + picture.cols);
    return values;
}

} // namespace

std::vector<std::uint8_t> bytesOf(const cv::Mat& picture) {
    return valuesOf<std::uint8_t>(picture);
}

std::vector<float> floatsOf(const cv::Mat& picture) {
    return valuesOf<float>(picture);
}

} // namespace bask
