#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/recording/csv_columns.h"
#include "engine/recording/csv_field.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_verify.h"
#include "engine/recording/simulation_pace.h"
#include "engine/recording/staged_files.h"

#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <memory>

namespace bask {
namespace {

constexpr qsizetype kCsvChunk = 1 << 20;   // bytes held before they are written
constexpr double kAfterTraces = 0.4;       // of the work
constexpr std::uintmax_t kFull = 64 << 10; // bytes; with less a disk counts as full

using Roundings = std::vector<std::optional<CsvRounding>>; ///< of columns; empty: of none

void appendField(QByteArray& out, const SqlValue& value, const std::optional<CsvRounding>& rounding) {
    std::array<char, 32> digits{};
    if (const auto* number = std::get_if<double>(&value)) {
        // The shortest text that reads back as the same number.
        const double shown = rounding ? (*rounding)(*number) : *number;
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), shown).ptr;
        out.append(digits.data(), end - digits.data());
    } else if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), *whole).ptr;
        out.append(digits.data(), end - digits.data());
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        out.append(QByteArray::fromStdString(csvField(*text)));
    } else if (const auto* blob = std::get_if<SqlBlob>(&value)) {
        out.append(QByteArray::fromStdString(blob->bytes).toHex());
    }
}

void appendRow(QByteArray& out, SessionStore::Row row, const Roundings& roundings = {}) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (k > 0)
            out.append(',');
        appendField(out, row[k], k < roundings.size() ? roundings[k] : std::nullopt);
    }
    out.append('\n');
}

