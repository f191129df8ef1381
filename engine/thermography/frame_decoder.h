#pragma once
// The bytes of one frame, as a thermal camera sends them or as they were recorded, as temperatures. Nothing
// is guessed: a size, a format or a value that does not fit is an error.

#include "engine/base/message.h"
#include "engine/base/result.h"
#include "engine/thermography/camera_profile.h"
#include "engine/thermography/thermal_picture.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace bask {

/// A decoded frame with what a person should know of it.
struct ThermalFrame {
    ThermalPicture picture;
    std::vector<Message> warnings; ///< ThermalHighRange, ThermalPlainDoubt
};

/// Frames of the camera's bytes, one after another.
struct FramesOfBytes {
    std::size_t count = 0, frameBytes = 0;
};
/// Divides a number of bytes into frames. Errors: FileEmpty; ThermalFrameSize if they are no whole frames;
/// ThermalFramesEither if they can be frames with and without the rows that are optional.
Result<FramesOfBytes> framesOfBytes(std::uint64_t bytes, const ThermalProfile& profile,
                                    const std::string& where);

/// Decodes one frame of the camera's own bytes, 16 bits a pixel. `where` names it in errors, here and below.
/// Errors: those of framesOfBytes; ThermalFramesSeveral; ThermalBitsOver for a number that does not fit into
/// the profile's bits; ThermalPictureConstant; ThermalPlainPicture if the rows of temperatures of a YUYV
/// camera hold a picture for people; ThermalNotTemperatures if more than half of the pixels lie outside of
/// what the camera can tell. Single pixels outside are infinite.
Result<ThermalFrame> frameOfBytes(std::string_view bytes, const ThermalProfile& profile,
                                  const std::string& where);

/// Decodes a recorded frame: a PNG or TIFF with one channel of 16 bits that holds the camera's numbers,
/// either the rows with temperatures alone or a whole frame. `picture` is counted from 0; without it the file
/// holds one. Errors: ImageUnreadable (damaged, short, or neither), ThermalBigTiff, ThermalPictureKind
/// (colours, 8 bits, a palette), ThermalPictureSeveral, ThermalFrameNone if there is no such picture,
/// ThermalPictureSize, and those of frameOfBytes for the numbers.
Result<ThermalFrame> frameOfImage(std::string_view bytes, const ThermalProfile& profile,
                                  const std::string& where, std::optional<std::size_t> picture = {});
/// Returns how many pictures a PNG or TIFF holds. Errors: ImageUnreadable, ThermalBigTiff.
Result<std::size_t> picturesOfImage(std::string_view bytes, const std::string& where);

/// Decodes a table of temperatures in degC, as camera programs export it: one line a row of pixels, separated
/// by semicolons, tabs, commas or blanks; a decimal comma, where commas separate only within quotes. Accepted
/// besides: lines before the table with another number of values, or with no number (but a line as wide as
/// the table directly above it only if it names columns, or by the profile's height); a first line and a
/// first column that count 0, 1, 2 ... or 1, 2, 3 ... (with a profile where the size is one too many; without
/// one both together, with a corner that is no number); a byte order mark, quotes, a separator at a line's
/// end, lines that begin with #. With a profile the size has to be its, and values outside of what it can
/// tell are infinite. Errors: ThermalCellUnusable for a value that is none (words, NaN, nothing, not above
/// absolute zero, above 2726.85 degC, "1,234" between commas), ThermalRowLength, ThermalNoTable,
/// ThermalLineCounts and ThermalColumnCounts for a line or a column that counts where no profile tells what
/// it is, ThermalPictureSize, and as above.
Result<ThermalFrame> frameOfCsv(std::string_view text, const std::optional<ThermalProfile>& profile,
                                const std::string& where);

/// A picture of the camera's numbers before they are temperatures, row by row.
struct CountPicture {
    int width = 0, height = 0;
    std::vector<unsigned short> counts;
    std::vector<unsigned short> above{}; ///< of the rows above, if they are known: no temperatures
};
/// Makes temperatures of numbers, with the checks of frameOfBytes. The picture has the profile's size.
Result<ThermalFrame> frameOfCounts(const CountPicture& counts, const ThermalProfile& profile,
                                   const std::string& where);
/// Checks and finishes a picture of temperatures: outside of what the profile tells they become infinite.
Result<ThermalFrame> frameOfTemperatures(ThermalPicture picture, const std::optional<ThermalProfile>& profile,
                                         const std::string& where);

} // namespace bask
