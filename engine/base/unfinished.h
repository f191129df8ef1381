#pragma once
// Files that are there only while work is under way: deleted when it fails, and when a signal ends the
// program.

#include <string>
#include <system_error>
#include <vector>

namespace bask {

/// A file, or a folder with all that is in it, which the destructor deletes unless it was kept.
class Unfinished {
public:
    enum class What {
        All,        ///< the file, or the folder with its contents
        EmptyFolder ///< the folder, if nothing is in it
    };
    /// The path may not exist yet.
    explicit Unfinished(std::string path, What what = What::All);
    Unfinished(Unfinished&& other) noexcept;
    Unfinished& operator=(Unfinished&&) = delete;
    ~Unfinished();

    const std::string& path() const { return m_path; }
    void keep();

private:
    std::string m_path; ///< empty: kept, or moved from
    What m_what;
};

/// While one lives, a signal waits: for steps that are done together or not at all. Short ones only. It ends
/// on the thread that began it; one inside of another changes nothing.
class Uninterrupted {
public:
    Uninterrupted();
    ~Uninterrupted();
    Uninterrupted(const Uninterrupted&) = delete;
    Uninterrupted& operator=(const Uninterrupted&) = delete;
};

/// Makes a folder and those above it. Returns those that were not there, innermost first: they are deleted at
/// the end of their lives if nothing is in them. `failed` says why not; then nothing is returned.
std::vector<Unfinished> makeFolders(const std::string& path, std::error_code& failed);

/// From now on SIGINT, SIGTERM and SIGHUP delete what is unfinished before they end the program, which they
/// do as ever: a shell sees 130, 143 or 129. Call it once, before other threads are there; who sets handlers
/// of its own later keeps them.
void deleteUnfinishedOnSignals();

} // namespace bask
