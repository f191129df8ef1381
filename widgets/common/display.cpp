#include "widgets/common/display.h"

#include "engine/base/message_code.h"
#include "engine/control/controller_catalogue.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace bask {
namespace {

struct DisplayWords {
    Q_DECLARE_TR_FUNCTIONS(bask::Display)
};

QString number(double value, int decimals) {
    const double scale = std::pow(10.0, decimals);
    const double rounded = std::round(value * scale) / scale;
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

QString formatTemperatureNumber(double t_K, TemperatureUnit unit, int decimals) {
    return std::isfinite(t_K) ? number(displayTemperature(t_K, unit), decimals) : kNoValue;
}

QString formatTemperature(double t_K, TemperatureUnit unit, int decimals) {
    if (!std::isfinite(t_K))
        return kNoValue;
    return formatTemperatureNumber(t_K, unit, decimals) + kNarrowSpace + temperatureUnitSymbol(unit);
}

QString formatDifference(double d_K, TemperatureUnit unit, int decimals) {
    if (!std::isfinite(d_K))
        return kNoValue;
    return formatSigned(displayDifference(d_K, unit), decimals) + kNarrowSpace + differenceUnitSymbol(unit);
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
    const auto total = static_cast<long long>(std::floor(std::abs(time_s)));
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

QString temperatureUnitSymbol(TemperatureUnit unit) {
    return QString::fromUtf8(temperatureSymbol(unit));
}
QString differenceUnitSymbol(TemperatureUnit unit) {
    return QString::fromUtf8(differenceSymbol(unit));
}

QString runStateWord(RunState state) {
    switch (state) {
    case RunState::Idle:
        return DisplayWords::tr("Idle");
    case RunState::NotReady:
        return DisplayWords::tr("Not ready");
    case RunState::Ready:
        return DisplayWords::tr("Ready");
    case RunState::Armed:
        return DisplayWords::tr("Armed");
    case RunState::Running:
        return DisplayWords::tr("Running");
    case RunState::Holding:
        return DisplayWords::tr("Holding");
    case RunState::Settled:
        return DisplayWords::tr("Settled");
    case RunState::Stopping:
        return DisplayWords::tr("Stopping");
    case RunState::Stopped:
        return DisplayWords::tr("Stopped");
    case RunState::Fault:
        return DisplayWords::tr("Fault (latched)");
    }
    return {};
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
    switch (fault) {
    case SimulatedFault::None:
        return DisplayWords::tr("Restore all devices");
    case SimulatedFault::SensorLost:
        return DisplayWords::tr("Sensor lost");
    case SimulatedFault::SensorOpen:
        return DisplayWords::tr("Sensor open");
    case SimulatedFault::SensorShort:
        return DisplayWords::tr("Sensor shorted");
    case SimulatedFault::SensorFrozen:
        return DisplayWords::tr("Sensor frozen");
    case SimulatedFault::SensorJumping:
        return DisplayWords::tr("Sensor jumping");
    case SimulatedFault::SensorOff:
        return DisplayWords::tr("Sensor off its object");
    case SimulatedFault::ObjectHot:
        return DisplayWords::tr("Object heated otherwise");
    case SimulatedFault::RobotLost:
        return DisplayWords::tr("Robot lost");
    case SimulatedFault::RobotAlarm:
        return DisplayWords::tr("Robot in alarm");
    case SimulatedFault::RobotRestarted:
        return DisplayWords::tr("Robot restarted");
    case SimulatedFault::RobotSlow:
        return DisplayWords::tr("Robot slow");
    case SimulatedFault::SourceLost:
        return DisplayWords::tr("Heat source lost");
    case SimulatedFault::SourceSilent:
        return DisplayWords::tr("Heat source without temperature");
    case SimulatedFault::SourceNotHeating:
        return DisplayWords::tr("Heat source does not heat");
    case SimulatedFault::SourceHeatsAlone:
        return DisplayWords::tr("Heat source heats unasked");
    case SimulatedFault::SourceOverheats:
        return DisplayWords::tr("Heat source overheats");
    case SimulatedFault::SourceLimited:
        return DisplayWords::tr("Heat source limited by itself");
    case SimulatedFault::SourceKeepsHeat:
        return DisplayWords::tr("Heat source cannot be switched off");
    case SimulatedFault::SourceCovered:
        return DisplayWords::tr("Source hidden from the camera");
    case SimulatedFault::CameraLost:
        return DisplayWords::tr("Camera lost");
    }
    return {};
}

namespace {

/// Where the engine's own English stands as an argument.
QString argument(const Message& message, std::size_t i) {
    static constexpr std::array kDevices{QT_TRANSLATE_NOOP("bask::Display", "robot"),
                                         QT_TRANSLATE_NOOP("bask::Display", "thermometer"),
                                         QT_TRANSLATE_NOOP("bask::Display", "heat source"),
                                         QT_TRANSLATE_NOOP("bask::Display", "heat source kept by hand"),
                                         QT_TRANSLATE_NOOP("bask::Display", "source temperature")};
    static constexpr std::array kDamages{
        QT_TRANSLATE_NOOP("bask::Display", "database disk image is malformed"), // SQLite's
        QT_TRANSLATE_NOOP("bask::Display", "it is cut short"),
        QT_TRANSLATE_NOOP("bask::Display", "a sample is missing"),
        QT_TRANSLATE_NOOP("bask::Display", "it does not say whether the rig was simulated")};
    if (message.code == MessageCode::SessionDamaged)
        for (const char* words : kDamages)
            if (message.args[i] == words)
                return DisplayWords::tr(words);
    if (i == 0 && (message.code == MessageCode::EventFault || message.code == MessageCode::EventObjectFault))
        for (int k = 0; k < kSimulatedFaults; ++k)
            if (const auto fault = static_cast<SimulatedFault>(k);
                message.args[0] == simulatedFaultName(fault))
                return simulatedFaultWord(fault);
    if (message.code == MessageCode::LimitLooser)
        return QCoreApplication::translate("Parameter", message.args[i].c_str());
    if (message.code == MessageCode::RigIncomplete)
        for (const char* word : kDevices)
            if (message.args[i] == word)
                return DisplayWords::tr(word);
    return QString::fromStdString(message.args[i]);
}

} // namespace

QString messageText(const Message& message) {
    if (const auto within = messageWithin(message))
        return messageText({message.code, {messageText(*within).toStdString()}});
    QString text = QCoreApplication::translate("Message", messageTemplate(message.code));
    // In one pass, so that a "%1" inside an argument stays as it is.
    QString out;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int digit = text[i] == QLatin1Char('%') && i + 1 < text.size() ? text[i + 1].digitValue() : -1;
        if (digit < 1) {
            out += text[i];
            continue;
        }
        if (static_cast<std::size_t>(digit) <= message.args.size())
            out += argument(message, static_cast<std::size_t>(digit - 1));
        ++i;
    }
    return out;
}

QString sentenceText(const Message& message) {
    QString text = messageText(message);
    return text.isEmpty() ? text : text.replace(0, 1, text[0].toUpper());
}

QString inUnit(const QString& sentence, TemperatureUnit unit) {
    static const QRegularExpression quantity(
        QStringLiteral("([-\u2212]?\\d+(?:\\.\\d+)?)[ \u00a0](\u00b0C|K)\\b"));
    QString out;
    qsizetype from = 0;
    for (auto found = quantity.globalMatch(sentence); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        out += QStringView(sentence).mid(from, match.capturedStart() - from);
        from = match.capturedEnd();
        const double value = match.captured(1).replace(QChar(0x2212), QLatin1Char('-')).toDouble();
        if (match.captured(2) != QLatin1String("K"))
            out += formatTemperature(kelvinFromCelsius(value), unit);
        else if (unit == TemperatureUnit::Fahrenheit)
            out += number(displayDifference(value, unit), 1) + kNarrowSpace + differenceUnitSymbol(unit);
        else
            out += match.captured();
    }
    return out += QStringView(sentence).mid(from);
}

} // namespace bask
