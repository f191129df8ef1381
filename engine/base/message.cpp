#include "engine/base/message.h"

#include "engine/base/message_code.h"
#include "engine/base/notice.h"
#include "engine/base/result.h"
#include "engine/base/translated.h"

#include <algorithm>
#include <array>
#include <concepts>
#include <iterator>
#include <string_view>

namespace bask {
namespace {

// NOLINTNEXTLINE(readability-identifier-naming): as the tables write them
enum Rank : int { NoAlarm = 0, Priority1 = 1, Priority2 = 2, Priority3 = 3, Notice = 4 };

/// An alarm of low priority about which the engine does nothing asks nothing of a person.
constexpr Rank rankOf(int priority, std::string_view reaction) {
    return priority == 3 && reaction == "Note" ? Notice : static_cast<Rank>(priority);
}

/// Of the arguments, in their order.
struct Kinds {
    constexpr Kinds(std::same_as<ArgKind> auto... kinds) : all{kinds...}, count(sizeof...(kinds)) {}
    std::array<ArgKind, 9> all;
    std::size_t count;
};

struct Entry {
    MessageCode code;
    const char* name;
    Rank rank;
    const char* text;
    Kinds kinds;
};

using enum ArgKind;

// lupdate finds each QT_TRANSLATE_NOOP of the tables through this file.
// clang-format off
constexpr Entry kMessages[]{ // not std::array, which clang deduces of no more than 256
    {MessageCode::None, "None", NoAlarm, "", {}},
#define MESSAGE(name, rank, english, ...) {MessageCode::name, #name, rank, english, {__VA_ARGS__}},
#define ALARM(condition, name, priority, reaction, traits, on_s, off_s, key, english, ...)                   \
    {MessageCode::name, #name, rankOf(priority, #reaction), english, {__VA_ARGS__}},
#define DEVICE_ALARM(...)
#include "engine/base/message_table.inc"
#include "engine/base/alarm_table.inc"
#undef MESSAGE
#undef ALARM
#undef DEVICE_ALARM
};
// clang-format on

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < std::size(kMessages); ++i)
        if (kMessages[i].code != static_cast<MessageCode>(i))
            return false;
    return true;
}
static_assert(isInOrder(), "the codes are made from the tables, see message_names.cmake");

constexpr std::size_t argsOf(std::string_view text) {
    std::size_t highest = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i)
        if (text[i] == '%' && text[i + 1] >= '1' && text[i + 1] <= '9')
            highest = std::max(highest, static_cast<std::size_t>(text[i + 1] - '0'));
    return highest;
}
static_assert(std::ranges::all_of(kMessages, [](const Entry& e) { return argsOf(e.text) == e.kinds.count; }),
              "each argument of a sentence has its kind in the table");

const Entry& entry(MessageCode code) {
    const auto index = static_cast<std::size_t>(code);
    return index < std::size(kMessages) ? kMessages[index] : kMessages[0];
}

} // namespace

bool isAboutAnother(MessageCode code) {
    return argKind(code, 0) == About;
}

const char* messageTemplate(MessageCode code) {
    return entry(code).text;
}

ArgKind argKind(MessageCode code, std::size_t index) {
    const Kinds& kinds = entry(code).kinds;
    return index < kinds.count ? kinds.all[index] : Text;
}

const char* messageName(MessageCode code) {
    return entry(code).name;
}

MessageCode messageCodeFromName(const std::string& name) {
    const auto it = std::ranges::find_if(kMessages, [&](const Entry& e) { return name == e.name; });
    return it == std::end(kMessages) ? MessageCode::None : it->code;
}

int alarmPriority(MessageCode code) {
    return std::min<int>(entry(code).rank, Priority3);
}

bool isNotice(MessageCode code) {
    return entry(code).rank == Notice;
}

std::optional<Message> messageWithin(const Message& message) {
    if (!isAboutAnother(message.code) || message.args.empty())
        return std::nullopt;
    const MessageCode code = messageCodeFromName(message.args.front().text());
    if (code == MessageCode::None || isAboutAnother(code))
        return std::nullopt;
    return Message{code, {message.args.begin() + 1, message.args.end()}};
}

Message messageAbout(MessageCode code, const Message& about) {
    Message out{code, {messageName(about.code)}};
    out.args.insert(out.args.end(), about.args.begin(), about.args.end());
    return out;
}

namespace {

std::string inEnglish(const MessageArg& arg, ArgKind declared) {
    switch (arg.kind(declared)) {
    case Temperature:
        return arg.text() + " \u00b0C";
    case Difference:
        return arg.text() + " K";
    default:
        return arg.text();
    }
}

} // namespace

std::string describe(const Message& message) {
    if (const auto within = messageWithin(message))
        return describe(Message{message.code, {MessageArg(describe(*within))}});
    std::string out;
    for (const char* p = messageTemplate(message.code); *p != '\0'; ++p) {
        if (*p == '%' && p[1] >= '1' && p[1] <= '9') {
            const auto index = static_cast<std::size_t>(p[1] - '1');
            if (index < message.args.size())
                out += inEnglish(message.args[index], argKind(message.code, index));
            ++p;
        } else {
            out += *p;
        }
    }
    out.erase(out.find_last_not_of(' ') + 1); // a unit may be empty
    return out;
}

std::string describe(const Error& error) {
    return error.where.empty() ? describe(error.message) : error.where + ": " + describe(error.message);
}

std::vector<std::string> argTexts(const Message& message) {
    std::vector<std::string> out;
    for (const MessageArg& arg : message.args)
        out.push_back(arg.text());
    return out;
}

} // namespace bask
