#pragma once
// The settings that Bask keeps between starts: recent files, units, theme, language, window positions.

#include "app/data_folder.h"
#include "app/horn.h"
#include "engine/base/units.h"
#include "widgets/common/file_folders.h"
#include "widgets/common/theme.h"
#include "widgets/plots/figure_format.h"

#include <QByteArray>
#include <QSettings>
#include <QStringList>

#include <array>

namespace bask {

/// An INI file in the user's configuration folder, or in the folder BASK_SETTINGS_DIR. Unknown values read as
/// the defaults.
class SettingsStore : public FileFolders {
public:
    static constexpr int kMaxRecent = 8;
    static constexpr std::array kTextSizes_percent{100, 125, 150, 200};

    SettingsStore();

    TemperatureUnit temperatureUnit() const;
    void setTemperatureUnit(TemperatureUnit unit);

    Theme theme() const;
    void setTheme(Theme theme);

    /// Size of text and of what is drawn with it, one of kTextSizes_percent; takes effect at the program's
    /// start.
    int textSize_percent() const;
    void setTextSize_percent(int percent);

    /// The horn sounds for a real rig, unless another mode was chosen.
    HornMode hornMode() const;
    void setHornMode(HornMode mode);

    /// One of Language::codes(); the desktop's language if none was chosen.
    QString language() const;
    void setLanguage(const QString& code);

    /// Recent files, the newest first.
    QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    void removeRecentFile(const QString& path);
    void clearRecentFiles();

    /// Whether the offer of the first five minutes was answered.
    bool isCoachAnswered() const;
    void setCoachAnswered();

    /// Names of operators that were used, the newest first.
    QStringList recentOperators() const;
    void addRecentOperator(const QString& name);
    /// Whether operator and sample are asked for before each run.
    bool asksLabels() const;
    void setAsksLabels(bool asks);

    /// Folder where a file of that kind was opened or saved last. Before the first, or where it is gone: that
    /// of experiments, else the documents.
    QString lastFolder(FileFolder kind) const override;
    void setLastFolder(FileFolder kind, const QString& folder) override;

    /// Folder whose runs the Review page lists: where Bask records, unless another was chosen.
    QString sessionFolder() const;
    void setSessionFolder(const QString& folder);
    /// What these runs are sorted by, a word of SessionList; empty if nothing was chosen.
    QString sessionSorting() const;
    void setSessionSorting(const QString& sorting);

    /// Size and heading of the last exported figure.
    FigureLayout figureLayout() const;
    void setFigureLayout(const FigureLayout& layout);

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);
    QByteArray largeNumbersGeometry() const;
    void setLargeNumbersGeometry(const QByteArray& geometry);
    /// Place of the window of a plot, by the plot's name.
    QByteArray plotWindowGeometry(const QString& plot) const;
    void setPlotWindowGeometry(const QString& plot, const QByteArray& geometry);

private:
    QSettings m_settings;
};

/// Folder where runs are recorded: AppLocalDataLocation/sessions, or BASK_SETTINGS_DIR/sessions.
QString recordingFolder();
/// Folder where unsaved edits are kept until they are saved: AppLocalDataLocation/unsaved, or
/// BASK_SETTINGS_DIR/unsaved.
QString unsavedFolder();
/// Folder of the marks of current runs.
QString runMarkFolder();

} // namespace bask
