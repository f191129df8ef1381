#include "app/error_text.h"

#include "engine/base/message_code.h"
#include "engine/runtime/snapshot.h"
#include "widgets/common/display.h"

#include <QCoreApplication>

#include <array>

namespace bask {
namespace {

struct VerbText {
    const char* name; ///< as the engine gives it
    const char* text;
};
constexpr std::array kVerbTexts{
    VerbText{"Arm", QT_TRANSLATE_NOOP("Verb", "Arm")},
    VerbText{"Disarm", QT_TRANSLATE_NOOP("Verb", "Disarm")},
    VerbText{"Start", QT_TRANSLATE_NOOP("Verb", "Start")},
    VerbText{"Hold", QT_TRANSLATE_NOOP("Verb", "Hold")},
    VerbText{"Resume", QT_TRANSLATE_NOOP("Verb", "Resume")},
    VerbText{"Stop", QT_TRANSLATE_NOOP("Verb", "Stop")},
    VerbText{"Reset", QT_TRANSLATE_NOOP("Verb", "Reset")},
    VerbText{"Set targets", QT_TRANSLATE_NOOP("Verb", "Set targets")},
    VerbText{"Connecting", QT_TRANSLATE_NOOP("Verb", "Connecting")}, // no run's state
};

std::string translatedVerb(const std::string& name) {
    for (const VerbText& verb : kVerbTexts)
        if (name == verb.name)
            return QCoreApplication::translate("Verb", verb.text).toStdString();
    return name;
}

std::string translatedState(const std::string& name) {
    for (int i = 0; i <= static_cast<int>(RunState::Fault); ++i)
        if (name == runStateName(static_cast<RunState>(i)))
            return runStateWord(static_cast<RunState>(i)).toStdString();
    return translatedVerb(name);
}

} // namespace

QString sentence(const Message& message) {
    if (message.code != MessageCode::CommandNotNow || message.args.size() != 2)
        return messageText(message);
    return messageText({message.code, {translatedVerb(message.args[0]), translatedState(message.args[1])}});
}

QString sentence(const Error& error) {
    const QString text = sentence(error.message);
    return error.where.empty() ? text : QString::fromStdString(error.where) + QStringLiteral(": ") + text;
}

} // namespace bask
