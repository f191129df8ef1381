#pragma once
// The sockets of a process at which others could connect to it.

#include <QString>
#include <QStringList>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

namespace bask::test {

/// Returns a line of the system's tables for each, with its table; empty if there is none. `process`: a
/// number, or "self".
inline std::string listeningSockets(const std::string& process = "self") {
    std::set<std::string> own;
    std::error_code gone;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/" + process + "/fd", gone)) {
        const std::string to = std::filesystem::read_symlink(entry.path(), gone).string();
        if (to.starts_with("socket:["))
            own.insert(to.substr(8, to.size() - 9));
    }
    std::string out;
    const auto look = [&](const char* table, qsizetype stateColumn, const char* state,
                          qsizetype inodeColumn) {
        std::ifstream lines(table);
        std::string line;
        std::getline(lines, line); // the header
        while (std::getline(lines, line)) {
            const QStringList columns = QString::fromStdString(line).split(u' ', Qt::SkipEmptyParts);
            if (columns.value(stateColumn) == QLatin1String(state) &&
                own.contains(columns.value(inodeColumn).toStdString()))
                out += std::string(table) + ' ' + line + '\n';
        }
    };
    look("/proc/self/net/tcp", 3, "0A", 9);
    look("/proc/self/net/tcp6", 3, "0A", 9);
    look("/proc/self/net/unix", 3, "00010000", 6);
    return out;
}

} // namespace bask::test
