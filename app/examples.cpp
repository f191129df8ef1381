#include "app/examples.h"

#include "engine/base/message_code.h"

#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>

namespace bask {
namespace {

const QString kFolder = QStringLiteral(":/examples");
const QString kFirst = QStringLiteral("three-objects");

bool unpack(const QDir& to) {
    QDirIterator files(kFolder, QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        const QString from = files.next();
        const QString target = to.filePath(from.mid(kFolder.size() + 1));
        if (!QDir().mkpath(QFileInfo(target).path()) || !QFile::copy(from, target))
            return false;
    }
    return true;
}

} // namespace

QStringList exampleNames() {
    QStringList names;
    for (const QString& file : QDir(kFolder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        names << file.chopped(5);
    if (names.removeOne(kFirst))
        names.prepend(kFirst);
    return names;
}

Result<Experiment> readExample(const QString& name) {
    const QTemporaryDir folder;
    if (!folder.isValid() || !unpack(QDir(folder.path())))
        return Error(MessageCode::FileUnwritable, folder.path().toStdString(),
                     {folder.errorString().toStdString()});
    return readExperiment(folder.filePath(name + QStringLiteral(".json")).toStdString());
}

} // namespace bask
