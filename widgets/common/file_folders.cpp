#include "widgets/common/file_folders.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <utility>

namespace bask {
namespace {

FileFolders* fileFolders = nullptr;

QString begin(FileFolder kind) {
    return fileFolders == nullptr ? QString() : fileFolders->lastFolder(kind);
}

} // namespace

void setFileFolders(FileFolders* folders) {
    fileFolders = folders;
}

QString remembered(QString path, FileFolder kind) {
    if (fileFolders == nullptr || path.isEmpty())
        return path;
    const QFileInfo file(path);
    const bool isFolder = file.isDir();
    const bool isSession =
        !isFolder && file.suffix().compare(QLatin1String("bask"), Qt::CaseInsensitive) == 0;
    fileFolders->setLastFolder(isSession ? FileFolder::Recordings : kind,
                               isFolder ? path : file.absolutePath());
    return path;
}

QString askFileToOpen(QWidget* parent, const QString& title, const QString& filters, FileFolder kind) {
    return remembered(QFileDialog::getOpenFileName(parent, title, begin(kind), filters), kind);
}

QString askFileToSave(QWidget* parent, const QString& title, const QString& name, const QString& filters,
                      FileFolder kind, QString* filter) {
    const QString proposed = QDir(begin(kind)).filePath(name);
    return remembered(QFileDialog::getSaveFileName(parent, title, proposed, filters, filter), kind);
}

QString askFolder(QWidget* parent, const QString& title, FileFolder kind, const QString& from) {
    return remembered(QFileDialog::getExistingDirectory(parent, title, from.isEmpty() ? begin(kind) : from),
                      kind);
}

} // namespace bask
