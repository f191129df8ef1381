// These functions, unlike those that replace them, cannot fail and read no configuration.
#define OPENSSL_SUPPRESS_DEPRECATED

#include "engine/recording/sha256.h"

#include <openssl/sha.h>

namespace bask {

struct Sha256::State {
    State() { SHA256_Init(&context); }
    SHA256_CTX context{};
};

Sha256::Sha256() : m_state(std::make_unique<State>()) {}
Sha256::~Sha256() = default;

void Sha256::add(const void* bytes, std::size_t size) {
    SHA256_Update(&m_state->context, bytes, size);
}

Digest Sha256::take() {
    Digest digest;
    SHA256_Final(digest.data(), &m_state->context);
    SHA256_Init(&m_state->context);
    return digest;
}

} // namespace bask
