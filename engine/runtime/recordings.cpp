#include "engine/runtime/recordings.h"

#include <thread>

namespace bask {

void Recordings::begin(const std::string& path, const Experiment& experiment, bool isSimulated,
                       double minDisk_MB, const RunLabels& labels, SessionRecorder::Earlier earlier) {
    m_beginning =
        std::make_unique<SessionRecorder>(path, experiment, isSimulated, minDisk_MB, labels, earlier);
}

std::optional<Result<void>> Recordings::made() const {
    return m_beginning ? m_beginning->made() : std::nullopt;
}

void Recordings::takeBegun() {
    m_current = std::move(m_beginning);
}

void Recordings::dropBegun() {
    if (m_beginning)
        m_beginning->finish("stopped"); // by a thread that nobody waits for, after the file was created
    m_beginning.reset();
}

Result<void> Recordings::add(LoopRecord rows) {
    if (!m_current)
        return {};
    auto added = m_current->add(std::move(rows));
    if (!added)
        m_current.reset();
    return added;
}

void Recordings::close(const std::string& outcome) {
    if (!m_current)
        return;
    m_current->finish(outcome.empty() ? "stopped" : outcome);
    m_ending.push_back(std::move(m_current));
}

std::vector<Error> Recordings::takeFailures() {
    std::vector<Error> failures;
    std::erase_if(m_ending, [&](const std::unique_ptr<SessionRecorder>& recorder) {
        const auto finished = recorder->finished();
        if (finished && !*finished)
            failures.push_back(finished->error());
        return finished.has_value();
    });
    return failures;
}

std::vector<std::string> Recordings::unsaved(std::chrono::milliseconds bound) const {
    const auto deadline = std::chrono::steady_clock::now() + bound;
    std::vector<std::string> out;
    for (const auto& recorder : m_ending) {
        auto finished = recorder->finished();
        while (!finished && std::chrono::steady_clock::now() < deadline) {
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
            finished = recorder->finished();
        }
        if (!finished || !*finished)
            out.push_back(recorder->path() +
                          (finished ? ": " + describe(finished->error()) : ": the disk does not answer"));
    }
    return out;
}

const SessionRecorder* Recordings::newest() const {
    if (m_current)
        return m_current.get();
    return m_ending.empty() ? nullptr : m_ending.back().get();
}

} // namespace bask
