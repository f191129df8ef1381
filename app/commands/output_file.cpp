#include "app/commands/output_file.h"

#include "engine/base/message_code.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code failed;
    if (fs::equivalent(a, b, failed) && !failed)
        return true;
    const fs::path first = fs::weakly_canonical(fs::absolute(a, failed), failed);
    if (failed)
        return false;
    const fs::path second = fs::weakly_canonical(fs::absolute(b, failed), failed);
    return !failed && first == second;
}

/// Does the file begin with "{" and this key, with any blanks between?
bool beginsWithKey(std::istream& in, const std::string& key) {
    for (const char expected : "{\"" + key + '"') {
        char found = 0;
        const bool isPart = expected != '{' && expected != '"';
        if (!(isPart ? in.get(found) : in >> found) || found != expected)
            return false;
    }
    return true;
}

Result<void> checkReplaced(const OutputFile& output) {
    std::error_code failed;
    if (::access(output.path.c_str(), W_OK) != 0)
        return Error(MessageCode::FileUnwritable, output.path, {"it is write-protected"});
    if (output.firstKey.empty() || (fs::file_size(output.path, failed) == 0 && !failed))
        return {};
    std::ifstream in(output.path, std::ios::binary);
    if (!in || !beginsWithKey(in, output.firstKey))
        return Error(MessageCode::OutputForeign, output.path, {output.kind});
    return {};
}

Result<void> checkPlace(const OutputFile& output) {
    if (output.path.empty())
        return Error(MessageCode::FileUnwritable, "\"\"", {"the name is empty"});
    std::error_code failed;
    const fs::path path(output.path);
    const fs::file_status status = fs::status(path, failed);
    if (status.type() == fs::file_type::none || status.type() == fs::file_type::unknown)
        return Error(MessageCode::FileUnwritable, output.path, {failed.message()});
    const bool isThere = fs::exists(status);
    // A link that leads nowhere is no place for a file either.
    if (isThere ? !fs::is_regular_file(status) : fs::is_symlink(fs::symlink_status(path, failed)))
        return Error(MessageCode::OutputNotAFile, output.path);
    const std::string folder = path.has_parent_path() ? path.parent_path().string() : ".";
    if (!fs::is_directory(folder, failed))
        return Error(MessageCode::FileUnwritable, output.path, {"there is no folder " + folder});
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return Error(MessageCode::FileUnwritable, output.path, {"its folder is write-protected"});
    return isThere ? checkReplaced(output) : Result<void>();
}

} // namespace

Result<void> checkOutputs(const std::vector<std::string>& inputs, const std::vector<OutputFile>& outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const std::string& path = outputs[i].path;
        const auto isThis = [&](const std::string& other) { return isSameFile(path, other); };
        if (std::ranges::any_of(inputs, isThis))
            return Error(MessageCode::OutputIsInput, path);
        // Standard output may be sent to a file: putting another in its place would lose the figures.
        if (isThis("/dev/stdout") || isThis("/dev/stderr"))
            return Error(MessageCode::OutputTwice, path);
        for (std::size_t k = 0; k < i; ++k)
            if (isThis(outputs[k].path))
                return Error(MessageCode::OutputTwice, path);
        if (auto place = checkPlace(outputs[i]); !place)
            return place;
    }
    return {};
}

} // namespace bask
