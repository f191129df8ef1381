#include "engine/base/alarm_entry.h"

#include "engine/base/message_code.h"

#include <array>

namespace bask {
namespace {

// NOLINTNEXTLINE(readability-identifier-naming): as the table writes them
enum AlarmTrait : unsigned { Plain = 0, OfObject = 1, Loss = 2, SeenOver = 4 };

constexpr AlarmEntry entryOf(SafetyCondition condition, MessageCode code, const char* key, int priority,
                             SafetyReaction reaction, unsigned traits, double on_s, double off_s) {
    return {condition,
            code,
            key,
            priority,
            reaction,
            (traits & OfObject) != 0,
            (traits & Loss) != 0,
            (traits & SeenOver) != 0,
            on_s,
            off_s};
}

// clang-format off
constexpr std::array kAlarmTable{
#define ALARM(condition, name, priority, reaction, traits, on_s, off_s, key, ...)                            \
    entryOf(SafetyCondition::condition, MessageCode::name, *key != '\0' ? key : #name, priority,             \
            SafetyReaction::reaction, traits, on_s, off_s),
#define DEVICE_ALARM(condition, priority, reaction, traits, on_s, off_s, key)                                \
    entryOf(SafetyCondition::condition, MessageCode::None, key, priority, SafetyReaction::reaction, traits,   \
            on_s, off_s),
#include "engine/base/alarm_table.inc"
#undef ALARM
#undef DEVICE_ALARM
};
// clang-format on

} // namespace

const AlarmEntry& alarmEntry(SafetyCondition condition) {
    return kAlarmTable.at(static_cast<std::size_t>(condition)); // both are made from the same lines
}

std::span<const AlarmEntry> alarmEntries() {
    return kAlarmTable;
}

} // namespace bask
