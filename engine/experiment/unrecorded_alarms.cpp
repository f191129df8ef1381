#include "engine/experiment/unrecorded_alarms.h"

#include "engine/base/json_fields.h"
#include "engine/experiment/text_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

using nlohmann::json;

constexpr double kYear9999_s = 253'370'764'800.0;

const std::map<std::string, AlarmChange>& changeWords() {
    static const std::map<std::string, AlarmChange> kWords{{"raised", AlarmChange::Raised},
                                                           {"over", AlarmChange::Over},
                                                           {"acknowledged", AlarmChange::Acknowledged}};
    return kWords;
}

std::string changeWord(AlarmChange change) {
    return std::ranges::find(changeWords(), change, [](const auto& each) { return each.second; })->first;
}

std::string changeLine(const UnrecordedChange& change) {
    const nlohmann::ordered_json line{{"utc_s", change.utc_s},
                                      {"event", changeWord(change.change)},
                                      {"priority", change.priority},
                                      {"key", change.key},
                                      {"message", messageName(change.message.code)},
                                      {"args", argTexts(change.message)},
                                      {"raised_s", change.raised_s},
                                      {"live", change.isLive},
                                      {"operator", change.operatorName}};
    return line.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
}

bool isDate(double utc_s) {
    return utc_s >= 0.0 && utc_s < kYear9999_s;
}

Result<UnrecordedChange> readChange(const std::string& line, const std::string& path) {
    auto read = readJsonText<UnrecordedChange>(
        line, path, [](const json& j, Failure& failure, UnrecordedChange& change) {
            std::string code;
            Fields fields(j, {}, failure);
            fields.read("utc_s", change.utc_s, true);
            fields.readWord("event", changeWords(), change.change, true);
            fields.read("priority", change.priority, true);
            fields.read("key", change.key, true);
            fields.read("message", code, true);
            fields.read("raised_s", change.raised_s, true);
            fields.read("live", change.isLive);
            fields.read("operator", change.operatorName);
            if (const json* args = fields.find("args"); args != nullptr && args->is_array())
                for (const json& arg : *args)
                    change.message.args.emplace_back(arg.is_string() ? arg.get<std::string>()
                                                                     : std::string());
            fields.close(Fields::Unknown::Ignored);
            change.message.code = messageCodeFromName(code);
        });
    if (read && (read->message.code == MessageCode::None || !isDate(read->utc_s) || !isDate(read->raised_s)))
        return Error(MessageCode::FileUnreadable, path, {plainWords(line)});
    return read;
}

/// The last whole lines of a file, of at most `max` bytes together.
Result<std::string> newestLines(const std::string& path, std::uintmax_t max) {
    std::error_code code;
    const auto status = std::filesystem::status(path, code);
    if (!std::filesystem::exists(status))
        return std::string();
    std::ifstream file;
    if (std::filesystem::is_regular_file(status))
        file.open(path, std::ios::binary | std::ios::ate);
    if (!file.is_open())
        return Error(MessageCode::FileUnreadable, path, {"access refused"});
    const auto size = static_cast<std::uintmax_t>(file.tellg());
    const bool isWhole = size <= max;
    std::string text(static_cast<std::size_t>(isWhole ? size : max), '\0');
    file.seekg(-static_cast<std::streamoff>(text.size()), std::ios::end);
    if (!file.read(text.data(), static_cast<std::streamsize>(text.size())))
        return Error(MessageCode::FileUnreadable, path, {"it ended early"});
    if (!isWhole) // from the middle of a line
        text.erase(0, std::min(text.find('\n'), text.size() - 1) + 1);
    return text;
}

/// A file that is open for one step.
class OpenFile {
public:
    OpenFile(const std::string& path, int flags) : m_file(::open(path.c_str(), flags | O_CLOEXEC, 0600)) {}
    ~OpenFile() {
        if (m_file >= 0)
            ::close(m_file);
    }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    int get() const { return m_file; }

private:
    int m_file;
};

Error unwritable(const std::string& path) {
    return Error(MessageCode::FileUnwritable, path, {std::strerror(errno)});
}

bool writeWhole(int file, const std::string& text) {
    for (std::size_t done = 0; done < text.size();) {
        const ssize_t written = ::write(file, text.data() + done, text.size() - done);
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        done += static_cast<std::size_t>(written);
    }
    return true;
}

/// A line that a crash has cut short must not take the next one with it.
bool endsWithinLine(int file, off_t size) {
    char last = '\n';
    return size > 0 && ::pread(file, &last, 1, size - 1) == 1 && last != '\n';
}

/// And what else has no room beside the bytes that come.
Result<void> dropOlderHalf(const std::string& path, std::uintmax_t coming) {
    const std::uintmax_t room = kMaxUnrecordedBytes - std::min(coming, kMaxUnrecordedBytes);
    const auto kept = newestLines(path, std::min(room, kMaxUnrecordedBytes / 2));
    return kept ? writeTextFile(path, *kept) : Result<void>(kept.error());
}

} // namespace

std::string unrecordedAlarmFile(const std::string& alarmFile) {
    return alarmFile.empty()
               ? std::string()
               : (std::filesystem::path(alarmFile).parent_path() / "alarms-without-run.jsonl").string();
}

Result<UnrecordedAlarms> readUnrecordedAlarms(const std::string& path) {
    const auto text = newestLines(path, kMaxUnrecordedBytes);
    if (!text)
        return text.error();
    UnrecordedAlarms out;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
        if (line.empty())
            continue;
        if (auto change = readChange(line, path))
            out.changes.push_back(std::move(*change));
        else
            ++out.damaged;
    }
    return out;
}

Result<void> appendUnrecordedAlarms(const std::vector<UnrecordedChange>& changes, const std::string& path) {
    std::string text;
    for (const UnrecordedChange& change : changes)
        text += changeLine(change);
    const OpenFile lock(path + ".lock", O_RDWR | O_CREAT);
    if (lock.get() >= 0)
        (void)::flock(lock.get(), LOCK_EX); // on a disk that cannot lock the lines are still whole
    std::error_code code;
    const std::uintmax_t before = std::filesystem::file_size(path, code);
    if (!code && before + text.size() > kMaxUnrecordedBytes)
        if (auto dropped = dropOlderHalf(path, text.size()); !dropped)
            return dropped;
    const OpenFile file(path, O_RDWR | O_CREAT | O_APPEND);
    struct stat status {};
    if (file.get() < 0 || ::fstat(file.get(), &status) != 0)
        return unwritable(path);
    if (endsWithinLine(file.get(), status.st_size))
        text.insert(0, 1, '\n');
    if (writeWhole(file.get(), text))
        return {};
    const Error failed = unwritable(path);
    (void)!::ftruncate(file.get(), status.st_size); // not half a line
    return failed;
}

} // namespace bask
