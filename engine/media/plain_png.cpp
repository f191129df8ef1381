#include "engine/media/media.h"

#include <opencv2/core.hpp>

#include <png.h>

#include <csetjmp>
#include <cstring>

namespace bask {
namespace {

constexpr std::size_t kMaxPixels = 64'000'000;

struct Bytes {
    const unsigned char* next;
    std::size_t left;
};

void take(png_structp png, png_bytep to, std::size_t count) {
    auto* const bytes = static_cast<Bytes*>(png_get_io_ptr(png));
    if (count > bytes->left)
        png_error(png, "the file ends");
    std::memcpy(to, bytes->next, count);
    bytes->next += count;
    bytes->left -= count;
}

int channelsOf(int colours) {
    switch (colours) {
    case PNG_COLOR_TYPE_GRAY:
        return 1;
    case PNG_COLOR_TYPE_RGB:
        return 3;
    case PNG_COLOR_TYPE_RGB_ALPHA:
        return 4;
    default:
        return 0;
    }
}

/// libpng leaves by a jump where a file is damaged: in these two functions nothing has a destructor.
bool readHeader(png_structp png, png_infop info, int& rows, int& columns, int& channels) {
    if (setjmp(png_jmpbuf(png)) != 0) // NOLINT(cert-err52-cpp)
        return false;
    png_read_info(png, info);
    const auto width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    channels = channelsOf(png_get_color_type(png, info));
    if (channels == 0 || png_get_bit_depth(png, info) != 8 ||
        png_get_interlace_type(png, info) != PNG_INTERLACE_NONE ||
        png_get_valid(png, info, PNG_INFO_tRNS) != 0 || std::size_t{width} * height > kMaxPixels)
        return false;
    rows = static_cast<int>(height);
    columns = static_cast<int>(width);
    png_set_bgr(png);
    return true;
}

bool readRows(png_structp png, png_infop info, unsigned char* const to, const std::size_t stride,
              const int rows) {
    if (setjmp(png_jmpbuf(png)) != 0) // NOLINT(cert-err52-cpp)
        return false;
    png_read_update_info(png, info);
    for (int row = 0; row < rows; ++row)
        png_read_row(png, to + static_cast<std::size_t>(row) * stride, nullptr);
    png_read_end(png, nullptr);
    return true;
}

} // namespace

cv::Mat decodePlainPng(const cv::Mat& bytes) {
    const std::size_t size = bytes.total();
    if (size < 8 || png_sig_cmp(bytes.data, 0, 8) != 0)
        return {};
    png_structp png = png_create_read_struct(
        PNG_LIBPNG_VER_STRING, nullptr, [](png_structp self, png_const_charp) { png_longjmp(self, 1); },
        [](png_structp, png_const_charp) {});
    png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
    cv::Mat image;
    if (info != nullptr) {
        Bytes source{bytes.data, size};
        png_set_read_fn(png, &source, take);
        int rows = 0, columns = 0, channels = 0;
        if (readHeader(png, info, rows, columns, channels)) {
            image.create(rows, columns, CV_8UC(channels));
            if (!readRows(png, info, image.data, image.step[0], rows))
                image.release();
        }
    }
    png_destroy_read_struct(&png, &info, nullptr);
    return image;
}

} // namespace bask
