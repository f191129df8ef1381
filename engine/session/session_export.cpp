#include "engine/base/message_code.h"
#include "engine/session/session_file.h"
#include "engine/session/session_store.h"

#include <QDir>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace bask {
namespace {

constexpr qsizetype kChunk = 1 << 20; // bytes held before they are written

/// RFC 4180: quoted when the text holds a comma, a quote or a line break.
void appendField(QByteArray& out, const SqlValue& value) {
    std::array<char, 32> digits{};
    if (const auto* number = std::get_if<double>(&value)) {
        // The shortest text that reads back as the same number.
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *number).ptr;
        out.append(digits.data(), end - digits.data());
    } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *whole).ptr;
        out.append(digits.data(), end - digits.data());
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        QByteArray field = QByteArray::fromStdString(*text);
        if (text->find_first_of(",\"\r\n") != std::string::npos)
            field = '"' + field.replace("\"", "\"\"") + '"';
        out.append(field);
    }
}

void appendRow(QByteArray& out, SessionStore::Row row) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (k > 0)
            out.append(',');
        appendField(out, row[k]);
    }
    out.append('\n');
}

/// A table's name becomes a file's name: nothing but letters, digits and underscores.
bool isPlainName(const std::string& name) {
    return std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// Refuses to write over what is no earlier export of the same table.
Result<void> checkOldExport(const SessionStore& store, const std::string& table, const std::string& file) {
    const QFileInfo info(QString::fromStdString(file));
    if (!info.exists())
        return {};
    if (!info.isFile())
        return Error(MessageCode::OutputNotAFile, file);
    if (info.size() == 0)
        return {};
    const auto columns = store.columns(table);
    if (!columns)
        return columns.error();
    QByteArray header;
    appendRow(header, std::vector<SqlValue>(columns->begin(), columns->end()));
    QFile old(info.filePath());
    if (!old.open(QIODevice::ReadOnly) || old.read(header.size()) != header)
        return Error(MessageCode::ExportForeign, file);
    return {};
}

Result<void> exportTable(const SessionStore& store, const std::string& table, const std::string& file) {
    const auto columns = store.columns(table);
    if (!columns)
        return columns.error();
    QSaveFile csv(QString::fromStdString(file));
    QByteArray buffer;
    bool written = csv.open(QIODevice::WriteOnly);
    const auto drain = [&] {
        written = written && csv.write(buffer) == buffer.size();
        buffer.clear();
    };
    const std::vector<SqlValue> header(columns->begin(), columns->end());
    appendRow(buffer, header);
    const auto done = store.select("SELECT * FROM \"" + table + '"', [&](SessionStore::Row row) {
        appendRow(buffer, row);
        if (buffer.size() >= kChunk)
            drain();
    });
    if (!done)
        return done;
    drain();
    if (!written || !csv.commit())
        return Error(MessageCode::FileUnwritable, file, {csv.errorString().toStdString()});
    return {};
}

} // namespace

Result<std::vector<std::string>> exportSessionCsv(const std::string& path, const std::string& folder) {
    // A whole look at the file first: nothing is written from one that is damaged.
    if (const auto record = readSession(path); !record)
        return record.error();
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    const auto tables = (*store)->tables();
    if (!tables)
        return tables.error();
    const QDir target(QString::fromStdString(folder));
    if (!target.mkpath(QStringLiteral(".")))
        return Error(MessageCode::FileUnwritable, folder, {"the folder cannot be made"});
    if (auto begun = (*store)->execute("BEGIN"); !begun)
        return begun.error();
    std::vector<std::string> names, files;
    for (const std::string& table : *tables) {
        if (!isPlainName(table))
            continue;
        names.push_back(table);
        files.push_back(target.filePath(QString::fromStdString(table + ".csv")).toStdString());
        if (auto place = checkOldExport(**store, table, files.back()); !place)
            return place.error();
    }
    for (std::size_t i = 0; i < files.size(); ++i)
        if (auto done = exportTable(**store, names[i], files[i]); !done)
            return done.error();
    return files;
}

} // namespace bask
