#include "engine/drivers/program_files.h"

#include "engine/base/message_code.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QStandardPaths>

#include <algorithm>

namespace bask {
namespace {

constexpr qint64 kMaxFile = 256 << 20;

} // namespace

Result<ProgramFiles> programFiles(const std::string& command) {
    const auto fail = [&](const QString& words) {
        return Error(MessageCode::ProgramNotStarted, {}, {command, words.toStdString()});
    };
    const QStringList words = QProcess::splitCommand(QString::fromStdString(command));
    if (words.isEmpty())
        return fail(QStringLiteral("the command is empty"));
    ProgramFiles out;
    for (const QString& word : words)
        out.words.push_back(word.toStdString());
    const QString found = words.front().contains(u'/') ? QFileInfo(words.front()).absoluteFilePath()
                                                       : QStandardPaths::findExecutable(words.front());
    if (found.isEmpty() || !QFileInfo(found).isFile())
        return fail(QStringLiteral("there is no program \"%1\"").arg(words.front()));
    if (!QFileInfo(found).isExecutable())
        return fail(QStringLiteral("\"%1\" is not executable").arg(found));
    out.program = found.toStdString();
    out.files.push_back(out.program);
    for (const QString& word : words.mid(1))
        if (const QFileInfo file(word); file.isFile())
            out.files.push_back(file.absoluteFilePath().toStdString());
    QCryptographicHash hash(QCryptographicHash::Sha256);
    for (const std::string& word : out.words)
        hash.addData(QByteArray::fromStdString(word).append('\0'));
    for (const std::string& path : out.files) {
        QFile file(QString::fromStdString(path));
        if (file.size() > kMaxFile || !file.open(QIODevice::ReadOnly))
            return fail(QStringLiteral("\"%1\" cannot be read").arg(file.fileName()));
        hash.addData(QByteArray::fromStdString(path).append('\0'));
        hash.addData(QByteArray::number(file.size()).append('\0'));
        if (!hash.addData(&file))
            return fail(QStringLiteral("\"%1\" cannot be read").arg(file.fileName()));
    }
    out.hash = hash.result().toHex().toStdString();
    return out;
}

std::string programName(const std::string& command) {
    const QStringList words = QProcess::splitCommand(QString::fromStdString(command));
    for (const QString& word : words.mid(1, 1)) // an option is no script
        if (!word.startsWith(QLatin1Char('-')))
            return QFileInfo(word).fileName().toStdString();
    return words.isEmpty() ? command : QFileInfo(words.front()).fileName().toStdString();
}

std::string commandLine(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) {
        QString quoted = QString::fromStdString(word);
        quoted.replace(QStringLiteral("\""), QStringLiteral("\"\"\""));
        if (word.empty() || word.find_first_of(" \t\"") != std::string::npos)
            quoted = QStringLiteral("\"%1\"").arg(quoted);
        out += (out.empty() ? "" : " ") + quoted.toStdString();
    }
    return out;
}

} // namespace bask
