#include "engine/recording/session_tables.h"

#include "engine/base/pose.h"
#include "engine/recording/trace_overview.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr const char* kMadeFirst[] = {
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
    "CREATE TABLE experiment(json TEXT NOT NULL)",
    "CREATE TABLE object(number INTEGER PRIMARY KEY, name TEXT NOT NULL)",
};
constexpr const char* kMadeLast[] = {
    "CREATE TABLE command(time_s REAL NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL, operator TEXT NOT "
    "NULL)",
    "CREATE TABLE event(time_s REAL NOT NULL, code TEXT NOT NULL, args TEXT NOT NULL, text TEXT NOT NULL)",
    "CREATE TABLE note(time_s REAL NOT NULL, text TEXT NOT NULL, operator TEXT NOT NULL)",
    "CREATE TABLE target_step(time_s REAL NOT NULL, object INTEGER NOT NULL, target_K REAL)",
    "CREATE TABLE overview(last_step INTEGER PRIMARY KEY, extremes BLOB NOT NULL)",
};

constexpr std::array kPose{"x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"};
/// Columns of `step`: number, time, pose, those of the run, the source's pose, those of each object.
constexpr std::size_t kNumber = 0, kTime = 1, kPoseAt = 2;

/// Columns that are stored, in their places.
template <class Row, std::size_t N>
std::vector<const SampleColumn<Row>*> storedColumns(const std::array<SampleColumn<Row>, N>& all) {
    std::vector<const SampleColumn<Row>*> out;
    for (const SampleColumn<Row>& column : all)
        if (column.stored.place > 0)
            out.push_back(&column);
    std::ranges::sort(out, {}, [](const SampleColumn<Row>* column) { return column->stored.place; });
    return out;
}

const std::vector<const RunColumn*>& runColumns() {
    static const auto kStored = storedColumns(kRunColumns);
    return kStored;
}
const std::vector<const ObjectColumn*>& objectColumns() {
    static const auto kStored = storedColumns(kObjectColumns);
    return kStored;
}

std::size_t columnCount(std::size_t objects) {
    return kPoseAt + 2 * kPose.size() + runColumns().size() + objects * objectColumns().size();
}

/// The shortest text that reads back as the same number.
std::string digits(double value) {
    std::array<char, 32> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::string columnOf(const char* name, std::size_t object) {
    return std::string(name) + '_' + std::to_string(object + 1);
}

std::array<double, 7> columnsOfPose(const Vector6d& x) {
    Eigen::Quaterniond q(poseFromCoordinates(x).linear());
    if (q.w() < 0.0)
        q.coeffs() = -q.coeffs();
    return {x[0], x[1], x[2], q.w(), q.x(), q.y(), q.z()};
}

/// Whether a view has a thermal camera's columns: older programs read only files without such a view.
bool isOfThermalCamera(const std::string& view) {
    return std::ranges::any_of(objectColumns(), [&](const ObjectColumn* column) {
        return column->stored.view == view && column->needs == Needs::ThermalCamera;
    });
}

/// A view with one row a sample and object.
std::string objectView(const std::string& name, std::size_t objects, const RecordedRig& rig) {
    std::string out = "CREATE VIEW " + name + " AS SELECT time_s, name AS object";
    bool isThere = false;
    for (const ObjectColumn* column : objectColumns()) {
        if (column->stored.view != name)
            continue;
        isThere = isThere || rig.has(column->needs);
        out += ", CASE object.number";
        for (std::size_t i = 0; i < objects; ++i)
            out += " WHEN " + std::to_string(i + 1) + " THEN " + columnOf(column->nameInView(), i);
        out += std::string(" END AS ") + column->nameInView();
    }
    out += " FROM step CROSS JOIN object"; // in this order: samples, then objects
    return isThere ? out : out + " WHERE 0";
}

std::string rigView(const std::string& name, const std::vector<std::string>& columns) {
    std::string out = "CREATE VIEW " + name + " AS SELECT time_s";
    for (const std::string& column : columns)
        out += ", " + column;
    return out + " FROM step";
}

template <class Row> SqlValue cellOf(const SampleColumn<Row>& column, const Row& row) {
    const double value = column.value.get(row);
    return column.isWhole ? SqlValue(static_cast<std::int64_t>(value)) : sqlNumber(value);
}

} // namespace

SessionTables::SessionTables(const Experiment& experiment, bool simulated)
    : m_source(experiment.source.pose), m_rig{simulated, thermalProfile(experiment, simulated).has_value()} {
    for (const ObjectSpec& object : experiment.objects)
        m_names.push_back(object.name);
}

