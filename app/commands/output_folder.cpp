#include "app/commands/output_folder.h"

#include "app/commands/parse_command.h"
#include "engine/base/message_code.h"
#include "engine/base/unfinished.h"
#include "engine/base/whole_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <cstdio>
#include <utility>

namespace bask {
namespace {

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

Result<void> writeFiles(const std::vector<OutputFile>& files, std::vector<std::string> contents) {
    std::vector<WholeFile> whole;
    for (std::size_t i = 0; i < files.size(); ++i)
        whole.push_back({files[i].path, std::move(contents[i])});
    auto written = writeWholeFiles(whole);
    if (!written)
        return written;
    for (const OutputFile& file : files)
        std::fprintf(stderr, "wrote %s\n", file.path.c_str());
    return {};
}

} // namespace bask
