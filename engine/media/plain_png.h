#pragma once
// The commonest picture of an outline without OpenCV's codecs, whose 230 libraries take 0.2 s to load.

namespace cv {
class Mat;
}

namespace bask {

/// Returns the picture as cv::imdecode() with IMREAD_UNCHANGED gives it, if `bytes` (one row, 8 bits) are a
/// whole PNG of 8 bits that is grey, RGB or RGBA, without interlace or transparent colour, of at most 64
/// megapixels; else an empty one.
cv::Mat decodePlainPng(const cv::Mat& bytes);

} // namespace bask
