#include "engine/base/program_part.h"

#include <filesystem>
#include <system_error>
#include <unistd.h>

namespace bask {

std::string programPart(const std::string& name, const std::string& built) {
    namespace fs = std::filesystem;
    std::error_code code;
    const fs::path folder = fs::read_symlink("/proc/self/exe", code).parent_path();
    for (const fs::path& each : {folder, folder.parent_path() / "libexec/bask", fs::path(built)})
        if (const fs::path part = each / name; !each.empty() && ::access(part.c_str(), R_OK) == 0)
            return part.string();
    return {};
}

} // namespace bask
