#include "app/studies/study_output.h"

#include "app/commands/parse_command.h"
#include "engine/base/message_code.h"

#include <QDir>
#include <QFile>

// Q_INIT_RESOURCE declares a function and must stand outside any namespace.
static void initStudyResources() {
    Q_INIT_RESOURCE(study);
    Q_INIT_RESOURCE(study_rigs);
}

namespace bask {
namespace {

const QString kResources = QStringLiteral(":/study/");

} // namespace

int refuseStudy(const Error& error) {
    return refuse("study", error);
}

int refuseStudy(const QString& words) {
    return refuse("study", words);
}

QStringList studyResources(const QString& below) {
    initStudyResources();
    return QDir(kResources + below).entryList(QDir::Files, QDir::Name);
}

Result<void> copyStudyFiles(const QString& folder, const QStringList& names) {
    initStudyResources();
    for (const QString& name : names) {
        const QString file = QDir(folder).filePath(name);
        QFile resource(kResources + name);
        if (!QDir().mkpath(QFileInfo(file).path()) || !resource.copy(file))
            return Error(MessageCode::FileUnwritable, file.toStdString(),
                         {resource.errorString().toStdString()});
    }
    return {};
}

std::optional<std::vector<OutputFile>> studyFiles(const char* command, const QString& folder,
                                                  const StudyNames& names) {
    QStringList files;
    for (const QString& ending : names.endings)
        files << QLatin1String(names.stem) + ending;
    return filesIn(folder, command, names.mark, files);
}

} // namespace bask
