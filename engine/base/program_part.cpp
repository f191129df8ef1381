#include "engine/base/program_part.h"

#include <array>
#include <dlfcn.h>
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

void* moduleFunction(const char* module, const std::string& built, const char* name, std::string& problem) {
    const std::string path = programPart(module, built);
    if (path.empty()) {
        problem = std::string(module) + " is missing";
        return nullptr;
    }
    void* const library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    void* const found = library != nullptr ? ::dlsym(library, name) : nullptr;
    if (found == nullptr)
        problem = ::dlerror();
    return found;
}

std::string hostName() {
    std::array<char, 256> name{};
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

} // namespace bask
