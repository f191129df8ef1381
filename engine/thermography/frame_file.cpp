#include "engine/thermography/frame_file.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/shape/contour_file.h"
#include "engine/shape/csv_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
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
        bytes.starts_with(std::string_view("MM\0*", 4)))
        return FrameFormat::Image;
    // The numbers of an even picture can all be letters.
    if (profile && profile->isFrameSize(bytes.size()))
        return FrameFormat::CameraBytes;
    return checkCsvText(bytes, path) ? FrameFormat::Csv : FrameFormat::CameraBytes;
}

Result<ThermalFrame> readFrame(const std::string& path, const std::optional<ThermalProfile>& profile) {
    const auto bytes = readFileBytes(path, kLargestFrame);
    if (!bytes)
        return bytes.error();
    const FrameFormat format = frameFormat(path, *bytes, profile);
    if (format == FrameFormat::Csv)
        return frameOfCsv(*bytes, profile, path);
    if (!profile)
        return Error{MessageCode::ThermalProfileNeeded, path};
    return format == FrameFormat::Image ? frameOfImage(*bytes, *profile, path)
                                        : frameOfBytes(*bytes, *profile, path);
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
        return Error{MessageCode::FileTooLarge,
                     folder,
                     {std::to_string(names.size()) + " frames", std::to_string(kMaxFrames)}};
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