Result<SessionTables> SessionTables::of(const SessionStore& store, const SessionRecord& facts) {
    const auto found = store.columns("step");
    if (!found)
        return found.error();
    SessionTables out(facts.experiment, facts.simulated);
    const auto isMissing = [&](const auto* column, const std::string& name) {
        return column->stored.isLater && std::ranges::find(*found, name) == found->end();
    };
    for (const RunColumn* column : runColumns())
        if (isMissing(column, column->key))
            out.m_absent.insert(column->key);
    for (const ObjectColumn* column : objectColumns())
        if (isMissing(column, columnOf(column->nameInView(), 0)))
            out.m_absent.insert(column->key);
    return out;
}

bool SessionTables::isAbsent(const std::string& key) const {
    return m_absent.contains(key);
}

std::size_t SessionTables::quantities() const {
    std::size_t count = 0;
    for (; count < quantityCount(); ++count) {
        const ObjectColumn* const ofObjects = plottedColumn(static_cast<Quantity>(count));
        const RunColumn* const ofRun = plottedRunColumn(static_cast<Quantity>(count));
        if ((ofObjects != nullptr && isAbsent(ofObjects->key)) || (ofRun != nullptr && isAbsent(ofRun->key)))
            break;
    }
    return count;
}

/// Names of all columns of `step`, with their types to make it, or NULL for what the file lacks to read it.
std::string SessionTables::columnList(bool typed) const {
    const char* const real = typed ? " REAL" : "";
    const char* const whole = typed ? " INTEGER NOT NULL" : "";
    std::string out = typed ? "number INTEGER PRIMARY KEY, time_s REAL NOT NULL" : "number, time_s";
    const auto add = [&](const std::string& name, const char* type) { out += ", " + name + type; };
    const auto addColumn = [&](const auto* column, const std::string& name) {
        add(isAbsent(column->key) ? "NULL" : name, column->isWhole ? whole : real);
    };
    for (const char* name : kPose)
        add(name, real);
    for (const RunColumn* column : runColumns())
        addColumn(column, column->key);
    for (const char* name : kPose)
        add(std::string("source_") + name, real);
    for (std::size_t i = 0; i < m_names.size(); ++i)
        for (const ObjectColumn* column : objectColumns())
            addColumn(column, columnOf(column->nameInView(), i));
    return out;
}

std::vector<std::string> SessionTables::create() const {
    std::vector<std::string> out(std::begin(kMadeFirst), std::end(kMadeFirst));
    for (std::size_t i = 0; i < m_names.size(); ++i)
        out.push_back("INSERT INTO object VALUES(" + std::to_string(i + 1) + ", " + sqlText(m_names[i]) +
                      ')');
    out.push_back("CREATE TABLE step(" + columnList(true) + ')');

    for (const std::string& view : storedViews(kObjectColumns))
        if (m_rig.hasThermalCamera || !isOfThermalCamera(view))
            out.push_back(objectView(view, m_names.size(), m_rig));
    out.push_back(rigView("pose", {kPose.begin(), kPose.end()}));
    for (const std::string& view : storedViews(kRunColumns)) {
        std::vector<std::string> columns;
        for (const RunColumn* column : runColumns())
            if (column->stored.view == view)
                columns.push_back(column->stored.name == nullptr
                                      ? column->key
                                      : std::string(column->key) + " AS " + column->stored.name);
        out.push_back(rigView(view, columns));
    }
    std::vector<std::string> sourcePose;
    const auto source = columnsOfPose(m_source);
    for (std::size_t k = 0; k < kPose.size(); ++k)
        sourcePose.push_back(std::string("ifnull(source_") + kPose[k] + ", " + digits(source[k]) + ") AS " +
                             kPose[k]);
    out.push_back(rigView("source_pose", sourcePose));
    out.insert(out.end(), std::begin(kMadeLast), std::end(kMadeLast));
    if (hasFrames())
        out.emplace_back("CREATE TABLE thermal_frame(time_s REAL NOT NULL, png BLOB NOT NULL)");
    return out;
}

std::string SessionTables::insertStep() const {
    std::string out = "INSERT INTO step VALUES(?";
    for (std::size_t k = 1; k < columnCount(m_names.size()); ++k)
        out += ", ?";
    return out + ')';
}