/// A table's name becomes a file's name: nothing but letters, digits and underscores.
bool isPlainName(const std::string& name) {
    return std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

constexpr const char* kColumnsTable = "columns";

/// What every wide table begins with.
constexpr const char* kTracesHeader = "time (s),source (degC)";

QByteArray rowText(SessionStore::Row row) {
    QByteArray text;
    appendRow(text, row);
    return text;
}

/// One CSV among staged files.
class CsvFile {
public:
    explicit CsvFile(std::string path, Roundings roundings = {})
        : m_path(std::move(path)), m_roundings(std::move(roundings)) {}

    /// Refuses to write over what does not begin as an earlier export of the same table.
    Result<void> open(StagedFiles& stage, const QByteArray& begin) {
        const QFileInfo info(QString::fromStdString(m_path));
        if (info.exists() && !info.isFile())
            return Error(MessageCode::OutputNotAFile, m_path);
        QFile old(info.filePath());
        if (info.size() > 0 && (!old.open(QIODevice::ReadOnly) || old.read(begin.size()) != begin))
            return Error(MessageCode::ExportForeign, m_path);
        const auto place = stage.place(info.fileName().toStdString());
        if (!place)
            return place.error();
        m_file.setFileName(QString::fromStdString(*place));
        m_isWritten = m_file.open(QIODevice::WriteOnly);
        return m_isWritten ? Result<void>() : unwritable();
    }
    void add(SessionStore::Row row) {
        appendRow(m_buffer, row, m_roundings);
        if (m_buffer.size() >= kCsvChunk)
            drain();
    }
    Result<void> end() {
        drain();
        m_isWritten = m_isWritten && m_file.flush();
        m_file.close();
        return m_isWritten ? Result<void>() : unwritable();
    }

private:
    void drain() {
        m_isWritten = m_isWritten && m_file.write(m_buffer) == m_buffer.size();
        m_buffer.clear();
    }
    Result<void> unwritable() const {
        std::error_code failed; // Qt has no words for a write that was cut short
        const auto space =
            std::filesystem::space(QFileInfo(m_file.fileName()).absolutePath().toStdString(), failed);
        const bool isFull = !failed && space.available < kFull;
        return Error(MessageCode::FileUnwritable, m_path,
                     {isFull ? std::strerror(ENOSPC) : m_file.errorString().toStdString()});
    }

    std::string m_path;
    Roundings m_roundings;
    QFile m_file;
    QByteArray m_buffer;
    bool m_isWritten = false;
};

using CsvFiles = std::vector<std::unique_ptr<CsvFile>>;

Result<void> openTables(const SessionStore& store, const std::vector<std::string>& tables, CsvDigits digits,
                        StagedFiles& stage, CsvFiles& files) {
    for (const std::string& table : tables) {
        const auto columns = store.columns(table);
        if (!columns)
            return columns.error();
        const std::vector<SqlValue> header(columns->begin(), columns->end());
        files.push_back(std::make_unique<CsvFile>(stage.target(table + ".csv"),
                                                  digits == CsvDigits::All ? Roundings()
                                                                           : csvRoundings(table, *columns)));
        QByteArray begin = rowText(header).trimmed();
        if (begin.endsWith(",operator")) // which earlier files did not have
            begin.chop(9);
        if (auto opened = files.back()->open(stage, begin); !opened)
            return opened;
        files.back()->add(header);
    }
    return {};
}

/// Adds to meta.csv what the table does not have.
void addMeta(const std::vector<std::string>& tables, const CsvFiles& files, const std::string& key,
             const std::string& value) {
    const std::array<SqlValue, 2> row{key, value};
    for (std::size_t i = 0; i < tables.size(); ++i)
        if (tables[i] == "meta")
            files[i]->add(row);
}

/// About how many rows a table or a view of the samples has.
double roughRowsOf(const SessionStore& store, const std::string& table, std::size_t objects) {
    std::string view;
    if (const auto read =
            store.select("SELECT sql FROM sqlite_master WHERE type = 'view' AND name = " + sqlText(table),
                         [&](SessionStore::Row row) { view = textOf(row[0]); });
        !read || view.empty())
        return roughRows(store, table);
    if (view.ends_with("WHERE 0")) // of what the rig does not have
        return 0.0;
    const bool isOfObjects = view.find("CROSS JOIN object") != std::string::npos;
    return roughRows(store, "step") * static_cast<double>(isOfObjects ? objects : 1);
}

Result<void> writeTables(const SessionStore& store, const std::vector<std::string>& tables, CsvFiles& files,
                         const SessionRecord& facts, const ShareDone& told) {
    const std::size_t objects = facts.experiment.objects.size();
    double rows = 0.0;
    for (const std::string& table : tables)
        rows += roughRowsOf(store, table, objects);
    ShareCount count(told, rows);
    for (std::size_t i = 0; i < tables.size(); ++i) {
        auto done = store.select("SELECT * FROM \"" + tables[i] + '"', [&](SessionStore::Row row) {
            files[i]->add(row);
            count.add();
        });
        if (done)
            done = files[i]->end();
        if (!done)
            return done;
    }
    return {};
}

/// What was made by a difference, without the digits that came by it: 40.23 and not 40.230000000000075.
double withoutRest(double difference) {
    constexpr double kPerUnit = 1e9, kLargest = 1e6;
    return std::abs(difference) < kLargest ? std::nearbyint(difference * kPerUnit) / kPerUnit + 0.0
                                           : difference;
}

/// Cells of traces.csv.
class TraceCells {
public:
    explicit TraceCells(CsvDigits digits) : m_digits(digits) {}

    SqlValue number(double value, const Unit& unit) const {
        return sqlNumber(m_digits == CsvDigits::All ? value : csvRounding(unit)(value));
    }
    /// A number, temperatures in degC.
    template <class Row> SqlValue of(const SampleColumn<Row>& column, const Row& row) const {
        const double value = column.value.get(row);
        if (column.isWhole)
            return static_cast<std::int64_t>(value);
        if (column.unit.edge == EdgeUnit::Temperature)
            return number(withoutRest(celsiusFromKelvin(value)), column.unit);
        const bool isStored = column.stored.place > 0;
        return number(isStored ? value : withoutRest(value), column.unit);
    }

private:
    CsvDigits m_digits;
};

std::vector<const ObjectColumn*> columnsInTraces(const RecordedRig& rig) {
    std::vector<const ObjectColumn*> out;
    for (const ObjectColumn& column : kObjectColumns)
        if (column.csv != nullptr && rig.has(column.needs))
            out.push_back(&column);
    return out;
}

/// The traces of all objects side by side, a row a sample. Looks at the whole file: nothing is left of an
/// export of one that is damaged. Sets `last_s` to the time of the last sample.
Result<void> writeTraces(const SessionRecord& facts, const TraceCells& cells, CsvFile& file, double& last_s,
                         const ShareDone& done) {
    const std::vector<const ObjectColumn*> ofObjects = columnsInTraces(facts.rig());
    std::vector<SqlValue> row{std::string("time (s)")};
    for (const RunColumn& column : kRunColumns)
        if (column.csv != nullptr)
            row.emplace_back(csvHeader(column));
    for (std::size_t k = 0; k < kCoordinateNames.size(); ++k)
        row.emplace_back(csvCoordinateHeader(k));
    for (const ObjectSpec& object : facts.experiment.objects)
        for (const ObjectColumn* column : ofObjects)
            row.emplace_back(object.name + ' ' + csvHeader(*column));
    file.add(row);
    const auto add = [&](const TraceSample& sample) {
        last_s = sample.time_s;
        row = {cells.number(sample.time_s, unit::kSeconds)};
        for (const RunColumn& column : kRunColumns)
            if (column.csv != nullptr)
                row.push_back(cells.of(column, sample));
        for (int k = 0; k < 6; ++k)
            row.push_back(cells.number(sample.coordinates[k], k < 3 ? unit::kMillimetres : unit::kDegrees));
        for (const ObjectSample& object : sample.objects)
            for (const ObjectColumn* column : ofObjects)
                row.push_back(cells.of(*column, object));
        file.add(row);
    };
    const auto read = readSamples(facts.path, add, {}, done);
    return read ? file.end() : read;
}

/// Beside the tables, what their columns are. Earlier recordings lack some tables.
Result<void> writeColumns(const SessionRecord& facts, const std::vector<std::string>& tables,
                          StagedFiles& stage) {
    const std::vector<SqlValue> header{std::string("file"), std::string("column"), std::string("unit"),
                                       std::string("meaning")};
    CsvFile file(stage.target(std::string(kColumnsTable) + ".csv"));
    if (auto opened = file.open(stage, rowText(header).trimmed()); !opened)
        return opened;
    file.add(header);
    const auto isThere = [&](const std::string& name) {
        return name == "*.csv" || name == "traces.csv" ||
               std::ranges::any_of(tables, [&](const std::string& table) { return table + ".csv" == name; });
    };
    for (const CsvColumn& column : csvColumns(facts)) {
        if (!isThere(column.file))
            continue;
        const std::vector<SqlValue> row{column.file, column.column, column.unit, column.meaning};
        file.add(row);
    }
    return file.end();
}

} // namespace

