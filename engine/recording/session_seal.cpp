#include "engine/recording/session_seal.h"

#include "engine/base/message_code.h"
#include "engine/recording/row_chain.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cstring>
#include <random>

#include <sys/stat.h>
#include <unistd.h>

namespace bask {
namespace {

constexpr std::size_t kBytes = Digest().size();
constexpr const char* kRoom = "Bask: no seal. "; ///< begins what stands for a seal that is not there yet

struct StoredSeal {
    std::string bytes;      ///< empty: none
    bool isRemoved = false; ///< there has to be one
};

Result<StoredSeal> sealIn(const std::string& path) {
    const auto store = SessionStore::openAltered(path);
    if (!store)
        return store.error();
    bool hasChain = false, hasSeal = false, hasMeta = false;
    auto done = (*store)->select(
        "SELECT name, sql FROM sqlite_master WHERE type = 'table' AND name IN ('chain', 'seal', 'meta')",
        [&](SessionStore::Row row) {
            const std::string name = textOf(row[0]), sql = textOf(row[1]);
            hasChain = hasChain || sql == kCreateChain;
            hasSeal = hasSeal || sql == kCreateSeal;
            hasMeta = hasMeta || (name == "meta" && SessionStore::isPlainTable(sql));
        });
    StoredSeal seal;
    bool hasEnd = false, isThere = false;
    if (done && hasSeal)
        done = (*store)->select("SELECT hash FROM seal LIMIT 1", [&](SessionStore::Row row) {
            isThere = true;
            if (const auto* blob = std::get_if<SqlBlob>(&row[0]))
                seal.bytes = blob->bytes;
        });
    if (done && hasMeta)
        done = (*store)->select("SELECT 1 FROM meta WHERE key IN ('outcome', 'finished') LIMIT 1",
                                [&](SessionStore::Row) { hasEnd = true; });
    if (!done)
        return done.error();
    seal.isRemoved = hasChain && (!hasSeal || (hasEnd && !isThere));
    return seal;
}

/// A file in memory, as far as it is looked at; one descriptor for reading and writing.
class MappedFile {
public:
    MappedFile(const QString& path, QIODevice::OpenMode mode) : m_file(path) {
        if (m_file.open(mode | QIODevice::ExistingOnly | QIODevice::Unbuffered) &&
            ::fstat(m_file.handle(), &m_begun) == 0)
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
    std::string hashWithout(std::ptrdiff_t place, const ShareDone& done = {}) const {
        Sha256 hash;
        ShareCount count(done, static_cast<double>(m_file.size()));
        const auto add = [&](std::ptrdiff_t from, std::ptrdiff_t to) {
            constexpr std::ptrdiff_t kStep = 1 << 23; // a share is told after each
            for (; from < to; from += kStep) {
                const std::ptrdiff_t step = std::min(kStep, to - from);
                hash.add(m_bytes + from, static_cast<std::size_t>(step));
                count.add(static_cast<double>(step));
            }
        };
        add(0, place);
        const Digest none{};
        hash.add(none.data(), none.size());
        count.add(static_cast<double>(kBytes));
        add(place + static_cast<std::ptrdiff_t>(kBytes), m_file.size());
        const Digest digest = hash.take();
        return {digest.begin(), digest.end()};
    }
    /// Whether the path still names this very file, and nobody has written into it since it was opened.
    bool isUntouched(const QString& path) const {
        struct stat there {};
        return ::stat(path.toLocal8Bit().constData(), &there) == 0 && there.st_ino == m_begun.st_ino &&
               there.st_dev == m_begun.st_dev && there.st_size == m_begun.st_size &&
               there.st_mtim.tv_sec == m_begun.st_mtim.tv_sec &&
               there.st_mtim.tv_nsec == m_begun.st_mtim.tv_nsec;
    }
    bool write(std::ptrdiff_t place, const std::string& bytes) {
        return m_file.seek(place) &&
               m_file.write(bytes.data(), static_cast<qint64>(bytes.size())) ==
                   static_cast<qint64>(bytes.size()) &&
               ::fsync(m_file.handle()) == 0;
    }

private:
    QFile m_file;
    struct stat m_begun {};
    const unsigned char* m_bytes = nullptr;
};

/// The file itself: a log lies beside that, not beside a link to it.
QString fileOf(const std::string& path) {
    return QFileInfo(QString::fromStdString(path)).canonicalFilePath();
}

/// An empty log is there while a reader has the file open. In that reader's own process the file is not to be
/// opened and closed: that would drop its locks.
bool hasLog(const QString& file, bool countsEmpty = true) {
    const QFileInfo log(file + QStringLiteral("-wal"));
    return countsEmpty ? log.exists() : log.size() > 0;
}

bool isRoom(const std::string& seal) {
    return seal.size() == kBytes && seal.starts_with(kRoom);
}

} // namespace

Result<void> makeSeal(SessionStore& store) {
    QByteArray room(kRoom); // then at random, so that it is found again in the file
    for (std::random_device random; room.size() < static_cast<qsizetype>(kBytes);)
        room.append(static_cast<char>(random()));
    auto done = store.execute("DELETE FROM seal");
    return done ? store.execute("INSERT INTO seal VALUES(x'" + room.toHex().toStdString() + "')") : done;
}

Result<void> sealSession(const std::string& path) {
    const QString file = fileOf(path);
    if (hasLog(file))
        return {};
    const auto seal = sealIn(path);
    if (!seal)
        return seal.error();
    if (!isRoom(seal->bytes))
        return {};
    MappedFile mapped(file, QIODevice::ReadWrite);
    const std::ptrdiff_t place = mapped.isOpen() ? mapped.placeOf(seal->bytes) : -1;
    if (place < 0)
        return {};
    const std::string hash = mapped.hashWithout(place);
    if (hasLog(file) || !mapped.isUntouched(file)) // whoever has written meanwhile makes its own room
        return {};
    if (!mapped.write(place, hash))
        return Error(MessageCode::FileUnwritable, path, {mapped.words()});
    return {};
}

Result<Seal> lookAtSeal(const std::string& path, bool isAlone, const ShareDone& done) {
    const auto seal = sealIn(path);
    if (!seal)
        return seal.error();
    if (seal->isRemoved)
        return Seal::Removed;
    const QString file = fileOf(path);
    if (hasLog(file, !isAlone) || seal->bytes.empty() || isRoom(seal->bytes))
        return Seal::None;
    if (seal->bytes.size() != kBytes)
        return Seal::Broken;
    const MappedFile mapped(file, QIODevice::ReadOnly);
    if (!mapped.isOpen())
        return Error(MessageCode::FileUnreadable, path, {mapped.words()});
    const std::ptrdiff_t place = mapped.placeOf(seal->bytes);
    return place >= 0 && mapped.hashWithout(place, done) == seal->bytes ? Seal::Holds : Seal::Broken;
}

} // namespace bask
