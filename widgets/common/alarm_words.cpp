#include "widgets/common/alarm_words.h"

#include "widgets/common/display.h"

#include <QCoreApplication>
#include <QDateTime>

namespace bask {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(bask::AlarmWords)
};

} // namespace

QString alarmStateWords(const Alarm& alarm) {
    QStringList words{alarm.isActive ? Words::tr("Active") : Words::tr("Over"),
                      !alarm.isAcknowledged ? Words::tr("new")
                      : alarm.seenBy.empty()
                          ? Words::tr("seen")
                          : Words::tr("seen by %1").arg(QString::fromStdString(alarm.seenBy))};
    if (alarm.isFirst)
        words << Words::tr("first");
    if (alarm.isFromBefore)
        words << Words::tr("from before");
    return words.join(Words::tr(", ", "between states"));
}

QString shelfWords(const Alarm& alarm, QDate today) {
    const QString until = alarmTime(alarm.shelvedUntil_s, today);
    const QString reason = QString::fromStdString(alarm.shelfReason);
    return alarm.seenBy.empty() ? Words::tr("Shelved until %1: %2").arg(until, reason)
                                : Words::tr("Shelved until %1 by %3: %2")
                                      .arg(until, reason, QString::fromStdString(alarm.seenBy));
}

QString alarmSentence(const Alarm& alarm, TemperatureUnit unit) {
    return sentenceText(alarm.message, unit);
}

QString alarmHeadline(const Alarm& alarm, TemperatureUnit unit) {
    return headlineText(alarm.message, unit);
}

QString alarmTime(double utc_s, QDate today) {
    const QDateTime time = QDateTime::fromMSecsSinceEpoch(qRound64(utc_s * 1000.0));
    return time.toString(time.date() == today ? QStringLiteral("HH:mm:ss")
                                              : QStringLiteral("yyyy-MM-dd HH:mm:ss"));
}

} // namespace bask
