#include "widgets/common/file_folders.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace bask {
namespace {

FileFolders* fileFolders = nullptr;

/// `from`, or the folder last used.
QString begin(FileFolder kind, const QString& from = {}) {
    return !from.isEmpty() || fileFolders == nullptr ? from : fileFolders->lastFolder(kind);
}

} // namespace

void setFileFolders(FileFolders* folders) {
    fileFolders = folders;
}

bool isSessionFile(const QString& path) {
    return QFileInfo(path).suffix().compare(QLatin1String("bask"), Qt::CaseInsensitive) == 0;
}

QString remembered(QString path, FileFolder kind) {
    if (fileFolders == nullptr || path.isEmpty())
        return path;
    const QFileInfo file(path);
    const bool isFolder = file.isDir();
    fileFolders->setLastFolder(!isFolder && isSessionFile(path) ? FileFolder::Recordings : kind,
                               isFolder ? path : file.absolutePath());
    return path;
}

QString askFileToOpen(QWidget* parent, const QString& title, const QString& filters, FileFolder kind,
                      const QString& from) {
    return remembered(QFileDialog::getOpenFileName(parent, title, begin(kind, from), filters), kind);
}

QString askFileToSave(QWidget* parent, const QString& title, const QString& name, const QString& filters,
                      FileFolder kind, QString* filter, Replacing replacing) {
    const QString proposed = QDir(begin(kind)).filePath(name);
    const QFileDialog::Options options =
        replacing == Replacing::NotAsked ? QFileDialog::DontConfirmOverwrite : QFileDialog::Options();
    return remembered(QFileDialog::getSaveFileName(parent, title, proposed, filters, filter, options), kind);
}

QString askFolder(QWidget* parent, const QString& title, FileFolder kind, const QString& from) {
    return remembered(QFileDialog::getExistingDirectory(parent, title, begin(kind, from)), kind);
}

} // namespace bask
