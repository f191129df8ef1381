#pragma once
// Records the calls of one thread that go to a file system, by a filter of the kernel's: none is missed,
// whoever makes it.

#include <memory>
#include <string>
#include <vector>

namespace bask::test {

class FileCallWatch {
public:
    FileCallWatch();

    /// Watches the calling thread from now to the end of the process. Returns why it cannot, or an empty
    /// text.
    std::string watchThisThread();
    /// "openat /etc/localtime", since the last call of this.
    std::vector<std::string> take();

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared; ///< with a thread that stays: the filter of the kernel does
};

} // namespace bask::test
