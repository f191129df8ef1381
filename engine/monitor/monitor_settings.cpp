#include "engine/monitor/monitor_settings.h"

#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/experiment/text_file.h"
#include "engine/protocols/network_address.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>

#include <sys/stat.h>

namespace bask {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "bask-monitor";
constexpr int kVersion = 1;
constexpr std::uintmax_t kMaxBytes = 1 << 16;
constexpr std::size_t kMaxTopic = 128;

/// Parts between slashes, none of them empty; no wildcards, and nothing of the broker's own ($SYS).
bool isTopic(const std::string& topic) {
    const auto isPart = [](unsigned char letter) {
        return std::isalnum(letter) != 0 || letter == '.' || letter == '-' || letter == '_' || letter == '/';
    };
    return !topic.empty() && topic.size() <= kMaxTopic && topic.front() != '/' && topic.back() != '/' &&
           topic.find("//") == std::string::npos && std::ranges::all_of(topic, isPart);
}

} // namespace

Result<void> validate(const MonitorSettings& settings) {
    const BrokerSettings& broker = settings.broker;
    if (settings.usesFiles && settings.statusFolder.empty())
        return Error(MessageCode::JsonMissingKey, {}, {"status_folder"});
    if (!settings.usesBroker)
        return {};
    if (!networkAddress(broker.address, broker.usualPort()))
        return Error(MessageCode::MonitorAddressWrong, "broker.address", {broker.address});
    if (!isTopic(broker.topic))
        return Error(MessageCode::MonitorTopicWrong, "broker.topic", {broker.topic});
    if (broker.user.empty() && !broker.passwordFile.empty())
        return Error(MessageCode::JsonMissingKey, "broker", {"user"});
    return {};
}

Result<std::string> readPassword(const std::string& file) {
    struct stat info {};
    if (::stat(file.c_str(), &info) == 0 && (info.st_mode & (S_IRWXG | S_IRWXO)) != 0)
        return Error(MessageCode::MonitorSecretOpen, file);
    auto text = readTextFile(file, kMaxBytes);
    if (!text)
        return text;
    text->erase(std::min(text->find_first_of("\r\n"), text->size()));
    if (text->empty())
        return Error(MessageCode::FileEmpty, file);
    return text;
}

Result<MonitorSettings> readMonitorSettings(const std::string& path) {
    const auto text = readTextFile(path, kMaxBytes);
    if (!text && text.error().code() == MessageCode::FileNotFound)
        return MonitorSettings();
    if (!text)
        return text.error();
    auto read =
        readJsonText<MonitorSettings>(*text, path, [](const json& j, Failure& failure, MonitorSettings& out) {
            Fields root(j, {}, failure);
            readHeader(root, kFormat, kVersion);
            if (root.find("status_folder") != nullptr) {
                out.usesFiles = true;
                root.read("status_folder", out.statusFolder);
                root.read("status_files_on", out.usesFiles);
            }
            if (const json* broker = root.find("broker")) {
                Fields fields(*broker, "broker", failure);
                out.usesBroker = true;
                fields.read("on", out.usesBroker);
                fields.read("address", out.broker.address, true);
                fields.read("tls", out.broker.usesTls);
                fields.read("ca_file", out.broker.caFile);
                fields.read("user", out.broker.user);
                fields.read("password_file", out.broker.passwordFile);
                fields.read("topic", out.broker.topic);
                fields.close();
            }
            root.close();
        });
    if (!read)
        return read;
    if (const auto valid = validate(*read); !valid)
        return Error(valid.error().code(), path + ": " + valid.error().where, valid.error().message.args);
    return read;
}

Result<void> writeMonitorSettings(const MonitorSettings& settings, const std::string& path) {
    nlohmann::ordered_json j{{"format", kFormat}, {"version", kVersion}};
    const BrokerSettings& broker = settings.broker;
    if (settings.usesBroker || !broker.address.empty())
        j["broker"] = {{"on", settings.usesBroker}, {"address", broker.address},
                       {"tls", broker.usesTls},     {"ca_file", broker.caFile},
                       {"user", broker.user},       {"password_file", broker.passwordFile},
                       {"topic", broker.topic}};
    if (settings.usesFiles || !settings.statusFolder.empty()) {
        j["status_files_on"] = settings.usesFiles;
        j["status_folder"] = settings.statusFolder;
    }
    return writeTextFile(path, j.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
