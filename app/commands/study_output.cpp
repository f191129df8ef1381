#include "app/commands/study_output.h"

#include "app/commands/command_line.h"

#include <QDir>
#include <QFile>

#include <cstdio>

// Q_INIT_RESOURCE declares a function and must stand outside any namespace.
static void initStudyResources() {
    Q_INIT_RESOURCE(study);
}

namespace bask {
namespace {

/// Makes the folder if it is not there. Returns what is wrong with it, in words.
QString makeFolder(const QString& folder) {
    const QFileInfo info(folder);
    if (info.exists() && !info.isDir())
        return QStringLiteral("%1 is a file, not a folder; choose another name").arg(folder);
    if (!QDir().mkpath(folder))
        return QStringLiteral("the folder %1 cannot be made; choose another place").arg(folder);
    return {};
}

/// Refuses to replace what is no part of a study.
Result<void> checkReplaced(const std::vector<OutputFile>& files, const char* mark) {
    for (const OutputFile& file : files) {
        QFile old(QString::fromStdString(file.path));
        if (old.exists() && old.size() > 0 &&
            (!old.open(QIODevice::ReadOnly) || !old.read(1024).contains(mark)))
            return Error(MessageCode::OutputForeign, file.path, {"part of a study written by Bask"});
    }
    return {};
}

} // namespace

int refuseStudy(const Error& error) {
    std::fprintf(stderr, "bask study: %s\n", describe(error).c_str());
    return kExitBadInput;
}

int refuseStudy(const QString& words) {
    std::fprintf(stderr, "bask study: %s (see bask study --help)\n", qPrintable(words));
    return kExitBadInput;
}

Result<void> copyStudyFiles(const QTemporaryDir& folder, std::initializer_list<const char*> names) {
    initStudyResources();
    for (const char* name : names) {
        const QString file = folder.filePath(QLatin1String(name));
        if (!QDir().mkpath(QFileInfo(file).path()) ||
            !QFile::copy(QLatin1String(":/study/") + QLatin1String(name), file))
            return Error(MessageCode::FileUnwritable, file.toStdString(),
                         {folder.errorString().toStdString()});
    }
    return {};
}

std::optional<std::vector<OutputFile>> studyFiles(const QString& folder, const char* mark, const char* stem,
                                                  std::initializer_list<const char*> endings) {
    if (const QString wrong = makeFolder(folder); !wrong.isEmpty()) {
        refuseStudy(wrong);
        return std::nullopt;
    }
    std::vector<OutputFile> files;
    for (const char* ending : endings)
        files.push_back({QDir(folder).filePath(QLatin1String(stem) + QLatin1String(ending)).toStdString()});
    auto place = checkOutputs({}, files);
    if (place)
        place = checkReplaced(files, mark);
    if (!place) {
        refuseStudy(place.error());
        return std::nullopt;
    }
    return files;
}

Result<void> writeStudyFiles(const std::vector<OutputFile>& files, const std::vector<std::string>& contents) {
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (auto written = writeOutput(files[i].path, contents[i]); !written)
            return written;
        std::fprintf(stderr, "wrote %s\n", files[i].path.c_str());
    }
    return {};
}

} // namespace bask
