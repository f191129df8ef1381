#pragma once
// Writes several files into a folder together or not at all.

#include "engine/base/hidden_folder.h"
#include "engine/base/result.h"
#include "engine/base/unfinished.h"

#include <string>
#include <vector>

namespace bask {

/// Files are written into a hidden folder beside the target and moved there by commit(). Files that were not
/// moved are deleted by the destructor.
class StagedFiles {
public:
    /// Creates the folder if it does not exist, and deletes what killed processes left in it. Error:
    /// FileUnwritable.
    static Result<StagedFiles> into(const std::string& folder);

    /// Returns the path to write a file that will be `name` ("outlines/0001.vtp") in the folder; commit()
    /// uses the same order.
    Result<std::string> place(const std::string& name);
    /// Writes a file with these contents.
    Result<void> write(const std::string& name, const std::string& contents);
    /// Returns the names so far.
    const std::vector<std::string>& names() const { return m_names; }
    /// Returns the path of a file that was written, until commit().
    std::string staged(const std::string& name) const;
    /// Returns the final path of a file.
    std::string target(const std::string& name) const;
    /// Moves all files and returns their paths. Error: FileUnwritable; then nothing has changed.
    Result<std::vector<std::string>> commit();

private:
    StagedFiles(std::string folder, std::vector<Unfinished> made, HiddenFolder stage);

    std::string m_folder;
    std::vector<Unfinished> m_made; ///< the folder and those above it, if they were created here
    HiddenFolder m_stage;
    std::vector<std::string> m_names;
};

} // namespace bask
