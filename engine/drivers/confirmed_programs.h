#pragma once
// The programs that a person has allowed Bask to start on this computer, by their fingerprints.

#include <mutex>
#include <set>
#include <string>

namespace bask {

/// May be used on several threads.
class ConfirmedPrograms {
public:
    bool has(const std::string& hash) const {
        const std::lock_guard lock(m_mutex);
        return m_hashes.contains(hash);
    }
    void add(const std::string& hash) {
        const std::lock_guard lock(m_mutex);
        m_hashes.insert(hash);
    }

private:
    mutable std::mutex m_mutex;
    std::set<std::string> m_hashes;
};

} // namespace bask
