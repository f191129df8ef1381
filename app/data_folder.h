#pragma once
// Where the program keeps data other than settings: BASK_SETTINGS_DIR, or the user's data folder.

#include <QDir>
#include <QString>

namespace bask {

QDir dataFolder();
/// Returns the file that keeps the alarms across restarts, and creates its folder; empty if that fails.
QString alarmFile();
/// Returns the file of the known devices, in the same way.
QString deviceFile();
/// Returns the file of the settings of the monitoring, in the same way.
QString monitorFile();
/// Returns the file of the library of materials, in the same way.
QString materialFile();

} // namespace bask
