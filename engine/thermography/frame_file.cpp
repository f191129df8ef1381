#include "engine/thermography/frame_file.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/csv_lines.h"
#include "engine/shape/image_header.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kLargestFrame = std::uintmax_t{64} << 20;
constexpr std::size_t kMaxFrames = 1'000'000;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

constexpr std::array<std::pair<const char*, FrameFormat>, 10> kFrameEndings{
    {{".raw", FrameFormat::CameraBytes},
     {".bin", FrameFormat::CameraBytes},
     {".y16", FrameFormat::CameraBytes},
     {".yuyv", FrameFormat::CameraBytes},
     {".png", FrameFormat::Image},
     {".tif", FrameFormat::Image},
     {".tiff", FrameFormat::Image},
     {".csv", FrameFormat::Csv},
     {".txt", FrameFormat::Csv},
     {".tsv", FrameFormat::Csv}}};

std::optional<FrameFormat> formatOfEnding(const fs::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c; });
    for (const auto& [known, format] : kFrameEndings)
        if (ending == known)
            return format;
    return std::nullopt;
}

std::string frameEndings() {
    std::string out;
    for (const auto& [ending, unused] : kFrameEndings)
        out += (out.empty() ? "" : " ") + std::string(ending);
    return out;
}

Error tooManyFrames(const std::string& where, std::size_t count) {
    return {
        MessageCode::FileTooLarge, where, {std::to_string(count) + " frames", std::to_string(kMaxFrames)}};
}

Error noFrame(const std::string& where, std::size_t number, std::size_t count) {
    return {MessageCode::ThermalFrameNone, where, {std::to_string(number + 1), std::to_string(count)}};
}

/// Of a file whose ending says that it holds the camera's bytes; such a file need not be read as a whole.
std::optional<std::uintmax_t> sizeOfCameraBytes(const std::string& path) {
    std::error_code failed;
    if (formatOfEnding(path) != FrameFormat::CameraBytes || !fs::is_regular_file(path, failed))
        return std::nullopt;
    const std::uintmax_t size = fs::file_size(path, failed);
    return failed ? std::nullopt : std::optional(size);
}

Result<ThermalFrame> readCameraBytes(const std::string& path, std::uintmax_t size,
                                     const ThermalProfile& profile, std::size_t number) {
    const auto frames = framesOfBytes(size, profile, path);
    if (!frames)
        return frames.error();
    if (number >= frames->count)
        return noFrame(path, number, frames->count);
    std::ifstream file(path, std::ios::binary);
    std::string bytes(frames->frameBytes, '\0');
    file.seekg(static_cast<std::streamoff>(number) * static_cast<std::streamoff>(frames->frameBytes));
    if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())))
        return Error{MessageCode::FileUnreadable, path, {std::strerror(errno)}};
    return frameOfBytes(bytes, profile, path);
}

/// Names in the order of people: frame 2 before frame 10.
bool comesBefore(const std::string& a, const std::string& b) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, k = 0;
    const auto number = [&](const std::string& text, std::size_t& at) {
        while (at < text.size() && text[at] == '0')
            ++at;
        const std::size_t first = at;
        while (at < text.size() && isDigit(text[at]))
            ++at;
        return std::string_view(text).substr(first, at - first);
    };
    while (i < a.size() && k < b.size()) {
        if (isDigit(a[i]) && isDigit(b[k])) {
            const std::string_view left = number(a, i), right = number(b, k);
            if (left != right)
                return left.size() != right.size() ? left.size() < right.size() : left < right;
        } else if (a[i] != b[k]) {
            return a[i] < b[k];
        } else {
            ++i;
            ++k;
        }
    }
    return a.size() - i != b.size() - k ? a.size() - i < b.size() - k : a < b;
}

Result<std::vector<TimedFrame>> framesOfTimes(const fs::path& folder) {
    const std::string path = (folder / kFrameTimesFile).string();
    const auto text = readFileBytes(path, kLargestFrame);
    if (!text)
        return text.error();
    if (const auto checked = checkCsvText(*text, path); !checked)
        return checked.error();
    const std::vector<CsvLine> lines = csvLines(*text);
    const char delimiter = csvDelimiter(lines);
    const auto refused = [&](const CsvLine& line) {
        return Error{MessageCode::ThermalTimesLine,
                     path,
                     {std::to_string(line.number), plainWords(std::string(line.text.substr(0, 60)))}};
    };
    std::vector<TimedFrame> out;
    for (std::size_t k = 0; k < lines.size(); ++k) {
        const auto fields = csvFields(lines[k].text, delimiter);
        if (k == 0) {
            if (fields.size() != 2 || fields[0] != "file" || fields[1] != "time_s")
                return refused(lines[k]);
            continue;
        }
        const double time_s =
            fields.size() == 2 ? csvNumber(fields[1], delimiter != ',').value_or(kNoNumber) : kNoNumber;
        const std::string name(fields[0]);
        // Names of this folder only: a recording that is passed on shall not read other files.
        const bool isName =
            !name.empty() && name.find('/') == std::string::npos && name != "." && name != "..";
        std::error_code failed;
        if (!isName || !std::isfinite(time_s) || (!out.empty() && time_s <= out.back().time_s) ||
            !fs::is_regular_file(folder / name, failed))
            return refused(lines[k]);
        out.push_back({(folder / name).string(), time_s});
    }
    if (out.empty())
        return Error{MessageCode::ThermalNoFrames, path, {frameEndings()}};
    const double first_s = out.front().time_s;
    for (TimedFrame& frame : out)
        frame.time_s -= first_s;
    return out;
}

} // namespace

