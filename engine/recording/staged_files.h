#pragma once
// Several files that come into a folder together or not at all.

#include "engine/base/result.h"

#include <string>
#include <vector>

namespace bask {

/// Files are written into a hidden folder beside their places and moved there by commit(). Whatever was not
/// moved goes when this ends.
class StagedFiles {
public:
    /// Makes the folder where it is not there. Error: FileUnwritable.
    static Result<StagedFiles> into(const std::string& folder);
    StagedFiles(StagedFiles&& other) noexcept;
    StagedFiles& operator=(StagedFiles&&) = delete;
    ~StagedFiles();

    /// Where to write a file that will be `name` ("outlines/0001.vtp") in the folder, in the order of
    /// commit().
    Result<std::string> place(const std::string& name);
    /// Writes one with these contents.
    Result<void> write(const std::string& name, const std::string& contents);
    /// Its path when all is done.
    std::string target(const std::string& name) const;
    /// Moves all; their paths. Error: FileUnwritable; then all is as it was.
    Result<std::vector<std::string>> commit();

private:
    StagedFiles(std::string folder, std::string stage, bool isNew);

    std::string m_folder, m_stage; ///< m_stage empty: moved from
    bool m_isNew = false;          ///< the folder was made here
    std::vector<std::string> m_names;
};

/// Letters, digits, '-' and '_' as they are, "_" for the rest: part of a file's name.
std::string plainFileName(const std::string& name);

} // namespace bask
