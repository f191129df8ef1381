#include "app/data_folder.h"

#include <QStandardPaths>

namespace bask {

QDir dataFolder() {
    const QString folder = qEnvironmentVariable("BASK_SETTINGS_DIR");
    return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) : folder;
}

QString alarmFile() {
    const QDir folder = dataFolder();
    return folder.mkpath(QStringLiteral(".")) ? folder.filePath(QStringLiteral("alarms.json")) : QString();
}

QString deviceFile() {
    const QDir folder = dataFolder();
    return folder.mkpath(QStringLiteral(".")) ? folder.filePath(QStringLiteral("devices.json")) : QString();
}

} // namespace bask
