#pragma once
// Files with frames of a thermal camera: one frame, or a folder of them with their times.

#include "engine/thermography/frame_decoder.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace bask {

/// How a frame is stored.
enum class FrameFormat { CameraBytes, Image, Csv };

/// Returns the format of a file: by its ending (.raw .bin .y16 .yuyv; .png .tif .tiff; .csv .txt .tsv, in any
/// case). For another ending: an image by its first bytes, the camera's bytes if there are as many as the
/// profile's frames have, a table if all of it is text, else the camera's bytes.
FrameFormat frameFormat(const std::string& path, std::string_view bytes,
                        const std::optional<ThermalProfile>& profile);

/// Returns how many frames a file holds: whole frames of the camera's bytes one after another, pictures of a
/// TIFF; a PNG and a table hold one. Errors: those of a file, of framesOfBytes and picturesOfImage, and
/// ThermalProfileNeeded for the camera's bytes without a profile.
Result<std::size_t> frameCount(const std::string& path, const std::optional<ThermalProfile>& profile);

/// Reads one frame: the one with this number, counted from 0, or without a number that of a file that holds
/// one. A file may have 64 MiB, the camera's bytes more. Errors: those of a file, of the decoders
/// (frame_decoder.h), ThermalFrameNone, and ThermalProfileNeeded if there is no profile and the file is no
/// CSV.
Result<ThermalFrame> readFrame(const std::string& path, const std::optional<ThermalProfile>& profile,
                               std::optional<std::size_t> number = {});

/// A frame of a recording.
struct TimedFrame {
    std::string path;
    double time_s = 0.0;                 ///< since the first frame
    std::optional<std::size_t> number{}; ///< in a file of several, counted from 0
    bool operator==(const TimedFrame&) const = default;
};

/// Lists the frames of a file, at most a million, at the profile's frame rate. Errors: those of frameCount;
/// ThermalTimesNeeded if there are several and the profile has no frame rate.
Result<std::vector<TimedFrame>> framesOfFile(const std::string& path,
                                             const std::optional<ThermalProfile>& profile);

/// The file with the times in a folder of frames: the line "file,time_s", then one line a frame with growing
/// times; comma or semicolon.
inline constexpr const char* kFrameTimesFile = "times.csv";

/// Lists the frames of a folder, at most a million. With times.csv these are the files that it names; without
/// it all files with an ending of frameFormat, in the order of their names (numbers in them by their value),
/// at the profile's frame rate. Errors: FileNotFound, FileUnreadable; ThermalNoFrames; ThermalTimesNeeded
/// without either; ThermalTimesLine for a line of times.csv that cannot be used.
Result<std::vector<TimedFrame>> framesOfFolder(const std::string& folder,
                                               const std::optional<ThermalProfile>& profile);

} // namespace bask
