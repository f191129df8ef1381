#pragma once
// Bounds what is on its way to a thread that may not take it.

#include <cstddef>
#include <memory>
#include <vector>

namespace bask {

/// A queued signal keeps its arguments until it was delivered: one of them is a token that is counted here.
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
