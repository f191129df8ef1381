#include "engine/recording/ro_crate.h"

#include "engine/base/message_code.h"
#include "engine/base/version.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <map>

namespace bask {
namespace {

using Json = nlohmann::json;

constexpr const char* kSpecification = "https://w3id.org/ro/crate/1.1";
constexpr const char* kExporter = "#exporter";
constexpr const char* kVerification = "#verification";
constexpr std::uintmax_t kMaxCrateBytes = 64 << 20;
constexpr std::size_t kMaxDescribed = 1000; ///< of more files, pictures are not described one by one

const char* mediaType(const std::string& name) {
    static const std::map<std::string, const char*> kTypes{
        {".csv", "text/csv"},        {".nxs", "application/x-hdf5"}, {".vtp", "application/xml"},
        {".vti", "application/xml"}, {".pvd", "application/xml"},    {".png", "image/png"},
        {".svg", "image/svg+xml"},   {".pdf", "application/pdf"},    {".tif", "image/tiff"}};
    const auto found = kTypes.find(std::filesystem::path(name).extension().string());
    return found == kTypes.end() ? "application/octet-stream" : found->second;
}

/// A file of the crate; null if it cannot be read.
Json fileEntity(const std::string& name, const std::string& path) {
    QFile file(QString::fromStdString(path));
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (!file.open(QIODevice::ReadOnly) || !hash.addData(&file))
        return {};
    return {{"@id", name},
            {"@type", "File"},
            {"name", name},
            {"encodingFormat", mediaType(name)},
            {"contentSize", std::to_string(file.size())},
            {"sha256", hash.result().toHex().toStdString()}};
}

std::string sessionId(const SessionRecord& session) {
    return "#" + std::filesystem::path(session.path).filename().string() + " " + session.created;
}

/// What an earlier export into the folder said, by "@id"; nothing of another session's.
Result<std::map<std::string, Json>> earlierFiles(const std::string& path, const SessionRecord& session) {
    std::map<std::string, Json> entities;
    std::error_code failed;
    if (!std::filesystem::exists(path, failed))
        return entities;
    const Error foreign(MessageCode::ExportForeign, path);
    std::ifstream in(path, std::ios::binary);
    if (std::filesystem::file_size(path, failed) > kMaxCrateBytes || failed)
        return foreign;
    const Json json = Json::parse(in, nullptr, false);
    if (!json.is_object() || !json.contains("@graph") || !json.at("@graph").is_array())
        return foreign;
    bool isOfSession = false, isOwn = false;
    for (const Json& entity : json.at("@graph")) {
        if (!entity.is_object() || !entity.contains("@id") || !entity.at("@id").is_string())
            return foreign;
        isOwn = isOwn || (entity.at("@id") == kExporter && entity.value("name", Json()).is_string() &&
                          entity.at("name").get<std::string>().starts_with("Bask "));
        isOfSession = isOfSession || entity.at("@id") == sessionId(session);
        if (entity.value("@type", Json()) == "File")
            entities[entity.at("@id")] = entity;
    }
    if (!isOwn)
        return foreign;
    if (!isOfSession)
        entities.clear();
    return entities;
}

} // namespace

Result<void> addCrate(StagedFiles& files, const SessionRecord& session) {
    auto entities = earlierFiles(files.target(kCrateName), session);
    if (!entities)
        return entities.error();
    std::erase_if(*entities, [&](const auto& entry) { // files that are no longer there
        std::error_code failed;
        return !std::filesystem::exists(files.target(entry.first), failed);
    });
    const bool areMany = files.names().size() > kMaxDescribed;
    for (const std::string& name : files.names())
        if (areMany && name.ends_with(".tif"))
            continue;
        else if (Json entity = fileEntity(name, files.staged(name)); !entity.is_null())
            (*entities)[name] = std::move(entity);
    const std::string id = sessionId(session);
    Json parts = Json::array();
    Json graph = Json::array({{{"@id", kCrateName},
                               {"@type", "CreativeWork"},
                               {"about", {{"@id", "./"}}},
                               {"conformsTo", {{"@id", kSpecification}}}}});
    for (const auto& [name, entity] : *entities)
        parts.push_back({{"@id", name}});
    const std::string title = session.experiment.title.empty() ? "A run of radiation-based thermal servoing"
                                                               : session.experiment.title;
    graph.push_back({{"@id", "./"},
                     {"@type", "Dataset"},
                     {"name", title},
                     {"description", std::string("A recorded run of radiation-based thermal servoing on ") +
                                         (session.simulated ? "a simulated rig" : "a real rig") +
                                         ", exported by Bask. Outcome: " +
                                         (session.interrupted() ? "interrupted" : session.outcome) +
                                         ". Verification of the recording: " + session.verification + "."},
                     {"datePublished", session.created},
                     {"hasPart", parts},
                     {"mentions", {{"@id", id}}}});
    Json run{{"@id", id},
             {"@type", "CreateAction"},
             {"name", std::filesystem::path(session.path).filename().string()},
             {"startTime", session.created},
             {"additionalProperty", {{"@id", kVerification}}},
             {"instrument", Json::array({{{"@id", "#recorder"}}, {{"@id", kExporter}}})}};
    const auto& [operatorName, sample, batch] = session.labels;
    if (!operatorName.empty()) {
        run["agent"] = {{"@id", "#operator"}};
        graph.push_back({{"@id", "#operator"}, {"@type", "Person"}, {"name", operatorName}});
    }
    if (!sample.empty() || !batch.empty()) {
        run["object"] = {{"@id", "#sample"}};
        graph.push_back({{"@id", "#sample"},
                         {"@type", "IndividualProduct"},
                         {"name", sample.empty() ? "of batch " + batch : sample},
                         {"description", batch.empty() ? "the sample that was heated" : "batch " + batch}});
    }
    graph.push_back(std::move(run));
    graph.push_back({{"@id", kVerification},
                     {"@type", "PropertyValue"},
                     {"name", "verification"},
                     {"value", session.verification}});
    graph.push_back({{"@id", "#recorder"},
                     {"@type", "SoftwareApplication"},
                     {"name", session.software.empty() ? "Bask" : session.software}});
    graph.push_back({{"@id", kExporter}, {"@type", "SoftwareApplication"}, {"name", "Bask " BASK_VERSION}});
    for (auto& [name, entity] : *entities)
        graph.push_back(std::move(entity));
    const Json crate{{"@context", std::string(kSpecification) + "/context"}, {"@graph", std::move(graph)}};
    return files.write(kCrateName, crate.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
}

} // namespace bask
