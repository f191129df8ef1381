#pragma once
// Values as a person reads them: numbers with units in the locale's notation, words for states and sentences.

#include "engine/base/message.h"
#include "engine/base/units.h"
#include "engine/control/controller_settings.h"
#include "engine/model/safety_spec.h"
#include "engine/runtime/snapshot.h"

#include <QString>

#include <optional>

class QDateTime;

namespace bask {

/// What stands in place of a value that is not known or not valid.
inline const QString kNoValue = QStringLiteral("\u2014");

/// "40.0 °C"; a dash when not finite.
QString formatTemperature(double t_K, TemperatureUnit unit, int decimals = 1);
/// "40.0", without the unit.
QString formatTemperatureNumber(double t_K, TemperatureUnit unit, int decimals = 1);
/// "+0.3 K" (a difference, with its sign); a dash when not finite.
QString formatDifference(double d_K, TemperatureUnit unit, int decimals = 1);
/// "+1.2 K/min".
QString formatRate(double rate_K_s, TemperatureUnit unit, int decimals = 1);
/// "0:42", "12:03", "1:02:03".
QString formatDuration(double time_s);
/// "12 s old", "2:05 old"; of what was never told "no value yet".
QString formatAge(double age_s);
/// "2026-11-23 14:05" where this computer is: the same in every language.
QString formatDate(const QDateTime& time);
/// "12.5 mm".
QString formatLength_mm(double length_m, int decimals = 1);
/// Signed number in the locale's notation with a true minus sign; zero has no sign.
QString formatSigned(double value, int decimals);

QString temperatureUnitSymbol(TemperatureUnit unit); ///< "°C"
QString differenceUnitSymbol(TemperatureUnit unit);  ///< "K"

QString runStateWord(RunState state);        ///< "Not ready"
QString runStateExplanation(RunState state); ///< one sentence, for tool-tips and an empty list of reasons
/// "Sensor lost"; of None what ends them all.
QString simulatedFaultWord(SimulatedFault fault);
QString controllerWord(ControllerKind kind); ///< "Level servo"

/// The unit in which sentences speak of temperatures where nobody names one: the window's. Of the GUI thread.
void setReadersUnit(TemperatureUnit unit);
TemperatureUnit readersUnit();

/// Translated sentence of a message (context "Message") with its arguments put in, temperatures to a tenth.
QString messageText(const Message& message, TemperatureUnit unit = readersUnit());
/// The same with a capital letter in front: where it stands by itself.
QString sentenceText(const Message& message, TemperatureUnit unit = readersUnit());
/// The same as messageText(), but without a unit in degC and K with the digits that a file has.
QString recordedText(const Message& message, std::optional<TemperatureUnit> unit);
/// The first sentence of sentenceText(): what is wrong, for where there is little room.
QString headlineText(const Message& message, TemperatureUnit unit);
/// With a capital letter in front.
QString asSentence(QString text);

} // namespace bask
