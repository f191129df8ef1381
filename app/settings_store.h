#pragma once
// What Bask remembers between starts: recent files, units, theme, language, window places.

#include "app/data_folder.h"
#include "app/horn.h"
#include "engine/base/units.h"
#include "widgets/common/theme.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <array>

namespace bask {

/// An INI file in the user's configuration folder, or in the folder that BASK_SETTINGS_DIR names. Unknown
/// values read as the defaults.
class SettingsStore {
public:
    static constexpr int kMaxRecent = 8;
    static constexpr std::array kTextSizes_percent{100, 125, 150, 200};

    SettingsStore();

    TemperatureUnit temperatureUnit() const;
    void setTemperatureUnit(TemperatureUnit unit);

    Theme theme() const;
    void setTheme(Theme theme);

    /// Of text and all that is drawn with it, one of kTextSizes_percent; from the program's start on.
    int textSize_percent() const;
    void setTextSize_percent(int percent);

    /// On a real rig, unless it was chosen otherwise.
    HornMode hornMode() const;
    void setHornMode(HornMode mode);

    /// One of Language::codes(); the desktop's language when it was never chosen.
    QString language() const;
    void setLanguage(const QString& code);

    /// Newest first.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();

    /// Whether the first five minutes were offered, and answered.
    bool isCoachAnswered() const;
    void setCoachAnswered();

    QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// Whose runs the Review page lists: where Bask records, unless another was chosen.
    QString sessionFolder() const;
    void setSessionFolder(const QString& folder);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

private:
    QSettings m_settings;
};

/// Where runs are recorded: AppLocalDataLocation/sessions, or BASK_SETTINGS_DIR/sessions.
QString recordingFolder();
/// Where unsaved edits are kept until they are saved: AppLocalDataLocation/unsaved, or
/// BASK_SETTINGS_DIR/unsaved.
QString unsavedFolder();
/// Where runs that are on are marked.
QString runMarkFolder();

} // namespace bask
