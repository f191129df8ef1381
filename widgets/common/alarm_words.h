#pragma once
// An alarm in words: what the list, the state bar and a screen reader say of it.

#include "engine/base/units.h"
#include "engine/model/alarm.h"

#include <QDate>
#include <QString>

namespace bask {

/// "Active, new, first": whether it is still so, whether somebody has seen it, and what is special.
QString alarmStateWords(const Alarm& alarm);
/// "Shelved until 14:05:00: the fan is off today".
QString shelfWords(const Alarm& alarm, QDate today);
/// What, value, limit, likely cause and what to do, temperatures in the unit shown.
QString alarmSentence(const Alarm& alarm, TemperatureUnit unit);
/// Its first part, for where there is little room.
QString alarmHeadline(const Alarm& alarm, TemperatureUnit unit);
/// "14:02:11", local; with the date if that is not `today`.
QString alarmTime(double utc_s, QDate today);

} // namespace bask
