#pragma once
// Where the program keeps what is not settings: BASK_SETTINGS_DIR, or the user's own folder for its data.

#include <QDir>
#include <QString>

namespace bask {

QDir dataFolder();
/// The alarms over a restart; the folder is made. Empty: it cannot be.
QString alarmFile();
/// Which devices this computer has met; the same.
QString deviceFile();

} // namespace bask
