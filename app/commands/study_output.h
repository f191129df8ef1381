#pragma once
// What the subcommands that write a folder of figures and tables share: their own input files, refusals in
// words, and the folder.

#include "app/commands/output_file.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace bask {

/// Says on standard error why the study is not done; returns the exit code.
int refuseStudy(const Error& error);
int refuseStudy(const QString& words);
int refuse(const char* command, const Error& error);
int refuse(const char* command, const QString& words);

/// Names of the files in a folder of the studies' own resources.
QStringList studyResources(const QString& below);
/// Copies files of the studies' own resources, for readers that want a file.
Result<void> copyStudyFiles(const QString& folder, const QStringList& names);

/// Makes the folder and returns one file in it for each name. Nothing, and words on standard error in the
/// subcommand's name, when a file cannot be written or would replace one that does not hold `mark` near its
/// beginning.
std::optional<std::vector<OutputFile>> filesIn(const QString& folder, const char* command, const char* mark,
                                               const QStringList& names);
/// The same for `bask study`, for each ending: "stem.csv", "stem_time.png".
std::optional<std::vector<OutputFile>> studyFiles(const QString& folder, const char* mark, const char* stem,
                                                  const QStringList& endings);

/// Writes each file, whole or not at all, and names it on standard error.
Result<void> writeStudyFiles(const std::vector<OutputFile>& files, const std::vector<std::string>& contents);

} // namespace bask
