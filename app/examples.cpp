#include "app/examples.h"

#include "engine/base/hidden_folder.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"

#include <QDirIterator>
#include <QFile>

#include <cerrno>
#include <cstring>

// Q_INIT_RESOURCE declares a function and must stand outside any namespace.
static void init() {
    Q_INIT_RESOURCE(examples);
}

namespace bask {
namespace {

const QString kFolder = QStringLiteral(":/examples");
const QString kRecipes = QStringLiteral(":/examples/recipes");
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

QStringList namesIn(const QString& folder) {
    init();
    QStringList names;
    for (const QString& file : QDir(folder).entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        names << file.chopped(5);
    return names;
}

} // namespace

QStringList exampleNames() {
    QStringList names = namesIn(kFolder);
    if (names.removeOne(kFirst))
        names.prepend(kFirst);
    return names;
}

Result<Experiment> readExample(const QString& name) {
    if (const QStringList known = exampleNames(); !known.contains(name))
        return Error(MessageCode::ValueUnknown, {},
                     {name.toStdString(), known.join(QStringLiteral(", ")).toStdString()});
    const auto folder = HiddenFolder::temporary();
    if (!folder)
        return folder.error();
    errno = 0;
    if (!unpack(QDir(QString::fromStdString(folder->path()))))
        return Error(MessageCode::FileUnwritable, folder->path(), {std::strerror(errno != 0 ? errno : EIO)});
    return readExperiment(folder->place(name.toStdString() + ".json"));
}

QStringList exampleRecipeNames() {
    return namesIn(kRecipes);
}

Result<Recipe> readExampleRecipe(const QString& name) {
    init();
    QFile file(kRecipes + u'/' + name + QStringLiteral(".json"));
    if (!file.open(QIODevice::ReadOnly))
        return Error(MessageCode::ValueUnknown, {},
                     {name.toStdString(), exampleRecipeNames().join(QStringLiteral(", ")).toStdString()});
    return recipeFromJson(file.readAll().toStdString(), {});
}

} // namespace bask
