#pragma once
// OpenCV's codecs of pictures and its cameras, loaded when they are first wanted: with all that they can read
// they bring 230 libraries, which would cost every start of the program 0.3 s and 50 MB.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cv {
class Mat;
}

namespace bask {

class PictureCodecs {
public:
    virtual ~PictureCodecs() = default;
    /// cv::imdecode. Errors: throws cv::Exception.
    virtual cv::Mat decode(const cv::Mat& bytes, int flags) const = 0;
    /// cv::imencode. Errors: throws cv::Exception.
    virtual bool encode(const std::string& ending, const cv::Mat& image, std::vector<unsigned char>& bytes,
                        const std::vector<int>& options) const = 0;
};

/// Without these codecs, for the commonest picture of an outline: returns the picture as cv::imdecode() with
/// IMREAD_UNCHANGED gives it, if `bytes` (one row, 8 bits) are a
/// whole PNG of 8 bits that is grey, RGB or RGBA, without interlace or transparent colour, of at most 64
/// megapixels; else an empty one.
cv::Mat decodePlainPng(const cv::Mat& bytes);

/// Return the values of a picture of one channel row by row; OpenCV's iterators take many times as long.
std::vector<std::uint8_t> bytesOf(const cv::Mat& picture);
std::vector<float> floatsOf(const cv::Mat& picture);

/// A cv::VideoCapture.
class VideoInput {
public:
    virtual ~VideoInput() = default;
    virtual bool open(const std::string& name, int api, const std::vector<int>& options) = 0;
    virtual bool set(int property, double value) = 0;
    virtual double get(int property) const = 0;
    virtual bool read(cv::Mat& image) = 0;
};

/// Any thread. Errors: throws std::runtime_error where this part of the program cannot be loaded, which is
/// also said on standard error.
const PictureCodecs& pictureCodecs();
/// As pictureCodecs().
std::unique_ptr<VideoInput> makeVideoInput();

/// Four letters that name a format of pixels.
int fourCharacterCode(const std::string& letters);

} // namespace bask
