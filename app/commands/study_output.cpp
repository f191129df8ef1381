#include "app/commands/study_output.h"

#include "app/commands/parse_command.h"
#include "engine/base/message_code.h"
#include "engine/base/replaced_files.h"
#include "engine/base/unfinished.h"
#include "engine/experiment/text_file.h"

#include <QDir>
#include <QFile>

#include <cstdio>

// Q_INIT_RESOURCE declares a function and must stand outside any namespace.
static void initStudyResources() {
    Q_INIT_RESOURCE(study);
}

namespace bask {
namespace {

const QString kResources = QStringLiteral(":/study/");

/// Makes the folder if it is not there. Returns what is wrong with it, in words.
QString makeFolder(const QString& folder) {
    const QFileInfo info(folder);
    if (info.exists() && !info.isDir())
        return QStringLiteral("%1 is a file, not a folder; choose another name").arg(folder);
    // A study that fails, or that a signal ends, leaves no empty folder.
    static std::vector<Unfinished> made;
    std::error_code failed;
    for (Unfinished& each : makeFolders(folder.toStdString(), failed))
        made.push_back(std::move(each));
    if (failed)
        return QStringLiteral("the folder %1 cannot be made (%2); choose another place")
            .arg(folder, QString::fromStdString(failed.message()));
    return {};
}

/// Refuses to replace what is no part of a study.
Result<void> checkReplaced(const std::vector<OutputFile>& files, const char* mark) {
    for (const OutputFile& file : files) {
        QFile old(QString::fromStdString(file.path));
        if (old.exists() && old.size() > 0 &&
            (!old.open(QIODevice::ReadOnly) || !old.read(1024).contains(mark)))
            return Error(MessageCode::OutputForeign, file.path, {"part of a report written by Bask"});
    }
    return {};
}

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

std::optional<std::vector<OutputFile>> filesIn(const QString& folder, const char* command, const char* mark,
                                               const QStringList& names) {
    if (const QString wrong = makeFolder(folder); !wrong.isEmpty()) {
        refuse(command, wrong);
        return std::nullopt;
    }
    std::vector<OutputFile> files;
    for (const QString& name : names)
        files.push_back({QDir(folder).filePath(name).toStdString()});
    auto place = checkOutputs({}, files);
    if (place)
        place = checkReplaced(files, mark);
    if (!place) {
        refuse(command, place.error());
        return std::nullopt;
    }
    return files;
}

std::optional<std::vector<OutputFile>> studyFiles(const QString& folder, const char* mark, const char* stem,
                                                  const QStringList& endings) {
    QStringList names;
    for (const QString& ending : endings)
        names << QLatin1String(stem) + ending;
    return filesIn(folder, "study", mark, names);
}

Result<void> writeStudyFiles(const std::vector<OutputFile>& files, const std::vector<std::string>& contents) {
    ReplacedFiles replaced;
    for (std::size_t i = 0; i < files.size(); ++i) {
        auto written = replaced.setAside(files[i].path);
        if (written)
            written = writeTextFile(files[i].path, contents[i]);
        if (!written)
            return written;
    }
    replaced.keepNew();
    for (const OutputFile& file : files)
        std::fprintf(stderr, "wrote %s\n", file.path.c_str());
    return {};
}

} // namespace bask
