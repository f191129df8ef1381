#pragma once
// A busy machine.

#include <atomic>
#include <thread>
#include <vector>

namespace bask::test {

/// Busy threads, which take what the processors have.
class Hogs {
public:
    explicit Hogs(int count) {
        for (int i = 0; i < count; ++i)
            m_threads.emplace_back([this] {
                while (!m_isOver)
                    ;
            });
    }
    ~Hogs() {
        m_isOver = true;
        for (std::thread& thread : m_threads)
            thread.join();
    }

private:
    std::atomic<bool> m_isOver = false;
    std::vector<std::thread> m_threads;
};

} // namespace bask::test
