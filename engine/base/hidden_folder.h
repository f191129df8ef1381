#pragma once
// Hidden folders for files on their way: those that are not finished yet, and old ones until the new ones are
// there. What a killed process left of them is found and cleared.

#include "engine/base/result.h"
#include "engine/base/unfinished.h"

#include <optional>
#include <string>

namespace bask {

/// A folder ".bask-PURPOSE-HOST-PROCESS-NUMBER" in another one. Its process keeps it locked, so that one
/// which can be locked was left by a process that was killed. The destructor deletes it with its contents.
class HiddenFolder {
public:
    enum class Purpose {
        Part,   ///< files that are not finished; deleted also when a signal ends the program
        Export, ///< the same, of several files that come together
        Old     ///< files about to be replaced
    };
    /// Makes one in `folder`, which must be there; the first time that this process makes one there, it
    /// clears what killed processes left. Error: FileUnwritable, of `folder`.
    static Result<HiddenFolder> in(const std::string& folder, Purpose purpose = Purpose::Part);
    /// Makes one in the system's folder for temporary files.
    static Result<HiddenFolder> temporary();
    HiddenFolder(HiddenFolder&& other) noexcept;
    HiddenFolder& operator=(HiddenFolder&&) = delete;
    ~HiddenFolder();

    const std::string& path() const { return m_path; }
    /// Returns the path in it of the file `name`.
    std::string place(const std::string& name) const { return m_path + '/' + name; }

private:
    HiddenFolder(std::string path, Purpose purpose, int lock);

    std::string m_path; ///< empty: moved from
    int m_lock = -1;    ///< descriptor that holds the lock
    std::optional<Unfinished> m_unfinished;
};

/// Deletes the hidden folders of killed processes of this computer in `folder`. An old file in one goes back
/// to its place if nothing is there.
void clearLeft(const std::string& folder);

/// Returns the file that a path names, through symbolic links, also if it is not there yet.
std::string behindLinks(const std::string& path);
/// Returns the folder of a file; "." for a name alone.
std::string folderOfFile(const std::string& file);

} // namespace bask
