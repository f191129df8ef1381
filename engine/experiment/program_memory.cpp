#include "engine/experiment/program_memory.h"

#include "engine/base/json_fields.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

constexpr int kProgramsVersion = 1;
constexpr std::uintmax_t kMaxProgramsBytes = 1U << 20;

} // namespace

Result<ProgramMemory> readProgramMemory(const std::string& path) {
    const auto text = readTextFile(path, kMaxProgramsBytes);
    if (!text && text.error().code() == MessageCode::FileNotFound)
        return ProgramMemory();
    if (!text)
        return text.error();
    return readJsonText<ProgramMemory>(
        *text, path, [](const nlohmann::json& j, Failure& failure, ProgramMemory& memory) {
            Fields root(j, {}, failure);
            readHeader(root, "bask-programs", kProgramsVersion);
            readEach(root, "programs", true, [&](const nlohmann::json& entry, const std::string& where) {
                std::string command, hash;
                Fields fields(entry, where, failure);
                fields.read("command", command, true);
                fields.read("sha256", hash, true);
                fields.close();
                memory[hash] = command;
            });
            root.close();
        });
}

Result<void> writeProgramMemory(const ProgramMemory& memory, const std::string& path) {
    nlohmann::ordered_json j{{"format", "bask-programs"},
                             {"version", kProgramsVersion},
                             {"programs", nlohmann::ordered_json::array()}};
    for (const auto& [hash, command] : memory)
        j["programs"].push_back({{"command", command}, {"sha256", hash}});
    return writeTextFile(path, j.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
}

} // namespace bask
