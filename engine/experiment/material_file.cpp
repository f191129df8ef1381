#include "engine/experiment/material_file.h"

#include "engine/base/message_code.h"
#include "engine/experiment/material_json.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr const char* kLibraryFormat = "bask-materials";
constexpr int kLibraryVersion = 1;
constexpr std::uintmax_t kMaxLibraryBytes = std::uintmax_t{4} << 20;

Material readLibraryMaterial(const json& j, const std::string& path, Failure& failure) {
    Material out;
    Fields fields(j, path, failure);
    fields.find("name", true);
    readMaterialFields(fields, out);
    fields.close();
    return out;
}

} // namespace

Result<MaterialLibrary> readMaterialLibrary(const std::string& path) {
    const auto text = readTextFile(path, kMaxLibraryBytes);
    if (!text)
        return text.error();
    return readJsonText<MaterialLibrary>(
        *text, path, [](const json& j, Failure& failure, MaterialLibrary& library) {
            Fields root(j, {}, failure);
            readHeader(root, kLibraryFormat, kLibraryVersion);
            readEach(root, "materials", true, [&](const json& entry, const std::string& where) {
                library.push_back(readLibraryMaterial(entry, where, failure));
            });
            root.close();
            if (!failure)
                failure = failureOf(validate(library));
        });
}

Result<void> writeMaterialLibrary(const MaterialLibrary& library, const std::string& path) {
    if (auto valid = validate(library); !valid)
        return valid;
    nlohmann::ordered_json j{{"format", kLibraryFormat},
                             {"version", kLibraryVersion},
                             {"materials", nlohmann::ordered_json::array()}};
    for (const Material& material : library)
        j["materials"].push_back(materialJson(material));
    const std::string text = j.dump(1, ' ', false, json::error_handler_t::replace) + '\n';
    if (text.size() > kMaxLibraryBytes)
        return Error(
            MessageCode::FileTooLarge, path,
            {std::to_string(text.size() >> 20) + " MiB", std::to_string(kMaxLibraryBytes >> 20) + " MiB"});
    return writeTextFile(path, text);
}

} // namespace bask
