#pragma once
// What the studies of `bask study` share: refusals in words and the folder that their files go to.

#include "app/commands/output_file.h"

#include <QString>
#include <QTemporaryDir>

#include <initializer_list>
#include <optional>

namespace bask {

/// Says on standard error why the study is not done; returns the exit code.
int refuseStudy(const Error& error);
int refuseStudy(const QString& words);

/// Copies files of the studies' own resources, for readers that want a file.
Result<void> copyStudyFiles(const QTemporaryDir& folder, std::initializer_list<const char*> names);

/// Makes the folder and returns one file in it for each ending ("stem.csv", "stem_time.png"). Nothing, and
/// words on standard error, when a file cannot be written or would replace one that does not hold `mark` near
/// its beginning.
std::optional<std::vector<OutputFile>> studyFiles(const QString& folder, const char* mark, const char* stem,
                                                  std::initializer_list<const char*> endings);

/// Writes each file, whole or not at all, and names it on standard error.
Result<void> writeStudyFiles(const std::vector<OutputFile>& files, const std::vector<std::string>& contents);

} // namespace bask
