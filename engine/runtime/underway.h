#pragma once
// Limits the number of queued signals to a thread that may not process them.

#include <cstddef>
#include <memory>
#include <vector>

namespace bask {

/// A queued signal keeps its arguments until it is delivered. One of them is a token, and this class counts
/// the tokens that still exist.
class Underway {
public:
    static constexpr std::size_t kMax = 2;

    bool isFull() {
        std::erase_if(m_tokens, [](const auto& token) { return token.expired(); });
        return m_tokens.size() >= kMax;
    }
    std::shared_ptr<const int> next() {
        auto token = std::make_shared<const int>(0);
        m_tokens.push_back(token);
        return token;
    }

private:
    std::vector<std::weak_ptr<const int>> m_tokens;
};

} // namespace bask
