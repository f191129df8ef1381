#pragma once
// Pictures drawn for the tests of engine/shape.

#include "tests/engine/shape/shape_samples.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

namespace bask::test {

inline std::string encoded(const cv::Mat& image, const char* ending = ".png") {
    std::vector<unsigned char> bytes;
    cv::imencode(ending, image, bytes);
    return {bytes.begin(), bytes.end()};
}

inline std::string picture(const cv::Mat& image, const char* ending = ".png") {
    return writeFile(ending, encoded(image, ending));
}

/// A picture of a scene, every pixel the mean of n x n samples of `colour(x, y)` (BGR, 0 to 1) in pixels, y
/// down, the upper left pixel reaching from 0 to 1.
template <class Colour> cv::Mat3b rendered(cv::Size size, int n, const Colour& colour) {
    cv::Mat3b image(size);
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            cv::Vec3d sum(0.0, 0.0, 0.0);
            for (int k = 0; k < n * n; ++k)
                sum += colour(x + (k % n + 0.5) / n, y + (k / n + 0.5) / n);
            image(y, x) = cv::Vec3b(sum * (255.0 / (n * n)));
        }
    return image;
}

/// ArUco marker 0 of 4X4_50 on (0,1) x (0,1), y up: is it black there?
inline bool isMarkerBlack(double x, double y) {
    static constexpr const char* kRows[] = {"1011", "0101", "0011", "0010"};
    const int column = static_cast<int>(std::floor(6 * x)) - 1,
              row = static_cast<int>(std::floor(6 * (1 - y))) - 1;
    return column < 0 || column > 3 || row < 0 || row > 3 || kRows[row][column] == '0';
}

} // namespace bask::test