std::vector<SqlValue> SessionTables::stepRow(std::int64_t number, const TraceSample& sample) const {
    std::vector<SqlValue> row;
    row.reserve(columnCount(m_names.size()));
    row.emplace_back(number);
    row.push_back(sqlNumber(sample.time_s));
    for (const double value : columnsOfPose(sample.coordinates))
        row.push_back(sqlNumber(value));
    for (const RunColumn* column : runColumns())
        row.push_back(cellOf(*column, sample));
    if (sample.source == m_source)
        row.resize(row.size() + kPose.size());
    else
        for (const double value : columnsOfPose(sample.source))
            row.push_back(sqlNumber(value));
    for (const ObjectSample& object : sample.objects)
        for (const ObjectColumn* column : objectColumns())
            row.push_back(m_rig.has(column->needs) ? cellOf(*column, object) : SqlValue());
    return row;
}

std::string SessionTables::selectSteps() const {
    return "SELECT " + columnList(false) + " FROM step";
}

std::int64_t SessionTables::numberOfStep(SessionStore::Row row) {
    const auto* number = std::get_if<std::int64_t>(&row[kNumber]);
    return number == nullptr ? 0 : *number;
}

TraceSample SessionTables::sampleOf(SessionStore::Row row) const {
    TraceSample sample;
    sample.time_s = numberOf(row[kTime]);
    sample.coordinates = coordinatesOfColumns(row.subspan(kPoseAt));
    std::size_t at = kPoseAt + kPose.size();
    for (const RunColumn* column : runColumns())
        column->value.set(sample, numberOf(row[at++]));
    const bool isAsInExperiment = std::holds_alternative<std::monostate>(row[at]);
    sample.source = isAsInExperiment ? m_source : coordinatesOfColumns(row.subspan(at));
    at += kPose.size();
    sample.objects.resize(m_names.size());
    for (ObjectSample& object : sample.objects)
        for (const ObjectColumn* column : objectColumns())
            column->value.set(object, numberOf(row[at++]));
    return sample;
}

std::string impossibleNumbers(SessionStore::Row row) {
    for (const SqlValue& value : row)
        if (std::holds_alternative<std::string>(value) || std::holds_alternative<SqlBlob>(value))
            return "text instead of a number";
    return {};
}

std::string impossiblePose(SessionStore::Row columns) {
    constexpr double kUnit = 1e-3;
    double square = 0.0;
    bool isFinite = true, isKnown = false;
    for (std::size_t k = 0; k < kPose.size(); ++k) {
        const double value = numberOf(columns[k]);
        isKnown = isKnown || !std::holds_alternative<std::monostate>(columns[k]);
        isFinite = isFinite && std::isfinite(value);
        square += k < 3 ? 0.0 : value * value;
    }
    return !isKnown || (isFinite && std::abs(square - 1.0) < kUnit) ? std::string() : "a pose that is none";
}

std::string SessionTables::impossibleIn(SessionStore::Row row) const {
    if (std::string words = impossibleNumbers(row); !words.empty())
        return words;
    if (!std::isfinite(numberOf(row[kTime])))
        return "no time";
    if (std::string words = impossiblePose(row.subspan(kPoseAt)); !words.empty())
        return words;
    const SessionStore::Row source = row.subspan(kPoseAt + kPose.size() + runColumns().size(), kPose.size());
    const bool isAsInExperiment = std::ranges::all_of(
        source, [](const SqlValue& value) { return std::holds_alternative<std::monostate>(value); });
    if (std::string words = isAsInExperiment ? std::string() : impossiblePose(source); !words.empty())
        return words;
    std::string words;
    std::size_t at = kPoseAt + kPose.size();
    const auto check = [&](const auto& column) {
        if (std::string found = impossibleValue(column, numberOf(row[at++])); !found.empty())
            words = std::move(found);
    };
    for (const RunColumn* column : runColumns())
        check(*column);
    at += kPose.size();
    for (std::size_t i = 0; i < m_names.size(); ++i)
        for (const ObjectColumn* column : objectColumns())
            check(*column);
    return words;
}

Vector6d coordinatesOfColumns(SessionStore::Row columns) {
    Pose X = Pose::Identity();
    X.translation() << numberOf(columns[0]), numberOf(columns[1]), numberOf(columns[2]);
    const Eigen::Quaterniond q(numberOf(columns[3]), numberOf(columns[4]), numberOf(columns[5]),
                               numberOf(columns[6]));
    X.linear() = q.normalized().toRotationMatrix();
    return coordinatesFromPose(X);
}

} // namespace bask
