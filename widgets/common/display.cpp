#include "widgets/common/display.h"

#include "engine/base/message_code.h"
#include "engine/base/words.h"
#include "engine/control/controller_catalogue.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>

namespace bask {
namespace {

struct DisplayWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Display)
};

QString number(double value, int decimals) {
    const double rounded = roundedTo(value, decimals);
    QString text = QLocale().toString(rounded == 0.0 ? 0.0 : rounded, 'f', decimals);
    return text.replace(QLatin1Char('-'), QChar(0x2212));
}

constexpr QChar kNarrowSpace(0x00a0); // no line break between figure and unit

} // namespace

QString formatSigned(double value, int decimals) {
    const QString text = number(value, decimals);
    const bool zero = std::abs(value) < 0.5 * std::pow(10.0, -decimals);
    return value > 0.0 && !zero ? QLatin1Char('+') + text : text;
}

double roundedTo(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    return std::round(value * scale) / scale;
}

int decimalsWithDifferences(std::span<const double> values, double reference, int decimals) {
    constexpr int kMoreAtMost = 2;
    const auto agree = [&](int with) {
        const double half = 0.5 * std::pow(10.0, -with);
        return std::ranges::all_of(values, [&](double value) {
            const double printed = roundedTo(value, with) - roundedTo(reference, with);
            return !std::isfinite(value - reference) ||
                   std::abs(printed - roundedTo(value - reference, with)) < half;
        });
    };
    int with = decimals;
    while (with < decimals + kMoreAtMost && !agree(with))
        ++with;
    return with;
}

QString formatTemperatureNumber(double t_K, TemperatureUnit unit, int decimals) {
    return std::isfinite(t_K) ? number(displayTemperature(t_K, unit), decimals) : kNoValue;
}

QString formatTemperature(double t_K, TemperatureUnit unit, int decimals) {
    if (!std::isfinite(t_K))
        return kNoValue;
    return formatTemperatureNumber(t_K, unit, decimals) + kNarrowSpace + temperatureUnitSymbol(unit);
}

std::optional<int> decimalsOf(double uncertainty, int min) {
    constexpr int kMax = 4;
    constexpr double kRoundsUp = 0.95; // 0.095 is shown as 0.1
    if (!std::isfinite(uncertainty) || uncertainty < kRoundsUp * std::pow(10.0, -kMax))
        return std::nullopt;
    return std::clamp(-static_cast<int>(std::floor(std::log10(uncertainty / kRoundsUp))), min, kMax);
}

QString formatReading(double t_K, double standardUncertainty_K, TemperatureUnit unit) {
    constexpr double kNoTenths = 9.5;
    const double expanded = displayDifference(2.0 * standardUncertainty_K, unit);
    const auto decimals = decimalsOf(expanded, expanded < kNoTenths ? 1 : 0);
    if (!decimals)
        return formatTemperature(t_K, unit);
    return formatTemperature(t_K, unit, *decimals) + QStringLiteral(" \u00b1 ") +
           QLocale().toString(expanded, 'f', *decimals) + QChar(0x00a0) + differenceUnitSymbol(unit);
}

QString formatDifference(double d_K, TemperatureUnit unit, int decimals) {
    if (!std::isfinite(d_K))
        return kNoValue;
    return formatSigned(displayDifference(d_K, unit), decimals) + kNarrowSpace + differenceUnitSymbol(unit);
}

QString formatPrintedDifference(double t_K, double reference_K, TemperatureUnit unit, int decimals) {
    const auto printed = [&](double each_K) { return roundedTo(displayTemperature(each_K, unit), decimals); };
    const double difference = printed(t_K) - printed(reference_K);
    if (!std::isfinite(difference))
        return kNoValue;
    return formatSigned(difference, decimals) + kNarrowSpace + differenceUnitSymbol(unit);
}

QString formatRate(double rate_K_s, TemperatureUnit unit, int decimals) {
    if (!std::isfinite(rate_K_s))
        return kNoValue;
    return formatSigned(displayDifference(rate_K_s, unit) * 60.0, decimals) + kNarrowSpace +
           DisplayWords::tr("%1/min", "a rate; %1 is K or °F").arg(differenceUnitSymbol(unit));
}

QString formatDuration(double time_s) {
    if (!std::isfinite(time_s))
        return kNoValue;
    constexpr double kMax_s = 1e15; // a damaged file may say any number
    const auto total = static_cast<long long>(std::floor(std::min(std::abs(time_s), kMax_s)));
    const QChar zero(QLatin1Char('0'));
    const QString seconds = QStringLiteral("%1").arg(total % 60, 2, 10, zero);
    const QString text =
        total >= 3600
            ? QStringLiteral("%1:%2:%3").arg(total / 3600).arg(total / 60 % 60, 2, 10, zero).arg(seconds)
            : QStringLiteral("%1:%2").arg(total / 60).arg(seconds);
    return time_s < 0.0 && total > 0 ? QChar(0x2212) + text : text;
}

