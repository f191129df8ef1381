#pragma once
// The common thread pool while much is computed: nothing that is asked of it begins.

#include <QSemaphore>
#include <QThreadPool>

#include <memory>

namespace bask::test {

/// Until release(), or its end.
class HeldPool {
public:
    HeldPool() {
        for (int k = 0; k < m_threads; ++k)
            QThreadPool::globalInstance()->start([go = m_go] { go->acquire(); });
    }
    ~HeldPool() { release(); }
    HeldPool(const HeldPool&) = delete;
    HeldPool& operator=(const HeldPool&) = delete;

    void release() { m_go->release(m_threads); }

private:
    const int m_threads = QThreadPool::globalInstance()->maxThreadCount();
    const std::shared_ptr<QSemaphore> m_go = std::make_shared<QSemaphore>();
};

} // namespace bask::test
