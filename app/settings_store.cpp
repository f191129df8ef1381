#include "app/settings_store.h"

#include "app/data_folder.h"
#include "widgets/common/language.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>

#include <algorithm>

namespace bask {
namespace {

constexpr int kWindowVersion = 1; ///< grows when docks change, so that an old layout is not restored

QString overrideFolder() {
    return qEnvironmentVariable("BASK_SETTINGS_DIR");
}

QString settingsFile() {
    const QString folder = overrideFolder();
    return folder.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) +
                                  QStringLiteral("/bask.ini")
                            : QDir(folder).filePath(QStringLiteral("bask.ini"));
}

QString folderKey(FileFolder kind) {
    switch (kind) {
    case FileFolder::Recordings:
        return QStringLiteral("recordingFolder");
    case FileFolder::Exports:
        return QStringLiteral("exportFolder");
    case FileFolder::Imports:
        return QStringLiteral("importFolder");
    case FileFolder::Experiments:
        break;
    }
    return QStringLiteral("folder");
}

QString windowKey(const char* what) {
    return QStringLiteral("window/%1-%2").arg(what).arg(kWindowVersion);
}

} // namespace

QString recordingFolder() {
    return dataFolder().filePath(QStringLiteral("sessions"));
}

QString unsavedFolder() {
    return dataFolder().filePath(QStringLiteral("unsaved"));
}

QString runMarkFolder() {
    return dataFolder().filePath(QStringLiteral("runs-on"));
}

SettingsStore::SettingsStore() : m_settings(settingsFile(), QSettings::IniFormat) {}

TemperatureUnit SettingsStore::temperatureUnit() const {
    const QString value = m_settings.value(QStringLiteral("unit")).toString();
    return value == QLatin1String("K")   ? TemperatureUnit::Kelvin
           : value == QLatin1String("F") ? TemperatureUnit::Fahrenheit
                                         : TemperatureUnit::Celsius;
}

void SettingsStore::setTemperatureUnit(TemperatureUnit unit) {
    m_settings.setValue(QStringLiteral("unit"), unit == TemperatureUnit::Kelvin       ? QStringLiteral("K")
                                                : unit == TemperatureUnit::Fahrenheit ? QStringLiteral("F")
                                                                                      : QStringLiteral("C"));
}

Theme SettingsStore::theme() const {
    const QString value = m_settings.value(QStringLiteral("theme")).toString();
    return value == QLatin1String("light")  ? Theme::Light
           : value == QLatin1String("dark") ? Theme::Dark
                                            : Theme::System;
}

void SettingsStore::setTheme(Theme theme) {
    m_settings.setValue(QStringLiteral("theme"), theme == Theme::Light  ? QStringLiteral("light")
                                                 : theme == Theme::Dark ? QStringLiteral("dark")
                                                                        : QStringLiteral("system"));
}

int SettingsStore::textSize_percent() const {
    const int value = m_settings.value(QStringLiteral("textSize")).toInt();
    return std::ranges::count(kTextSizes_percent, value) > 0 ? value : 100;
}

void SettingsStore::setTextSize_percent(int percent) {
    m_settings.setValue(QStringLiteral("textSize"), percent);
}

HornMode SettingsStore::hornMode() const {
    const QString value = m_settings.value(QStringLiteral("horn")).toString();
    return value == QLatin1String("off")      ? HornMode::Off
           : value == QLatin1String("always") ? HornMode::Always
                                              : HornMode::RealRig;
}

void SettingsStore::setHornMode(HornMode mode) {
    m_settings.setValue(QStringLiteral("horn"), mode == HornMode::Off      ? QStringLiteral("off")
                                                : mode == HornMode::Always ? QStringLiteral("always")
                                                                           : QStringLiteral("real"));
}

QString SettingsStore::language() const {
    const QString value = m_settings.value(QStringLiteral("language")).toString();
    return Language::codes().contains(value) ? value : Language::ofDesktop();
}

void SettingsStore::setLanguage(const QString& code) {
    m_settings.setValue(QStringLiteral("language"), code);
}

QStringList SettingsStore::recentFiles() const {
    return m_settings.value(QStringLiteral("recent")).toStringList().mid(0, kMaxRecent);
}

void SettingsStore::addRecentFile(const QString& path) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    QStringList files = recentFiles();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings.setValue(QStringLiteral("recent"), files.mid(0, kMaxRecent));
}