FrameFormat frameFormat(const std::string& path, std::string_view bytes,
                        const std::optional<ThermalProfile>& profile) {
    if (const auto format = formatOfEnding(path))
        return *format;
    if (bytes.starts_with("\x89PNG") || bytes.starts_with(std::string_view("II*\0", 4)) ||
        bytes.starts_with(std::string_view("MM\0*", 4)) || isBigTiff(bytes))
        return FrameFormat::Image;
    // The numbers of an even picture can all be letters.
    if (profile && profile->isFrameSize(bytes.size()))
        return FrameFormat::CameraBytes;
    return checkCsvText(bytes, path) ? FrameFormat::Csv : FrameFormat::CameraBytes;
}

Result<std::size_t> frameCount(const std::string& path, const std::optional<ThermalProfile>& profile) {
    if (const auto size = sizeOfCameraBytes(path); size && profile) {
        const auto frames = framesOfBytes(*size, *profile, path);
        return frames ? Result<std::size_t>(frames->count) : frames.error();
    }
    const auto bytes = readFileBytes(path, kLargestFrame);
    if (!bytes)
        return bytes.error();
    const FrameFormat format = frameFormat(path, *bytes, profile);
    if (format == FrameFormat::Image)
        return picturesOfImage(*bytes, path);
    if (format == FrameFormat::Csv)
        return std::size_t{1};
    if (!profile)
        return Error{MessageCode::ThermalProfileNeeded, path};
    const auto frames = framesOfBytes(bytes->size(), *profile, path);
    return frames ? Result<std::size_t>(frames->count) : frames.error();
}

Result<ThermalFrame> readFrame(const std::string& path, const std::optional<ThermalProfile>& profile,
                               std::optional<std::size_t> number) {
    if (const auto size = sizeOfCameraBytes(path); size && profile && number)
        return readCameraBytes(path, *size, *profile, *number);
    const auto bytes = readFileBytes(path, kLargestFrame);
    if (!bytes)
        return bytes.error();
    const FrameFormat format = frameFormat(path, *bytes, profile);
    if (format == FrameFormat::Csv)
        return number.value_or(0) == 0 ? frameOfCsv(*bytes, profile, path) : noFrame(path, *number, 1);
    if (!profile)
        return Error{MessageCode::ThermalProfileNeeded, path};
    if (format == FrameFormat::Image)
        return frameOfImage(*bytes, *profile, path, number);
    return number ? readCameraBytes(path, bytes->size(), *profile, *number)
                  : frameOfBytes(*bytes, *profile, path);
}

Result<std::vector<TimedFrame>> framesOfFile(const std::string& path,
                                             const std::optional<ThermalProfile>& profile) {
    const auto count = frameCount(path, profile);
    if (!count)
        return count.error();
    if (*count == 1)
        return std::vector<TimedFrame>{{path, 0.0}};
    if (*count > kMaxFrames)
        return tooManyFrames(path, *count);
    if (!profile || !profile->frameRate_Hz)
        return Error{MessageCode::ThermalTimesNeeded, path, {kFrameTimesFile}};
    std::vector<TimedFrame> out;
    out.reserve(*count);
    for (std::size_t k = 0; k < *count; ++k)
        out.push_back({path, static_cast<double>(k) / *profile->frameRate_Hz, k});
    return out;
}

Result<std::vector<TimedFrame>> framesOfFolder(const std::string& folder,
                                               const std::optional<ThermalProfile>& profile) {
    std::error_code failed;
    if (!fs::exists(folder, failed))
        return Error{MessageCode::FileNotFound, folder};
    if (fs::exists(fs::path(folder) / kFrameTimesFile, failed))
        return framesOfTimes(folder);
    std::vector<std::string> names;
    for (fs::directory_iterator it(folder, failed), end; !failed && it != end; it.increment(failed))
        if (std::error_code other; it->is_regular_file(other) && formatOfEnding(it->path()))
            names.push_back(it->path().filename().string());
    if (failed)
        return Error{MessageCode::FileUnreadable, folder, {failed.message()}};
    if (names.empty())
        return Error{MessageCode::ThermalNoFrames, folder, {frameEndings()}};
    if (names.size() > kMaxFrames)
        return tooManyFrames(folder, names.size());
    if (!profile || !profile->frameRate_Hz)
        return Error{MessageCode::ThermalTimesNeeded, folder, {kFrameTimesFile}};
    std::ranges::sort(names, comesBefore);
    std::vector<TimedFrame> out;
    out.reserve(names.size());
    for (const std::string& name : names)
        out.push_back(
            {(fs::path(folder) / name).string(), static_cast<double>(out.size()) / *profile->frameRate_Hz});
    return out;
}

} // namespace bask
