#include "engine/experiment/rig_file.h"

#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/rig_json.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kMaxRigBytes = 1u << 20;

RigSpec readRigRoot(const json& j, Failure& failure) {
    RigSpec rig;
    Fields root(j, {}, failure);
    std::string format;
    int version = 0;
    root.read("format", format, true);
    root.read("version", version, true);
    if (!format.empty() && format != "bask-rig")
        root.fail(MessageCode::ValueUnknown, "format", {plainWords(format), "bask-rig"});
    else if (version > kRigFormat)
        root.fail(MessageCode::VersionTooNew, "version",
                  {std::to_string(version), std::to_string(kRigFormat)});
    else if (root.find("version") != nullptr && version < 1)
        root.fail(MessageCode::ValueOutOfRange, "version",
                  {std::to_string(version), "1", std::to_string(kRigFormat), ""});
    readPart(root, "rig", true,
             [&](const json& part, const std::string& path) { readRig(part, path, failure, rig); });
    root.close();
    return rig;
}

Result<RigSpec> rigFromText(const std::string& text) {
    if (const auto trouble = checkJsonText(text))
        return Error(trouble->code, {}, trouble->args);
    try {
        Failure failure;
        RigSpec rig = readRigRoot(json::parse(text), failure);
        if (failure)
            return *failure;
        return rig;
    } catch (const json::exception& e) {
        return Error(MessageCode::JsonSyntax, {}, {plainWords(e.what())});
    }
}

} // namespace

bool isRigFile(const std::string& path) {
    const auto text = readTextFile(path, kMaxRigBytes);
    return text && text->substr(0, 1024).find("\"bask-rig\"") != std::string::npos;
}

Result<RigSpec> readRigFile(const std::string& path) {
    const auto text = readTextFile(path, kMaxRigBytes);
    if (!text)
        return text.error();
    if (text->find_first_not_of(" \t\r\n") == std::string::npos)
        return Error(MessageCode::FileEmpty, path);
    Result<RigSpec> rig = rigFromText(*text);
    if (rig)
        return rig;
    Error error = rig.error();
    error.where = error.where.empty() ? path : path + ": " + error.where;
    return error;
}

Result<void> writeRigFile(const RigSpec& rig, const std::string& path) {
    nlohmann::ordered_json j;
    j["format"] = "bask-rig";
    j["version"] = kRigFormat;
    j["rig"] = rigJson(rig);
    return writeTextFile(path, j.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