void SettingsStore::removeRecentFile(const QString& path) {
    QStringList files = recentFiles();
    files.removeAll(QFileInfo(path).absoluteFilePath());
    m_settings.setValue(QStringLiteral("recent"), files);
}

void SettingsStore::clearRecentFiles() {
    m_settings.remove(QStringLiteral("recent"));
}

QStringList SettingsStore::recentOperators() const {
    return m_settings.value(QStringLiteral("operators")).toStringList().mid(0, kMaxRecent);
}

void SettingsStore::addRecentOperator(const QString& name) {
    QStringList names = recentOperators();
    names.removeAll(name);
    names.prepend(name);
    m_settings.setValue(QStringLiteral("operators"), names.mid(0, kMaxRecent));
}

bool SettingsStore::asksLabels() const {
    return m_settings.value(QStringLiteral("askLabels")).toBool();
}

void SettingsStore::setAsksLabels(bool asks) {
    m_settings.setValue(QStringLiteral("askLabels"), asks);
}

bool SettingsStore::isCoachAnswered() const {
    return m_settings.value(QStringLiteral("coachAnswered")).toBool();
}

void SettingsStore::setCoachAnswered() {
    m_settings.setValue(QStringLiteral("coachAnswered"), true);
}

QString SettingsStore::lastFolder(FileFolder kind) const {
    for (const FileFolder each : {kind, FileFolder::Experiments}) {
        const QString folder = m_settings.value(folderKey(each)).toString();
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    }
    return QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
}

void SettingsStore::setLastFolder(FileFolder kind, const QString& folder) {
    m_settings.setValue(folderKey(kind), folder);
}

QString SettingsStore::sessionFolder() const {
    const QString folder = m_settings.value(QStringLiteral("sessions")).toString();
    return folder.isEmpty() ? recordingFolder() : folder;
}

/// That of the recordings is not put down: it follows the settings' own place.
void SettingsStore::setSessionFolder(const QString& folder) {
    if (folder == recordingFolder())
        m_settings.remove(QStringLiteral("sessions"));
    else
        m_settings.setValue(QStringLiteral("sessions"), folder);
}

QString SettingsStore::sessionSorting() const {
    return m_settings.value(QStringLiteral("sessionSorting")).toString();
}

void SettingsStore::setSessionSorting(const QString& sorting) {
    m_settings.setValue(QStringLiteral("sessionSorting"), sorting);
}

FigureLayout SettingsStore::figureLayout() const {
    const FigureLayout usual;
    const double width_mm = m_settings.value(QStringLiteral("figureWidth_mm"), usual.width_mm).toDouble();
    const bool isPossible = width_mm >= kNarrowest_mm && width_mm <= kWidest_mm;
    return {isPossible ? width_mm : usual.width_mm,
            m_settings.value(QStringLiteral("figureHeading"), usual.hasHeading).toBool()};
}

void SettingsStore::setFigureLayout(const FigureLayout& layout) {
    m_settings.setValue(QStringLiteral("figureWidth_mm"), layout.width_mm);
    m_settings.setValue(QStringLiteral("figureHeading"), layout.hasHeading);
}

QByteArray SettingsStore::windowGeometry() const {
    return m_settings.value(windowKey("geometry")).toByteArray();
}
QByteArray SettingsStore::windowState() const {
    return m_settings.value(windowKey("state")).toByteArray();
}

void SettingsStore::setWindow(const QByteArray& geometry, const QByteArray& state) {
    m_settings.setValue(windowKey("geometry"), geometry);
    m_settings.setValue(windowKey("state"), state);
}

QByteArray SettingsStore::largeNumbersGeometry() const {
    return m_settings.value(windowKey("large-numbers")).toByteArray();
}

void SettingsStore::setLargeNumbersGeometry(const QByteArray& geometry) {
    m_settings.setValue(windowKey("large-numbers"), geometry);
}

QByteArray SettingsStore::plotWindowGeometry(const QString& plot) const {
    return m_settings.value(windowKey(qPrintable(plot))).toByteArray();
}

void SettingsStore::setPlotWindowGeometry(const QString& plot, const QByteArray& geometry) {
    m_settings.setValue(windowKey(qPrintable(plot)), geometry);
}

} // namespace bask