QString formatAge(double age_s) {
    if (!std::isfinite(age_s))
        return DisplayWords::tr("no value yet");
    if (age_s < 99.5)
        return DisplayWords::tr("%1 s old").arg(std::max(0.0, age_s), 0, 'f', 0);
    return DisplayWords::tr("%1 old", "%1 is minutes and seconds").arg(formatDuration(age_s));
}

QString formatDate(const QDateTime& time) {
    return time.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm"));
}

QString formatLength_mm(double length_m, int decimals) {
    return std::isfinite(length_m) ? number(length_m * 1000.0, decimals) + kNarrowSpace + QStringLiteral("mm")
                                   : kNoValue;
}

QString listSeparator() {
    return QLocale().decimalPoint() == u',' ? QStringLiteral("; ") : QStringLiteral(", ");
}

QString temperatureUnitSymbol(TemperatureUnit unit) {
    return QString::fromUtf8(temperatureSymbol(unit));
}
QString differenceUnitSymbol(TemperatureUnit unit) {
    return QString::fromUtf8(differenceSymbol(unit));
}

namespace {

/// A word of the engine's own; what is none is shown as it is.
QString engineWord(ArgKind kind, const std::string& name) {
    return QCoreApplication::translate(wordContext(kind), wordText(kind, name));
}

} // namespace

QString runStateWord(RunState state) {
    return engineWord(ArgKind::State, runStateName(state));
}

QString runStateExplanation(RunState state) {
    switch (state) {
    case RunState::Idle:
        return DisplayWords::tr("Nothing is armed.");
    case RunState::NotReady:
        return DisplayWords::tr("The rig cannot be armed or started yet.");
    case RunState::Ready:
        return DisplayWords::tr("Nothing stands in the way: press Arm.");
    case RunState::Armed:
        return DisplayWords::tr("The sensors are zeroed and the recording is open: press Start.");
    case RunState::Running:
        return DisplayWords::tr("The robot moves the objects towards their targets.");
    case RunState::Holding:
        return DisplayWords::tr("Zero velocity; the controller's state is kept. Press Resume to go on.");
    case RunState::Settled:
        return DisplayWords::tr(
            "All objects stay within their tolerance band. The controller keeps working.");
    case RunState::Stopping:
        return DisplayWords::tr("The robot takes the objects away, and the heat was ordered off.");
    case RunState::Stopped:
        return DisplayWords::tr("The run has ended.");
    case RunState::Fault:
        return DisplayWords::tr("A stop or a fault is latched. Remove its cause, then press Reset.");
    }
    return {};
}

QString controllerWord(ControllerKind kind) {
    return QCoreApplication::translate("Controller", controllerEntry(kind).name);
}

QString simulatedFaultWord(SimulatedFault fault) {
    return engineWord(ArgKind::Fault, simulatedFaultName(fault));
}

namespace {

TemperatureUnit g_readersUnit = TemperatureUnit::Celsius;

/// Of the engine's numbers, with or without a unit, which have a point.
QString inNotation(QString text) {
    static const QRegularExpression kNumber(
        QStringLiteral("^[+-]?\\d+\\.\\d+(e[+-]?\\d+)?([ \\x{a0}]\\S+)?$"));
    const QString mark = QLocale().decimalPoint();
    return mark != u'.' && kNumber.match(text).hasMatch() ? text.replace(text.indexOf(u'.'), 1, mark) : text;
}

/// Puts an argument in words; without a unit as it is recorded.
class ArgWords {
public:
    ArgWords(const Message& message, std::optional<TemperatureUnit> unit)
        : m_message(message), m_unit(unit) {}

    QString at(std::size_t i) const {
        const MessageArg& arg = m_message.args[i];
        const ArgKind kind = arg.kind(argKind(m_message.code, i));
        const QString text = QString::fromStdString(arg.text());
        switch (kind) {
        case ArgKind::Number:
            return inNotation(text);
        case ArgKind::Temperature:
            return temperature(arg, kind, text) + space() + temperatureUnitSymbol(shownUnit());
        case ArgKind::BareTemperature:
            return temperature(arg, kind, text);
        case ArgKind::Difference:
            return difference(arg, kind, text) + space() + differenceUnitSymbol(shownUnit());
        case ArgKind::Temperatures:
        case ArgKind::Differences:
            return objects(arg, kind, text);
        case ArgKind::Figure:
            return isCelsius() && m_unit != TemperatureUnit::Celsius ? temperature(arg, kind, text)
                                                                     : inNotation(text);
        case ArgKind::FigureUnit:
            return isCelsius() ? temperatureUnitSymbol(shownUnit()) : text;
        case ArgKind::Sentence:
            return sentences(arg, text);
        default:
            return wordContext(kind) != nullptr ? engineWord(kind, arg.text()) : text;
        }
    }

private:
    TemperatureUnit shownUnit() const { return m_unit.value_or(TemperatureUnit::Celsius); }

