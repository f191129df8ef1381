#pragma once
// What the subcommands share that write a folder of figures and tables: their own input files, refusals in
// words, and the folder.

#include "app/commands/output_folder.h"

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

/// The files of a study: "stem.csv", "stem_time.png".
struct StudyNames {
    const char* stem;
    const char* mark; ///< in each of them, near its beginning: what holds it may be replaced
    QStringList endings;
};

/// As filesIn() for the subcommand.
std::optional<std::vector<OutputFile>> studyFiles(const char* command, const QString& folder,
                                                  const StudyNames& names);

} // namespace bask
