#include "engine/experiment/alarm_file.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/text_file.h"
#include "engine/model/alarm.h"

#include "engine/experiment/json_fields.h"

#include <QFile>
#include <QString>

#include <nlohmann/json.hpp>

namespace bask {
namespace {

using nlohmann::json;

constexpr int kVersion = 1;
constexpr qint64 kMaxAlarmBytes = 1 << 20;

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
            {"shelf_reason", alarm.shelfReason}};
}

} // namespace

Result<std::vector<Alarm>> readAlarms(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.exists())
        return std::vector<Alarm>();
    if (!file.open(QIODevice::ReadOnly))
        return Error(MessageCode::FileUnreadable, path, {file.errorString().toStdString()});
    const std::string text = file.read(kMaxAlarmBytes).toStdString();
    try {
        const json j = json::parse(text);
        Failure failure;
        std::string format;
        int version = 0;
        Fields root(j, "", failure);
        root.read("format", format, true);
        root.read("version", version, true);
        const json* list = root.find("alarms", true);
        root.close();
        if (!failure && (format != "bask-alarms" || !list->is_array()))
            root.fail(MessageCode::ValueUnknown, "format", {plainWords(format), "bask-alarms"});
        if (!failure && version > kVersion)
            root.fail(MessageCode::VersionTooNew, "version",
                      {std::to_string(version), std::to_string(kVersion)});
        std::vector<Alarm> alarms;
        for (std::size_t i = 0; !failure && i < list->size(); ++i)
            alarms.push_back(readAlarm((*list)[i], "alarms[" + std::to_string(i) + ']', failure));
        if (failure)
            return Error(failure->message.code, path + ": " + failure->where, failure->message.args);
        std::erase_if(alarms, [](const Alarm& alarm) { return alarm.message.code == MessageCode::None; });
        return alarms;
    } catch (const json::exception& exception) {
        return Error(MessageCode::JsonSyntax, path, {plainWords(exception.what())});
    }
}

Result<void> writeAlarms(const std::vector<Alarm>& alarms, const std::string& path) {
    nlohmann::ordered_json j{
        {"format", "bask-alarms"}, {"version", kVersion}, {"alarms", nlohmann::ordered_json::array()}};
    for (const Alarm& alarm : alarms)
        j["alarms"].push_back(alarmJson(alarm));
    return writeTextFile(path, j.dump(1, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace bask