    QChar space() const { return m_unit ? kNarrowSpace : QChar(u' '); }

    /// Of figures: their unit is the last argument.
    bool isCelsius() const {
        return m_unit && m_message.args.back().text() == temperatureSymbol(TemperatureUnit::Celsius);
    }

    QString temperature(const MessageArg& arg, ArgKind kind, const QString& text) const {
        const auto t_K = arg.kelvin(kind);
        return m_unit && t_K && std::isfinite(*t_K) ? formatTemperatureNumber(*t_K, *m_unit)
                                                    : inNotation(text);
    }

    /// Kelvins have the digits that they are recorded with.
    QString difference(const MessageArg& arg, ArgKind kind, const QString& text) const {
        const auto d_K = arg.kelvin(kind);
        return m_unit == TemperatureUnit::Fahrenheit && d_K && std::isfinite(*d_K)
                   ? number(displayDifference(*d_K, *m_unit), 1)
                   : inNotation(text);
    }

    QString objects(const MessageArg& arg, ArgKind kind, const QString& text) const {
        const bool isTemperature = kind == ArgKind::Temperatures;
        QStringList words;
        if (!m_unit || (!isTemperature && *m_unit != TemperatureUnit::Fahrenheit)) {
            constexpr TemperatureUnit kRecorded = TemperatureUnit::Celsius;
            const QString symbol =
                isTemperature ? temperatureUnitSymbol(kRecorded) : differenceUnitSymbol(kRecorded);
            for (const ObjectFigure& each : arg.figures(kind))
                words << QString::fromStdString(each.object) + u' ' +
                             inNotation(QString::fromStdString(each.figure)) + u' ' + symbol;
        } else {
            for (const ObjectKelvin& each : arg.objects(kind))
                words << QString::fromStdString(each.object) + u' ' +
                             (isTemperature ? formatTemperature(each.value_K, *m_unit)
                                            : formatDifference(each.value_K, *m_unit));
        }
        return words.isEmpty() ? text : words.join(listSeparator());
    }

    QString sentences(const MessageArg& arg, const QString& text) const {
        QStringList words;
        for (const Message& each : arg.sentences())
            words << recordedText(each, m_unit);
        return words.isEmpty() ? text : words.join(QStringLiteral("; "));
    }

    const Message& m_message;
    std::optional<TemperatureUnit> m_unit;
};

} // namespace

void setReadersUnit(TemperatureUnit unit) {
    g_readersUnit = unit;
}

TemperatureUnit readersUnit() {
    return g_readersUnit;
}

QString messageText(const Message& message, TemperatureUnit unit) {
    return recordedText(message, unit);
}

namespace {

/// In one pass, so that a "%1" inside an argument stays as it is.
QString filledIn(QStringView text, const Message& message, std::optional<TemperatureUnit> unit) {
    const ArgWords args(message, unit);
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int digit = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
        if (digit < 1) {
            out += text[i];
            continue;
        }
        if (static_cast<std::size_t>(digit) <= message.args.size())
            out += args.at(static_cast<std::size_t>(digit - 1));
        ++i;
    }
    return out;
}

QString translatedTemplate(MessageCode code) {
    return QCoreApplication::translate("Message", messageTemplate(code));
}

/// Of a translated template: its first sentence.
QString firstSentence(const QString& text) {
    const qsizetype full = text.indexOf(QStringLiteral(". ")), chinese = text.indexOf(QChar(0x3002));
    const qsizetype end = full < 0 ? chinese : chinese < 0 ? full : std::min(full, chinese);
    return end < 0 ? text : text.left(end + 1);
}

} // namespace

QString recordedText(const Message& message, std::optional<TemperatureUnit> unit) {
    if (auto within = messageWithin(message))
        return recordedText({message.code, {std::move(*within)}}, unit);
    return filledIn(translatedTemplate(message.code), message, unit);
}

QString headlineText(const Message& message, TemperatureUnit unit) {
    return asSentence(filledIn(firstSentence(translatedTemplate(message.code)), message, unit));
}

QString asSentence(QString text) {
    return text.isEmpty() ? text : text.replace(0, 1, text[0].toUpper());
}

QString sentenceText(const Message& message, TemperatureUnit unit) {
    return asSentence(messageText(message, unit));
}

} // namespace bask
