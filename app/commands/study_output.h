#pragma once
// What the subcommands share that write a folder of figures and tables: their own input files, refusals in
// words, and the folder.

#include "app/commands/output_file.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace bask {

/// Reports on standard error why the study is not done; returns the exit code.
int refuseStudy(const Error& error);
int refuseStudy(const QString& words);

/// Returns the names of the files in a folder of the studies' own resources.
QStringList studyResources(const QString& below);
/// Copies files of the studies' own resources, for readers that want a file.
Result<void> copyStudyFiles(const QString& folder, const QStringList& names);

/// Creates the folder and returns one file in it for each name. Returns nothing, and reports on standard
/// error in the subcommand's name, if a file cannot be written or would replace one without `mark` near its
/// beginning.
std::optional<std::vector<OutputFile>> filesIn(const QString& folder, const char* command, const char* mark,
                                               const QStringList& names);
/// The same for `bask study`, for each ending: "stem.csv", "stem_time.png".
std::optional<std::vector<OutputFile>> studyFiles(const QString& folder, const char* mark, const char* stem,
                                                  const QStringList& endings);

/// Writes all files or none, and names them on standard error.
Result<void> writeStudyFiles(const std::vector<OutputFile>& files, const std::vector<std::string>& contents);

} // namespace bask
