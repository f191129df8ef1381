#include "app/error_text.h"

#include "engine/runtime/snapshot.h"
#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>
#include <vector>

namespace bask {
namespace {

struct Verb {
    const char* name; ///< as the engine gives it
    const char* text;
};
constexpr std::array kVerbs{
    Verb{"Arm", QT_TRANSLATE_NOOP("Verb", "Arm")},       Verb{"Disarm", QT_TRANSLATE_NOOP("Verb", "Disarm")},
    Verb{"Start", QT_TRANSLATE_NOOP("Verb", "Start")},   Verb{"Hold", QT_TRANSLATE_NOOP("Verb", "Hold")},
    Verb{"Resume", QT_TRANSLATE_NOOP("Verb", "Resume")}, Verb{"Stop", QT_TRANSLATE_NOOP("Verb", "Stop")},
    Verb{"Reset", QT_TRANSLATE_NOOP("Verb", "Reset")},
};

std::string translatedVerb(const std::string& name) {
    for (const Verb& verb : kVerbs)
        if (name == verb.name)
            return QCoreApplication::translate("Verb", verb.text).toStdString();
    return name;
}

std::string translatedState(const std::string& name) {
    for (int i = 0; i <= static_cast<int>(RunState::Fault); ++i)
        if (name == runStateName(static_cast<RunState>(i)))
            return runStateWord(static_cast<RunState>(i)).toStdString();
    return name;
}

/// Templates as patterns, to recognise a sentence that the engine put into another one.
struct Pattern {
    MessageCode code;
    QRegularExpression expression;
};

std::vector<Pattern> makePatterns() {
    std::vector<Pattern> patterns;
    for (int i = 1;; ++i) {
        const auto code = static_cast<MessageCode>(i);
        if (messageCodeFromName(messageName(code)) != code)
            return patterns; // past the last one
        QString text = QRegularExpression::escape(QString::fromUtf8(messageTemplate(code)));
        text.replace(QRegularExpression(QStringLiteral("\\\\%([1-9])")), QStringLiteral("(?<a\\1>.*)"));
        patterns.push_back({code, QRegularExpression(QRegularExpression::anchoredPattern(text))});
    }
}

/// An English sentence of the engine in the window's language; anything else as it is.
QString translatedSentence(const std::string& english) {
    static const std::vector<Pattern> patterns = makePatterns();
    const QString text = QString::fromStdString(english);
    for (const Pattern& pattern : patterns) {
        const auto match = pattern.expression.match(text);
        if (!match.hasMatch())
            continue;
        Message message{pattern.code, {}};
        for (int i = 1; i <= pattern.expression.captureCount(); ++i)
            message.args.push_back(match.captured(QStringLiteral("a%1").arg(i)).toStdString());
        return messageText(message);
    }
    return text;
}

} // namespace

QString sentence(const Message& message) {
    if (message.code == MessageCode::EventFault && message.args.size() == 1)
        return messageText({message.code, {translatedSentence(message.args[0]).toStdString()}});
    if (message.code != MessageCode::CommandNotNow || message.args.size() != 2)
        return messageText(message);
    return messageText({message.code, {translatedVerb(message.args[0]), translatedState(message.args[1])}});
}

QString sentence(const Error& error) {
    const QString text = sentence(error.message);
    return error.where.empty() ? text : QString::fromStdString(error.where) + QStringLiteral(": ") + text;
}

} // namespace bask
