#pragma once
// A folder that a subcommand fills with files.

#include "app/commands/output_file.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace bask {

/// Creates the folder and returns one file in it for each name. Returns nothing, and reports on standard
/// error in the subcommand's name, if a file cannot be written or would replace one without `mark` near its
/// beginning.
std::optional<std::vector<OutputFile>> filesIn(const QString& folder, const char* command, const char* mark,
                                               const QStringList& names);

/// Writes all files or none, and names them on standard error.
Result<void> writeFiles(const std::vector<OutputFile>& files, std::vector<std::string> contents);

} // namespace bask
