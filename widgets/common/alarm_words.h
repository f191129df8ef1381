#pragma once
// An alarm in words, for the list, the state bar and a screen reader.

#include "engine/base/units.h"
#include "engine/model/alarm.h"

#include <QDate>
#include <QString>

namespace bask {

/// Returns "Active, new, first": whether it is active, whether it was acknowledged, and what is special.
QString alarmStateWords(const Alarm& alarm);
/// "Shelved until 14:05:00: the fan is off today".
QString shelfWords(const Alarm& alarm, QDate today);
/// Returns what is wrong, value, limit, likely cause and what to do, with temperatures in the shown unit.
QString alarmSentence(const Alarm& alarm, TemperatureUnit unit);
/// Returns the first part of the sentence, for narrow places.
QString alarmHeadline(const Alarm& alarm, TemperatureUnit unit);
/// Returns "14:02:11" in local time; with the date if that is not `today`.
QString alarmTime(double utc_s, QDate today);

} // namespace bask
