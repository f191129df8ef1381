#include "engine/shape/contour_file.h"

#include "engine/base/message_code.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace bask {
namespace {

std::string mebibytes(std::uintmax_t bytes) {
    return formatNumber(static_cast<double>(bytes) / (1 << 20), 3) + " MiB";
}

} // namespace

Result<std::string> readFileBytes(const std::string& path, std::uintmax_t limit_bytes) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::file_status status = fs::status(path, code);
    if (status.type() == fs::file_type::not_found)
        return Error{MessageCode::FileNotFound, path};
    if (code)
        return Error{MessageCode::FileUnreadable, path, {code.message()}};
    if (fs::is_directory(status))
        return Error{MessageCode::FileUnreadable, path, {"it is a folder"}};
    if (!fs::is_regular_file(status))
        return Error{MessageCode::FileUnreadable, path, {"it is not an ordinary file"}};
    const std::uintmax_t size = fs::file_size(path, code);
    if (!code && size > limit_bytes)
        return Error{MessageCode::FileTooLarge, path, {mebibytes(size), mebibytes(limit_bytes)}};
    std::ifstream in(path, std::ios::binary);
    if (!in)
        return Error{MessageCode::FileUnreadable, path, {std::strerror(errno)}};
    std::string bytes;
    bytes.reserve(code ? 0 : static_cast<std::size_t>(size));
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    if (in.bad())
        return Error{MessageCode::FileUnreadable, path, {std::strerror(errno)}};
    if (bytes.empty())
        return Error{MessageCode::FileEmpty, path};
    return bytes;
}

std::string_view trimmed(std::string_view text) {
    const auto isBlank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

} // namespace bask
