#pragma once
// A call of the system that takes as long as a test likes, as a disk or a driver that hangs makes it.

#include <cstdint>
#include <memory>
#include <string>

namespace bask::test {

class HeldCalls {
public:
    struct Which {
        int number = 0;          ///< of the call
        int place = -1;          ///< of an argument; -1: whatever they are
        std::uint32_t value = 0; ///< which it is to have there
    };

    HeldCalls();
    ~HeldCalls();

    /// Of the calling thread, and of each thread and process that it begins from now on: for ever. Returns
    /// why it cannot be, or an empty text.
    std::string begin(Which which);
    /// Those calls hang from now to release(), or for ten seconds.
    void hold();
    void release();
    /// So many have hung so far.
    int held() const;

private:
    struct Shared;
    std::shared_ptr<Shared> m_shared; ///< with a thread that stays: the filter of the kernel does
};

} // namespace bask::test
