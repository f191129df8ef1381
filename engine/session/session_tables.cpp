#include "engine/session/session_tables.h"

#include "engine/base/pose.h"

#include <array>
#include <charconv>
#include <limits>

namespace bask {
namespace {

constexpr const char* kMadeFirst[] = {
    "CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID",
    "CREATE TABLE experiment(json TEXT NOT NULL)",
    "CREATE TABLE object(number INTEGER PRIMARY KEY, name TEXT NOT NULL)",
};
constexpr const char* kMadeLast[] = {
    "CREATE TABLE command(time_s REAL NOT NULL, name TEXT NOT NULL, value TEXT NOT NULL)",
    "CREATE TABLE event(time_s REAL NOT NULL, code TEXT NOT NULL, args TEXT NOT NULL, text TEXT NOT NULL)",
    "CREATE TABLE note(time_s REAL NOT NULL, text TEXT NOT NULL)",
    "CREATE TABLE target_step(time_s REAL NOT NULL, object INTEGER NOT NULL, target_K REAL)",
    "CREATE TABLE overview(last_step INTEGER PRIMARY KEY, extremes BLOB NOT NULL)",
};

constexpr std::array kPose{"x_m", "y_m", "z_m", "qw", "qx", "qy", "qz"};
constexpr std::array kMotion{
    "vx_m_s", "vy_m_s", "vz_m_s", "wx_rad_s", "wy_rad_s", "wz_rad_s", "smallest_singular_value"};
constexpr std::array kObject{"measured_K",  "estimated_K",   "rate_K_s",      "target_K",     "view_factor",
                             "lambda1_K_s", "lambda2_1_K3s", "reading_valid", "temperature_K"};
constexpr std::size_t kObjectColumns = kObject.size();
constexpr std::size_t kValid = 7; ///< of them

/// Columns of `step` before the objects'.
enum Column : std::size_t {
    kNumber,
    kTime,
    kPoseAt,
    kMotionAt = kPoseAt + 7,
    kLimited = kMotionAt + 7,
    kSourceTemperature,
    kSourceAt,
    kObjectsAt = kSourceAt + 7,
};

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

/// Names and, where `typed`, types of all columns of `step`.
std::string columnList(std::size_t objects, bool typed) {
    const char* const real = typed ? " REAL" : "";
    const char* const whole = typed ? " INTEGER NOT NULL" : "";
    std::string out = typed ? "number INTEGER PRIMARY KEY, time_s REAL NOT NULL" : "number, time_s";
    const auto add = [&](const std::string& name, const char* type) { out += ", " + name + type; };
    for (const char* name : kPose)
        add(name, real);
    for (const char* name : kMotion)
        add(name, real);
    add("limited", whole);
    add("source_K", real);
    for (const char* name : kPose)
        add(std::string("source_") + name, real);
    for (std::size_t i = 0; i < objects; ++i)
        for (std::size_t k = 0; k < kObjectColumns; ++k)
            add(columnOf(kObject[k], i), k == kValid ? whole : real);
    return out;
}

/// A view with one row a sample and object: columns kObject[first, last).
std::string objectView(const char* name, std::size_t first, std::size_t last, std::size_t objects,
                       const char* condition = "") {
    std::string out = std::string("CREATE VIEW ") + name + " AS SELECT time_s, name AS object";
    for (std::size_t k = first; k < last; ++k) {
        out += ", CASE object.number";
        for (std::size_t i = 0; i < objects; ++i)
            out += " WHEN " + std::to_string(i + 1) + " THEN " + columnOf(kObject[k], i);
        out += std::string(" END AS ") + kObject[k];
    }
    return out + " FROM step CROSS JOIN object" + condition; // in this order: samples, then objects
}

template <class Names> std::string rigView(const char* name, const Names& columns) {
    std::string out = std::string("CREATE VIEW ") + name + " AS SELECT time_s";
    for (const std::string& column : columns)
        out += ", " + column;
    return out + " FROM step";
}

} // namespace

SessionTables::SessionTables(const Experiment& experiment, bool simulated)
    : m_source(experiment.source.pose), m_simulated(simulated) {
    for (const ObjectSpec& object : experiment.objects)
        m_names.push_back(object.name);
}

std::vector<std::string> SessionTables::create() const {
    std::vector<std::string> out(std::begin(kMadeFirst), std::end(kMadeFirst));
    for (std::size_t i = 0; i < m_names.size(); ++i)
        out.push_back("INSERT INTO object VALUES(" + std::to_string(i + 1) + ", " + sqlText(m_names[i]) +
                      ')');
    out.push_back("CREATE TABLE step(" + columnList(m_names.size(), true) + ')');

    out.push_back(objectView("sample", 0, 5, m_names.size()));
    out.push_back(objectView("object_state", 5, 8, m_names.size()));
    out.push_back(objectView("truth", 8, 9, m_names.size(), m_simulated ? "" : " WHERE 0"));
    const std::vector<std::string> pose(kPose.begin(), kPose.end());
    std::vector<std::string> motion(kMotion.begin(), kMotion.end()), sourcePose;
    motion.emplace_back("limited");
    const auto source = columnsOfPose(m_source);
    for (std::size_t k = 0; k < kPose.size(); ++k)
        sourcePose.push_back(std::string("ifnull(source_") + kPose[k] + ", " + digits(source[k]) + ") AS " +
                             kPose[k]);
    out.push_back(rigView("pose", pose));
    out.push_back(rigView("motion", motion));
    out.push_back(rigView("source", std::vector<std::string>{"source_K AS temperature_K"}));
    out.push_back(rigView("source_pose", sourcePose));
    out.insert(out.end(), std::begin(kMadeLast), std::end(kMadeLast));
    return out;
}

std::string SessionTables::insertStep() const {
    const std::size_t columns = kObjectsAt + kObjectColumns * m_names.size();
    std::string out = "INSERT INTO step VALUES(?";
    for (std::size_t k = 1; k < columns; ++k)
        out += ", ?";
    return out + ')';
}

std::vector<SqlValue> SessionTables::stepRow(std::int64_t number, const TraceSample& sample) const {
    std::vector<SqlValue> row;
    row.reserve(kObjectsAt + kObjectColumns * m_names.size());
    row.emplace_back(number);
    row.push_back(sqlNumber(sample.time_s));
    for (const double value : columnsOfPose(sample.coordinates))
        row.push_back(sqlNumber(value));
    for (int k = 0; k < 6; ++k)
        row.push_back(sqlNumber(sample.twist[k]));
    row.push_back(sqlNumber(sample.smallestSingularValue));
    row.emplace_back(std::int64_t{sample.limits.bits});
    row.push_back(sqlNumber(sample.source_K));
    if (sample.source == m_source)
        row.resize(row.size() + kPose.size());
    else
        for (const double value : columnsOfPose(sample.source))
            row.push_back(sqlNumber(value));
    for (const ObjectSample& o : sample.objects) {
        for (const double value :
             {o.measured_K, o.estimated_K, o.rate_K_s, o.target_K, o.viewFactor, o.lambda1, o.lambda2})
            row.push_back(sqlNumber(value));
        row.emplace_back(std::int64_t{o.valid});
        row.push_back(m_simulated ? sqlNumber(o.true_K) : SqlValue());
    }
    return row;
}

std::string SessionTables::selectSteps() const {
    return "SELECT " + columnList(m_names.size(), false) + " FROM step";
}

std::int64_t SessionTables::numberOfStep(SessionStore::Row row) {
    const auto* number = std::get_if<std::int64_t>(&row[kNumber]);
    return number == nullptr ? 0 : *number;
}

TraceSample SessionTables::sampleOf(SessionStore::Row row) const {
    TraceSample sample;
    sample.time_s = numberOf(row[kTime]);
    sample.coordinates = coordinatesOfColumns(row.subspan(kPoseAt));
    for (int k = 0; k < 6; ++k)
        sample.twist[k] = numberOf(row[kMotionAt + static_cast<std::size_t>(k)]);
    sample.smallestSingularValue = numberOf(row[kMotionAt + 6]);
    sample.limits = limitsOf(row[kLimited]);
    sample.source_K = numberOf(row[kSourceTemperature]);
    const bool isAsInExperiment = std::holds_alternative<std::monostate>(row[kSourceAt]);
    sample.source = isAsInExperiment ? m_source : coordinatesOfColumns(row.subspan(kSourceAt));
    sample.objects.resize(m_names.size());
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        ObjectSample& o = sample.objects[i];
        const auto columns = row.subspan(kObjectsAt + kObjectColumns * i, kObjectColumns);
        std::size_t k = 0;
        for (double* value :
             {&o.measured_K, &o.estimated_K, &o.rate_K_s, &o.target_K, &o.viewFactor, &o.lambda1, &o.lambda2})
            *value = numberOf(columns[k++]);
        o.valid = numberOf(columns[kValid]) == 1.0;
        o.true_K = numberOf(columns[kValid + 1]);
    }
    return sample;
}

Vector6d coordinatesOfColumns(SessionStore::Row columns) {
    Pose X = Pose::Identity();
    X.translation() << numberOf(columns[0]), numberOf(columns[1]), numberOf(columns[2]);
    const Eigen::Quaterniond q(numberOf(columns[3]), numberOf(columns[4]), numberOf(columns[5]),
                               numberOf(columns[6]));
    X.linear() = q.normalized().toRotationMatrix();
    return coordinatesFromPose(X);
}

ActiveLimits limitsOf(const SqlValue& value) {
    const double bits = numberOf(value);
    ActiveLimits limits;
    limits.bits = bits >= 0.0 && bits < 4096.0 ? static_cast<unsigned>(bits) : 0U;
    return limits;
}

} // namespace bask
