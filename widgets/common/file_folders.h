#pragma once
// Dialogs for files, which begin in the folder last used for that kind of file.

#include <QString>

class QWidget;

namespace bask {

/// Kinds of files that are kept at different places: experiments, rigs and recipes; recordings; what is
/// written for others; outlines, cameras and profiles of other programs.
enum class FileFolder { Experiments, Recordings, Exports, Imports };

/// Keeps these folders between starts.
class FileFolders {
public:
    FileFolders() = default;
    FileFolders(const FileFolders&) = delete;
    FileFolders& operator=(const FileFolders&) = delete;
    virtual ~FileFolders() = default;
    /// Folder where a file of that kind was opened or saved last.
    virtual QString lastFolder(FileFolder kind) const = 0;
    virtual void setLastFolder(FileFolder kind, const QString& folder) = 0;
};

/// Those that the dialogs below use, on the GUI thread; null, as at first: each begins in the current folder.
void setFileFolders(FileFolders* folders);

/// Whether it is the name of a session, *.bask.
bool isSessionFile(const QString& path);

/// Keeps the folder of a chosen file, or a chosen folder, for the next dialog, and returns the path; a
/// session is kept with the recordings, whatever was asked for. Does nothing with an empty one.
QString remembered(QString path, FileFolder kind);

/// Whether the dialog itself asks if a file is to be replaced.
enum class Replacing { Asked, NotAsked };

/// Each is empty if it was cancelled. `name` is the file's, in the folder last used unless it has one of its
/// own; `filter` is told which was chosen; `from` stands for the folder last used.
QString askFileToOpen(QWidget* parent, const QString& title, const QString& filters, FileFolder kind,
                      const QString& from = {});
QString askFileToSave(QWidget* parent, const QString& title, const QString& name, const QString& filters,
                      FileFolder kind, QString* filter = nullptr, Replacing replacing = Replacing::Asked);
QString askFolder(QWidget* parent, const QString& title, FileFolder kind, const QString& from = {});

} // namespace bask
