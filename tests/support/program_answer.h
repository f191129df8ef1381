#pragma once
// A subcommand run by the program itself, BASK_PROGRAM: its exit code and what it wrote.

#include <QProcess>
#include <QProcessEnvironment>
#include <QString>
#include <QStringList>

namespace bask::test {

struct Answer {
    int exitCode = -1; ///< also of a program that crashed, or that did not end within five minutes
    QString out, err;
};

/// By a process that may have an environment and an output of its own.
inline Answer answerOf(QProcess& process, const QStringList& arguments) {
    process.start(QStringLiteral(BASK_PROGRAM), arguments);
    const bool hasEnded = process.waitForFinished(300'000) && process.exitStatus() == QProcess::NormalExit;
    return {hasEnded ? process.exitCode() : -1, QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

inline Answer answerOf(const QStringList& arguments) {
    QProcess process;
    return answerOf(process, arguments);
}

inline QProcessEnvironment withoutDisplay() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(QLatin1String(name));
    return environment;
}

} // namespace bask::test
