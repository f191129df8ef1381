#include "engine/recording/session_seal.h"

#include "engine/base/message_code.h"
#include "engine/recording/row_chain.h"

#include <QCryptographicHash>
#include <QFile>

#include <algorithm>
#include <cstring>
#include <random>

#include <unistd.h>

namespace bask {
namespace {

constexpr std::size_t kBytes = Digest().size();

/// The seal's bytes; empty where the file has none.
Result<std::string> sealIn(const std::string& path) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    bool hasTable = false;
    std::string bytes;
    auto done = (*store)->select("SELECT 1 FROM sqlite_master WHERE name = 'seal' AND type = 'table'",
                                 [&](SessionStore::Row) { hasTable = true; });
    if (done && hasTable)
        done = (*store)->select("SELECT hash FROM seal LIMIT 1", [&](SessionStore::Row row) {
            if (const auto* blob = std::get_if<SqlBlob>(&row[0]);
                blob != nullptr && blob->bytes.size() == kBytes)
                bytes = blob->bytes;
        });
    if (!done)
        return done.error();
    return bytes;
}

/// A file in memory, as far as it is looked at.
class MappedFile {
public:
    explicit MappedFile(const std::string& path) : m_file(QString::fromStdString(path)) {
        if (m_file.open(QIODevice::ReadOnly))
            m_bytes = m_file.map(0, m_file.size());
    }
    bool isOpen() const { return m_bytes != nullptr; }
    std::string words() const { return m_file.errorString().toStdString(); }

    /// Where the bytes are; negative if they are not there, or more than once.
    std::ptrdiff_t placeOf(const std::string& bytes) const {
        const unsigned char* const end = m_bytes + m_file.size();
        const auto find = [&](const unsigned char* from) {
            return static_cast<const unsigned char*>(
                ::memmem(from, static_cast<std::size_t>(end - from), bytes.data(), bytes.size()));
        };
        const unsigned char* const first = find(m_bytes);
        return first == nullptr || find(first + 1) != nullptr ? -1 : first - m_bytes;
    }
    /// SHA-256 with zeros instead of the seal at `place`.
    std::string hashWithout(std::ptrdiff_t place) const {
        QCryptographicHash hash(QCryptographicHash::Sha256);
        const auto add = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
            constexpr std::ptrdiff_t kStep = 1 << 28; // Qt 6.4 counts in int somewhere below
            for (; from < to; from += kStep)
                hash.addData(QByteArray::fromRawData(reinterpret_cast<const char*>(m_bytes) + from,
                                                     std::min(kStep, to - from)));
        };
        add(0, place);
        hash.addData(QByteArray(static_cast<qsizetype>(kBytes), '\0'));
        add(place + static_cast<std::ptrdiff_t>(kBytes), m_file.size());
        return hash.result().toStdString();
    }

private:
    QFile m_file;
    const unsigned char* m_bytes = nullptr;
};

bool hasLog(const std::string& path) {
    return QFile::exists(QString::fromStdString(path) + QStringLiteral("-wal"));
}

} // namespace

Result<void> makeSeal(SessionStore& store) {
    QByteArray room; // random, so that it is found again in the file
    for (std::random_device random; room.size() < static_cast<qsizetype>(kBytes);)
        room.append(static_cast<char>(random()));
    return store.execute("INSERT INTO seal VALUES(x'" + room.toHex().toStdString() + "')");
}

Result<void> sealSession(const std::string& path) {
    if (hasLog(path))
        return {};
    const auto seal = sealIn(path);
    if (!seal)
        return seal.error();
    if (seal->empty())
        return {};
    const MappedFile mapped(path);
    const std::ptrdiff_t place = mapped.isOpen() ? mapped.placeOf(*seal) : -1;
    if (place < 0)
        return {};
    const std::string hash = mapped.hashWithout(place);
    QFile file(QString::fromStdString(path));
    if (!file.open(QIODevice::ReadWrite | QIODevice::Unbuffered) || !file.seek(place) ||
        file.write(hash.data(), static_cast<qint64>(hash.size())) != static_cast<qint64>(hash.size()) ||
        ::fsync(file.handle()) != 0)
        return Error(MessageCode::FileUnwritable, path, {file.errorString().toStdString()});
    return {};
}

Result<Seal> lookAtSeal(const std::string& path) {
    if (hasLog(path))
        return Seal::None;
    const auto seal = sealIn(path);
    if (!seal)
        return seal.error();
    if (seal->empty())
        return Seal::None;
    const MappedFile mapped(path);
    if (!mapped.isOpen())
        return Error(MessageCode::FileUnreadable, path, {mapped.words()});
    const std::ptrdiff_t place = mapped.placeOf(*seal);
    return place >= 0 && mapped.hashWithout(place) == *seal ? Seal::Holds : Seal::Broken;
}

} // namespace bask
