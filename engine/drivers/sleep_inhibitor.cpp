#include "engine/drivers/sleep_inhibitor.h"

#include "engine/base/program_part.h"

#include <QThreadPool>

#include <mutex>
#include <unistd.h>
#include <utility>

namespace bask {
namespace {

/// What logind gave, or why it did not.
struct Answer {
    int descriptor = -1; ///< as long as it is open, the computer stays awake
    std::string problem;

    Answer() = default;
    Answer(Answer&& other) noexcept { *this = std::move(other); }
    Answer& operator=(Answer&& other) noexcept {
        std::swap(descriptor, other.descriptor);
        std::swap(problem, other.problem);
        return *this;
    }
    ~Answer() {
        if (descriptor >= 0)
            ::close(descriptor);
    }
};

/// By the module that has D-Bus, which a rig without heat does not load.
Answer ask(const std::string& bus) {
    Answer out;
    void* const found = moduleFunction("bask-sleep.so", BASK_MODULES_BUILT, "baskStayAwake", out.problem);
    if (found != nullptr)
        out.descriptor = reinterpret_cast<int (*)(const std::string&, std::string&)>(found)(bus, out.problem);
    return out;
}

} // namespace

struct SleepInhibitor::Lock {
    mutable std::mutex mutex;
    bool isAsking = false, isWanted = false;
    Answer answer;

    /// On another thread, once at a time.
    static void work(const std::shared_ptr<Lock>& lock, const std::string& bus) {
        Answer answer = ask(bus);
        const std::lock_guard guard(lock->mutex);
        lock->isAsking = false;
        lock->answer = lock->isWanted ? std::move(answer) : Answer();
    }
};

SleepInhibitor::SleepInhibitor(std::string bus) : m_lock(std::make_shared<Lock>()), m_bus(std::move(bus)) {}

SleepInhibitor::~SleepInhibitor() {
    keepAwake(false);
}

void SleepInhibitor::keepAwake(bool isWanted) {
    if (isWanted == m_isWanted)
        return;
    m_isWanted = isWanted;
    const std::lock_guard guard(m_lock->mutex);
    m_lock->isWanted = isWanted;
    m_lock->answer = {};
    if (!isWanted || m_lock->isAsking)
        return;
    m_lock->isAsking = true;
    QThreadPool::globalInstance()->start([lock = m_lock, bus = m_bus] { Lock::work(lock, bus); });
}

bool SleepInhibitor::isKept() const {
    const std::lock_guard guard(m_lock->mutex);
    return m_lock->answer.descriptor >= 0;
}

std::string SleepInhibitor::problem() const {
    const std::lock_guard guard(m_lock->mutex);
    return m_lock->answer.problem;
}

} // namespace bask
