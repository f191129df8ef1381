#pragma once
// Values as a person reads them: numbers with units in the notation of the language (see language.h), and
// words for states and sentences.

#include "engine/base/message.h"
#include "engine/base/units.h"
#include "engine/control/controller_settings.h"
#include "engine/model/safety_spec.h"
#include "engine/runtime/snapshot.h"

#include <QString>

#include <optional>
#include <span>

class QDateTime;

namespace bask {

/// Text instead of a value that is not known or not valid.
inline const QString kNoValue = QStringLiteral("\u2014");

/// Returns "40.0 °C"; a dash if it is not finite.
QString formatTemperature(double t_K, TemperatureUnit unit, int decimals = 1);
/// Returns how many decimals show the first digit of an uncertainty: 1 for 0.6, 2 for 0.05 and 3 for 0.004;
/// at least `min`. Empty for one that is not known, or that four decimals do not show: "± 0.00" says nothing.
std::optional<int> decimalsOf(double uncertainty, int min);
/// Returns "40.2 °C ± 0.6 K", with the expanded uncertainty (two standard deviations) and the digits that it
/// allows; without one that decimalsOf() is empty for.
QString formatReading(double t_K, double standardUncertainty_K, TemperatureUnit unit);
/// Returns "40.0", without the unit.
QString formatTemperatureNumber(double t_K, TemperatureUnit unit, int decimals = 1);
/// Returns "+0.3 K" (a difference, with its sign); a dash if it is not finite.
QString formatDifference(double d_K, TemperatureUnit unit, int decimals = 1);
/// Returns the difference of two temperatures as they are printed with so many decimals; a dash if one is not
/// finite.
QString formatPrintedDifference(double t_K, double reference_K, TemperatureUnit unit, int decimals = 1);
/// "+1.2 K/min".
QString formatRate(double rate_K_s, TemperatureUnit unit, int decimals = 1);
/// "0:42", "12:03", "1:02:03".
QString formatDuration(double time_s);
/// Returns "12 s old", "2:05 old"; "no value yet" if there was none.
QString formatAge(double age_s);
/// Returns "2026-11-23 14:05" in local time, the same in every language.
QString formatDate(const QDateTime& time);
/// "12.5 mm".
QString formatLength_mm(double length_m, int decimals = 1);
/// Signed number in the locale's notation with a true minus sign; zero has no sign.
QString formatSigned(double value, int decimals);
/// Returns the number as it is printed with so many decimals.
double roundedTo(double value, int decimals);
/// Returns the decimals of values that are printed beside their differences from `reference`: `decimals`, or
/// up to two more where the differences, rounded, would not be those of the rounded values. Print a
/// difference as that of the rounded values. What is not finite counts for nothing.
int decimalsWithDifferences(std::span<const double> values, double reference, int decimals);

/// Returns what stands between values of a list, ", "; "; " where a comma is the decimal mark.
QString listSeparator();

QString temperatureUnitSymbol(TemperatureUnit unit); ///< "°C"
QString differenceUnitSymbol(TemperatureUnit unit);  ///< "K"

QString runStateWord(RunState state);        ///< "Not ready"
QString runStateExplanation(RunState state); ///< one sentence, for tool-tips and an empty list of reasons
/// Returns "Sensor lost"; for None, the words that end all faults.
QString simulatedFaultWord(SimulatedFault fault);
QString controllerWord(ControllerKind kind); ///< "Level servo"

/// Sets the unit of temperatures in sentences for callers that do not name one: the window's unit. GUI
/// thread.
void setReadersUnit(TemperatureUnit unit);
TemperatureUnit readersUnit();

/// Returns the translated sentence of a message (context "Message") with its arguments, temperatures to a
/// tenth.
QString messageText(const Message& message, TemperatureUnit unit = readersUnit());
/// Returns the same with a capital first letter, for a sentence that stands alone.
QString sentenceText(const Message& message, TemperatureUnit unit = readersUnit());
/// Returns the same as messageText(), but without a unit in degC and K, with the digits of a file.
QString recordedText(const Message& message, std::optional<TemperatureUnit> unit);
/// Returns the first sentence of sentenceText(): what is wrong, for narrow places.
QString headlineText(const Message& message, TemperatureUnit unit);
/// Returns the text with a capital first letter.
QString asSentence(QString text);

} // namespace bask
