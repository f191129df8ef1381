#include "app/data_folder.h"

#include <QStandardPaths>

namespace bask {

QDir dataFolder() {
    const QString folder = qEnvironmentVariable("BASK_SETTINGS_DIR");
    return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) : folder;
}

namespace {

QString fileIn(const QDir& folder, const QString& name) {
    return folder.mkpath(QStringLiteral(".")) ? folder.filePath(name) : QString();
}

} // namespace

QString alarmFile() {
    return fileIn(dataFolder(), QStringLiteral("alarms.json"));
}

QString deviceFile() {
    return fileIn(dataFolder(), QStringLiteral("devices.json"));
}

QString monitorFile() {
    return fileIn(dataFolder(), QStringLiteral("monitor.json"));
}

QString materialFile() {
    return fileIn(dataFolder(), QStringLiteral("materials.json"));
}

} // namespace bask
