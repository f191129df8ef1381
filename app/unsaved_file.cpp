#include "app/unsaved_file.h"

#include "app/file_lock.h"
#include "engine/base/message_code.h"
#include "engine/experiment/experiment_file.h"
#include "engine/experiment/text_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

#include <atomic>

namespace bask {
namespace {

constexpr qint64 kMaxBytes = 64 << 20;
constexpr qint64 kLongestLine = 64 << 10;
const QString kFormat = QStringLiteral("bask-unsaved");

QJsonObject headerOf(const QByteArray& line) {
    return QJsonDocument::fromJson(line).object();
}

QByteArray firstLine(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readLine(kLongestLine) : QByteArray();
}

/// Two may be made within a millisecond.
int nextNumber() {
    static std::atomic<int> last{0};
    return ++last;
}

Error unreadable(const QFile& file) {
    return {MessageCode::FileUnreadable, file.fileName().toStdString(), {file.errorString().toStdString()}};
}

} // namespace

UnsavedFile::UnsavedFile(const QString& folder)
    : m_path(QDir(folder).filePath(QStringLiteral("%1-%2-%3.json")
                                       .arg(QCoreApplication::applicationPid())
                                       .arg(QDateTime::currentMSecsSinceEpoch())
                                       .arg(nextNumber()))) {}

UnsavedFile::~UnsavedFile() {
    if (m_lock >= 0)
        ::close(m_lock);
}

std::vector<std::shared_ptr<UnsavedFile>> UnsavedFile::left(const QString& folder) {
    std::vector<std::shared_ptr<UnsavedFile>> found;
    const QDir dir(folder);
    for (const QString& name : dir.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Time)) {
        std::shared_ptr<UnsavedFile> file(new UnsavedFile(dir.filePath(name), -1));
        file->m_lock = openLocked(file->lockPath());
        // Its owner may have removed it before it let the lock go.
        if (file->m_lock >= 0 && QFile::exists(file->m_path))
            found.push_back(std::move(file));
    }
    return found;
}

Result<void> UnsavedFile::write(const UnsavedEdits& edits) {
    const QFileInfo info(m_path);
    QDir().mkpath(info.path());
    if (m_lock < 0)
        m_lock = openLocked(lockPath());
    if (m_lock < 0)
        return Error(MessageCode::FileUnwritable, lockPath().toStdString(),
                     {qt_error_string().toStdString()});
    QJsonObject header;
    header[QStringLiteral("format")] = kFormat;
    header[QStringLiteral("version")] = 1;
    header[QStringLiteral("pid")] = QCoreApplication::applicationPid();
    header[QStringLiteral("path")] = edits.path;
    header[QStringLiteral("name")] = edits.name;
    return writeTextFile(m_path.toStdString(),
                         QJsonDocument(header).toJson(QJsonDocument::Compact).toStdString() + '\n' +
                             experimentToJson(edits.experiment));
}

Result<UnsavedEdits> UnsavedFile::read() const {
    QFile file(m_path);
    if (!file.open(QIODevice::ReadOnly) || file.size() > kMaxBytes)
        return unreadable(file);
    const QJsonObject header = headerOf(file.readLine(kLongestLine));
    const QByteArray text = file.readAll();
    if (header.value(QStringLiteral("format")).toString() != kFormat)
        return unreadable(file);
    auto experiment = experimentFromJson(text.toStdString(), m_path.toStdString(), {});
    if (!experiment)
        return experiment.error();
    return UnsavedEdits{std::move(*experiment), header.value(QStringLiteral("path")).toString(),
                        header.value(QStringLiteral("name")).toString()};
}

/// The lock's file last: without the other it is nobody's.
void UnsavedFile::remove() {
    QFile::remove(m_path);
    if (m_lock < 0)
        return;
    QFile::remove(lockPath());
    ::close(m_lock);
    m_lock = -1;
}

QString UnsavedFile::name() const {
    const QString name = headerOf(firstLine(m_path)).value(QStringLiteral("name")).toString();
    return name.isEmpty() ? QFileInfo(m_path).fileName() : name;
}

QDateTime UnsavedFile::time() const {
    return QFileInfo(m_path).lastModified();
}

} // namespace bask
