#include "engine/experiment/rig_file.h"

#include "engine/base/plain_text.h"
#include "engine/experiment/rig_json.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxRigBytes = 1u << 20;

} // namespace

bool isRigFile(const std::string& path) {
    const auto text = readTextFile(path, kMaxRigBytes);
    return text && text->substr(0, 1024).find("\"bask-rig\"") != std::string::npos;
}

Result<RigSpec> readRigFile(const std::string& path) {
    const auto text = readTextFile(path, kMaxRigBytes);
    if (!text)
        return text.error();
    return readJsonText<RigSpec>(*text, path, [](const json& j, Failure& failure, RigSpec& rig) {
        Fields root(j, {}, failure);
        readHeader(root, "bask-rig", kRigFormat);
        readPart(root, "rig", true,
                 [&](const json& part, const std::string& where) { readRig(part, where, failure, rig); });
        root.close();
    });
}

Result<void> writeRigFile(const RigSpec& rig, const std::string& path) {
    nlohmann::ordered_json j;
    j["format"] = "bask-rig";
    j["version"] = kRigFormat;
    j["rig"] = rigJson(rig);
    return writeTextFile(path, j.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