Result<std::vector<std::string>> exportSessionCsv(const std::string& path, const std::string& folder,
                                                  const ShareDone& told, CsvDigits digits) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    auto facts = readFacts(**store, path);
    if (!facts)
        return facts.error();
    facts->verification = verificationOf(path);
    auto tables = (*store)->tables();
    if (!tables)
        return tables.error();
    std::erase_if(*tables, [](const std::string& table) { return !isPlainName(table); });
    auto stage = StagedFiles::into(folder);
    if (!stage)
        return stage.error();
    if (auto begun = (*store)->execute("BEGIN"); !begun)
        return begun.error();
    CsvFile traces(stage->target("traces.csv"));
    CsvFiles files;
    double last_s = 0.0;
    auto done = traces.open(*stage, kTracesHeader);
    if (done)
        done = openTables(**store, *tables, digits, *stage, files);
    if (done)
        done = writeTraces(*facts, TraceCells(digits), traces, last_s, partOf(told, 0.0, kAfterTraces));
    if (const auto pace = simulationPace(*facts, last_s); done && pace)
        addMeta(*tables, files, "simulation_pace", paceText(*pace));
    if (done) // what the file itself cannot tell: whether it is as it was recorded
        addMeta(*tables, files, "verification", facts->verification);
    if (done)
        done = writeTables(**store, *tables, files, *facts, partOf(told, kAfterTraces, 1.0));
    const bool hasName = std::ranges::find(*tables, kColumnsTable) == tables->end();
    if (done && hasName) // else a table of another maker has it
        done = writeColumns(*facts, *tables, *stage);
    if (done)
        done = addCrate(*stage, *facts);
    if (done)
        tellShare(told, 1.0);
    return done ? stage->commit() : done.error();
}

} // namespace bask
