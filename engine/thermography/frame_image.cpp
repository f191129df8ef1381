#include "engine/base/message_code.h"
#include "engine/calibration/camera_model.h"
#include "engine/media/media.h"
#include "engine/shape/image_header.h"
#include "engine/thermography/frame_picture_file.h"

#include <opencv2/imgcodecs.hpp>

#include <algorithm>
#include <exception>

namespace bask {
namespace {

std::string kindOf(const PictureHeader& header) {
    if (header.channels == 0)
        return "colours of a palette";
    return std::to_string(header.channels) + " x " + std::to_string(header.bits) + " bit" +
           (header.isWhole ? "" : ", not whole numbers");
}

Error unreadable(std::string_view bytes, const std::string& where) {
    return {isBigTiff(bytes) ? MessageCode::ThermalBigTiff : MessageCode::ImageUnreadable, where};
}

/// Checks the header, before anything is unpacked. Returns the number of rows above the temperatures.
Result<int> rowsAbove(const std::optional<PictureHeader>& header, const ThermalProfile& profile,
                      const std::string& where) {
    if (!header)
        return Error{MessageCode::ImageUnreadable, where};
    if (header->channels != 1 || header->bits != 16 || !header->isWhole)
        return Error{MessageCode::ThermalPictureKind, where, {kindOf(*header)}};
    const auto rows = static_cast<std::uint64_t>(profile.height);
    const auto around =
        static_cast<std::uint64_t>(profile.skipTop) + static_cast<std::uint64_t>(profile.skipBottom);
    const auto more = static_cast<std::uint64_t>(profile.optionalBottom);
    const std::uint64_t found = header->height;
    const bool isHeight = found == rows || found == rows + around || found == rows + around + more;
    if (header->width == static_cast<std::uint64_t>(profile.width) && isHeight) {
        if (!header->isComplete) // OpenCV would complain on the terminal
            return Error{MessageCode::ImageUnreadable, where};
        return found == rows ? 0 : profile.skipTop;
    }
    return Error{MessageCode::ThermalPictureSize,
                 where,
                 {profile.name, pixelsText(profile.width, profile.height),
                  std::to_string(header->width) + " x " + std::to_string(header->height)}};
}

} // namespace

Result<std::size_t> picturesOfImage(std::string_view bytes, const std::string& where) {
    if (bytes.empty())
        return Error{MessageCode::FileEmpty, where};
    const auto header = pictureHeader(bytes);
    if (!header)
        return unreadable(bytes, where);
    return header->pictures;
}

Result<CountPicture> countsOfImage(std::string_view bytes, const ThermalProfile& profile,
                                   const std::string& where, std::optional<std::size_t> picture) {
    const auto pictures = picturesOfImage(bytes, where);
    if (!pictures)
        return pictures.error();
    if (*pictures != 1 && !picture)
        return Error{MessageCode::ThermalPictureSeveral, where, {std::to_string(*pictures)}};
    if (picture && *picture >= *pictures)
        return Error{
            MessageCode::ThermalFrameNone, where, {std::to_string(*picture + 1), std::to_string(*pictures)}};
    const auto header = pictureHeader(bytes, picture.value_or(0));
    const auto above = rowsAbove(header, profile, where);
    if (!above)
        return above.error();
    if (picture.value_or(0) > 0) // OpenCV decodes the first one
        return countsOfImage(tiffFrom(bytes, header->at), profile, where, 0);
    try {
        const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U, const_cast<char*>(bytes.data()));
        const cv::Mat image = pictureCodecs().decode(raw, cv::IMREAD_UNCHANGED);
        if (image.type() != CV_16UC1 || image.cols != profile.width || image.rows < *above + profile.height)
            return Error{MessageCode::ImageUnreadable, where};
        CountPicture counts{profile.width, profile.height, {}};
        for (int row = 0; row < *above + profile.height; ++row) {
            auto& rows = row < *above ? counts.above : counts.counts;
            const auto* first = image.ptr<unsigned short>(row);
            rows.insert(rows.end(), first, first + profile.width);
        }
        return counts;
    } catch (const std::exception&) {
        return Error{MessageCode::ImageUnreadable, where};
    }
}

Result<ThermalFrame> frameOfImage(std::string_view bytes, const ThermalProfile& profile,
                                  const std::string& where, std::optional<std::size_t> picture) {
    const auto counts = countsOfImage(bytes, profile, where, picture);
    return counts ? frameOfCounts(*counts, profile, where) : counts.error();
}

} // namespace bask
