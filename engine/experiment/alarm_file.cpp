#include "engine/experiment/alarm_file.h"

#include "engine/base/json_fields.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr std::uintmax_t kMaxAlarmBytes = 1 << 20;

Alarm readAlarm(const json& j, const std::string& path, Failure& failure) {
    Alarm alarm;
    std::string code;
    Fields fields(j, path, failure);
    fields.read("key", alarm.key, true);
    fields.read("message", code, true);
    fields.read("priority", alarm.priority, true);
    fields.read("active", alarm.isActive);
    fields.read("acknowledged", alarm.isAcknowledged);
    fields.read("first", alarm.isFirst);
    fields.read("live", alarm.isLive);
    fields.read("before", alarm.isFromBefore);
    fields.read("count", alarm.count);
    fields.read("raised_s", alarm.raised_s);
    fields.read("cleared_s", alarm.cleared_s);
    fields.read("cause", alarm.cause);
    fields.read("shelved_until_s", alarm.shelvedUntil_s);
    fields.read("shelf_reason", alarm.shelfReason);
    fields.read("seen_by", alarm.seenBy);
    if (const json* args = fields.find("args"); args != nullptr && args->is_array())
        for (const json& arg : *args)
            alarm.message.args.push_back(arg.is_string() ? arg.get<std::string>() : std::string());
    fields.close();
    alarm.message.code = messageCodeFromName(code);
    return alarm;
}

nlohmann::ordered_json alarmJson(const Alarm& alarm) {
    return {{"key", alarm.key},
            {"message", messageName(alarm.message.code)},
            {"args", argTexts(alarm.message)},
            {"priority", alarm.priority},
            {"active", alarm.isActive},
            {"acknowledged", alarm.isAcknowledged},
            {"first", alarm.isFirst},
            {"live", alarm.isLive},
            {"before", alarm.isFromBefore},
            {"count", alarm.count},
            {"raised_s", alarm.raised_s},
            {"cleared_s", alarm.cleared_s},
            {"cause", alarm.cause},
            {"shelved_until_s", alarm.shelvedUntil_s},
            {"shelf_reason", alarm.shelfReason},
            {"seen_by", alarm.seenBy}};
}

} // namespace

Result<std::vector<Alarm>> readAlarms(const std::string& path) {
    const auto text = readTextFile(path, kMaxAlarmBytes);
    if (!text && text.error().code() == MessageCode::FileNotFound)
        return std::vector<Alarm>();
    if (!text)
        return text.error();
    using Alarms = std::vector<Alarm>;
    return readJsonText<Alarms>(*text, path, [](const json& j, Failure& failure, Alarms& alarms) {
        Fields root(j, {}, failure);
        readHeader(root, "bask-alarms", kVersion);
        readEach(root, "alarms", true, [&](const json& entry, const std::string& where) {
            alarms.push_back(readAlarm(entry, where, failure));
        });
        root.close();
        std::erase_if(alarms, [](const Alarm& alarm) { return alarm.message.code == MessageCode::None; });
    });
}

Result<void> writeAlarms(const std::vector<Alarm>& alarms, const std::string& path) {
    nlohmann::ordered_json j{
        {"format", "bask-alarms"}, {"version", kVersion}, {"alarms", nlohmann::ordered_json::array()}};
    for (const Alarm& alarm : alarms)
        j["alarms"].push_back(alarmJson(alarm));
    return writeTextFile(path, j.dump(1, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
