#pragma once
// Guards of heaters outlive their engines, and a port that a test has taken away: they go on for ever.

#include <QDir>
#include <QFile>

#include <csignal>

namespace bask::test {

/// Ends the guards of ports in a folder, whatever they do.
inline void endGuardsOf(const QString& folder) {
    const QDir processes(QStringLiteral("/proc"));
    for (const QString& each : processes.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile file(processes.filePath(each + QStringLiteral("/cmdline")));
        if (each.toInt() > 1 && file.open(QIODevice::ReadOnly) &&
            file.readAll().startsWith("bask-guard" + QByteArray(1, '\0') + folder.toUtf8() + '/'))
            ::kill(each.toInt(), SIGKILL);
    }
}

} // namespace bask::test
