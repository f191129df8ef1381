#pragma once
// SHA-256 by the instructions that the processor has for it.

#include <array>
#include <cstddef>
#include <memory>

namespace bask {

using Digest = std::array<unsigned char, 32>;

class Sha256 {
public:
    Sha256();
    ~Sha256();
    void add(const void* bytes, std::size_t size);
    /// Returns the hash of what was added, and begins anew.
    Digest take();

    Sha256(const Sha256&) = delete;
    Sha256& operator=(const Sha256&) = delete;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace bask
