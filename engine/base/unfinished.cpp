#include "engine/base/unfinished.h"

#include "engine/base/thread_name.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <shared_mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace bask {
namespace {

namespace fs = std::filesystem;

constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
constexpr std::chrono::seconds kPatience{5}; // for steps that are not interrupted

struct Entry {
    std::string path;
    Unfinished::What what;
    bool operator==(const Entry&) const = default;
};

/// Never destroyed: a signal may come during the program's end.
struct Registry {
    std::mutex mutex;
    std::vector<Entry> entries;
    std::shared_timed_mutex steps; ///< held shared by who must not be interrupted
};

Registry& registry() {
    static auto* const kInstance = new Registry;
    return *kInstance;
}

void remove(const Entry& entry) {
    std::error_code ignored;
    if (entry.what == Unfinished::What::EmptyFolder) {
        ::rmdir(entry.path.c_str()); // nothing but an empty folder, no link to one either
        return;
    }
    // Under another name first: a thread that still writes finds nothing under the old one.
    const std::string gone = entry.path + ".gone";
    fs::rename(entry.path, gone, ignored);
    fs::remove_all(ignored ? entry.path : gone, ignored);
}

void strike(const Entry& entry) {
    const std::lock_guard lock(registry().mutex);
    auto& entries = registry().entries;
    if (const auto found = std::find(entries.begin(), entries.end(), entry); found != entries.end())
        entries.erase(found);
}

thread_local int g_depth = 0; ///< of this thread's steps that must not be interrupted

std::array<int, 2> g_ends{-1, -1};

// Only what a handler may do.
void told(int signal) {
    const auto byte = static_cast<unsigned char>(signal);
    [[maybe_unused]] const ssize_t written = ::write(g_ends[1], &byte, 1);
}

[[noreturn]] void endBy(int signal) {
    Registry& all = registry();
    // Other threads wait from here on: none begins or ends anything.
    [[maybe_unused]] const bool isQuiet = all.steps.try_lock_for(kPatience);
    all.mutex.lock();
    // Contents before their folder.
    std::sort(all.entries.begin(), all.entries.end(),
              [](const Entry& a, const Entry& b) { return a.path.size() > b.path.size(); });
    for (const Entry& entry : all.entries)
        remove(entry);
    std::signal(signal, SIG_DFL);
    ::kill(::getpid(), signal);
    for (;;)
        ::pause();
}

} // namespace

Unfinished::Unfinished(std::string path, What what) : m_path(std::move(path)), m_what(what) {
    const std::lock_guard lock(registry().mutex);
    registry().entries.push_back({m_path, m_what});
}

Unfinished::Unfinished(Unfinished&& other) noexcept
    : m_path(std::exchange(other.m_path, {})), m_what(other.m_what) {}

Unfinished::~Unfinished() {
    if (m_path.empty())
        return;
    remove({m_path, m_what});
    strike({m_path, m_what});
}

void Unfinished::keep() {
    strike({m_path, m_what});
    m_path.clear();
}

std::vector<Unfinished> makeFolders(const std::string& path, std::error_code& failed) {
    std::vector<fs::path> missing;
    for (fs::path folder = fs::absolute(path, failed).lexically_normal();
         !failed && folder.has_relative_path() &&
         fs::symlink_status(folder, failed).type() == fs::file_type::not_found;
         folder = folder.parent_path()) {
        failed.clear();
        if (folder.has_filename())
            missing.push_back(folder);
    }
    failed.clear();
    std::vector<Unfinished> made;
    const Uninterrupted together;
    fs::create_directories(path, failed);
    if (!failed && !fs::is_directory(path, failed))
        failed = std::make_error_code(std::errc::not_a_directory);
    if (!failed)
        for (const fs::path& folder : missing)
            made.emplace_back(folder.string(), Unfinished::What::EmptyFolder);
    return made;
}

Uninterrupted::Uninterrupted() {
    if (g_depth++ == 0)
        registry().steps.lock_shared();
}

Uninterrupted::~Uninterrupted() {
    if (--g_depth == 0)
        registry().steps.unlock_shared();
}

void deleteUnfinishedOnSignals() {
    if (::pipe2(g_ends.data(), O_CLOEXEC) != 0)
        return; // the signals then end the program at once
    std::thread([] {
        nameThread("end signals");
        unsigned char signal = 0;
        while (::read(g_ends[0], &signal, 1) == 1)
            endBy(signal);
    }).detach();
    struct sigaction action {};
    action.sa_handler = told;
    action.sa_flags = SA_RESTART;
    for (const int each : kSignals) {
        struct sigaction before {};
        ::sigaction(each, nullptr, &before);
        if (before.sa_handler != SIG_IGN) // as under nohup
            ::sigaction(each, &action, nullptr);
    }
}

} // namespace bask
