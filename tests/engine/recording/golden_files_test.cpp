// What the program writes against files that were looked at: all examples as JSON, and a recorded run as SQL
// and as NeXus. Times of day and versions are left out.

#include "engine/experiment/experiment_file.h"
#include "engine/recording/nexus_file.h"
#include "engine/runtime/simulated_run.h"
#include "tests/support/golden.h"

#include <QByteArray>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QSqlRecord>
#include <QTemporaryDir>
#include <QVariant>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <regex>
#include <vector>

#include <hdf5.h>

namespace bask {
namespace {

using test::expectGolden;

constexpr double kLibraries = 1e-6; ///< of fitted outlines
constexpr double kRun = 1e-5;       ///< of a run: what a library rounds otherwise goes through its controller

std::string plain(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}

/// Without what no two runs have alike.
std::string withoutTimes(std::string text) {
    static const std::regex kDate(R"(\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z)"),
        kUtc(R"(("\w+_utc_s":)[0-9.]+)"), kVersion(R"(Bask \d+\.\d+\.\d+)");
    text = std::regex_replace(text, kDate, "<time>");
    text = std::regex_replace(text, kUtc, "$1<time>");
    return std::regex_replace(text, kVersion, "Bask <version>");
}

/// Of lines of numbers: how many, their sum and the sum of their magnitudes.
std::string digest(const std::vector<std::string>& lines) {
    int count = 0;
    double sum = 0.0, magnitudes = 0.0;
    for (const std::string& line : lines)
        for (std::string_view rest = line; !rest.empty();) {
            const auto number = test::numberAt(rest);
            count += number ? 1 : 0;
            sum += number ? number->first : 0.0;
            magnitudes += number ? std::abs(number->first) : 0.0;
            rest.remove_prefix(number ? number->second : 1);
        }
    return std::to_string(count) + " numbers, of sum " + plain(sum) + " and magnitudes " + plain(magnitudes) +
           '\n';
}

/// With what is more than a few lines of numbers as the first of them and a digest.
std::string shortened(const std::string& text) {
    constexpr std::size_t kFew = 8;
    std::string out;
    std::vector<std::string> numbers;
    const auto put = [&] {
        const bool isLong = numbers.size() > kFew;
        for (std::size_t k = 0; k < (isLong ? 1 : numbers.size()); ++k)
            out += numbers[k] + '\n';
        if (isLong)
            out += digest(numbers);
        numbers.clear();
    };
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.find_first_not_of("[] ,0123456789.eE+-") == std::string::npos) {
            numbers.push_back(line);
            continue;
        }
        put();
        out += line + '\n';
    }
    put();
    return out;
}

// ---- SQL

std::string cell(const QVariant& value) {
    if (value.isNull())
        return "null";
    if (value.typeId() == QMetaType::QByteArray)
        return '<' + std::to_string(value.toByteArray().size()) + " bytes>";
    if (value.typeId() == QMetaType::Double)
        return plain(value.toDouble());
    return value.toString().toStdString();
}

/// Each table and view by its statement, and each table by columns: "step.x_m = 0 0.01 ...".
std::string sqlOf(const std::string& path) {
    std::string out;
    {
        QSqlDatabase file = QSqlDatabase::addDatabase("QSQLITE", "golden");
        file.setDatabaseName(QString::fromStdString(path));
        EXPECT_TRUE(file.open()) << file.lastError().text().toStdString();
        std::vector<QString> tables;
        QSqlQuery query(file);
        query.exec("SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL ORDER BY rowid");
        while (query.next()) {
            out += query.value(2).toString().toStdString() + '\n';
            if (query.value(0).toString() == "table")
                tables.push_back(query.value(1).toString());
        }
        for (const QString& pragma : {QStringLiteral("application_id"), QStringLiteral("user_version")}) {
            query.exec("PRAGMA " + pragma);
            query.next();
            out += pragma.toStdString() + " = " + cell(query.value(0)) + '\n';
        }
        for (const QString& table : tables) {
            query.exec("SELECT * FROM " + table);
            const QSqlRecord columns = query.record();
            std::vector<std::string> rows(static_cast<std::size_t>(columns.count()));
            while (query.next())
                for (int k = 0; k < columns.count(); ++k)
                    rows[static_cast<std::size_t>(k)] += ' ' + cell(query.value(k));
            for (int k = 0; k < columns.count(); ++k)
                out += (table + '.' + columns.fieldName(k)).toStdString() + " =" +
                       rows[static_cast<std::size_t>(k)] + '\n';
        }
    }
    QSqlDatabase::removeDatabase("golden");
    return withoutTimes(std::move(out));
}

// ---- NeXus

/// Numbers and texts of a data set or an attribute, read by `read` in a type of memory.
template <class Read> std::string valuesOf(hid_t type, hid_t space, Read read) {
    const auto count = static_cast<std::size_t>(H5Sget_simple_extent_npoints(space));
    std::string out;
    if (H5Tget_class(type) != H5T_STRING) {
        std::vector<double> values(count);
        read(H5T_NATIVE_DOUBLE, values.data());
        for (const double value : values)
            out += ' ' + plain(value);
    } else if (H5Tis_variable_str(type) > 0) {
        std::vector<char*> texts(count);
        read(type, texts.data());
        for (const char* text : texts)
            out += " \"" + std::string(text == nullptr ? "" : text) + '"';
        H5Dvlen_reclaim(type, space, H5P_DEFAULT, texts.data());
    } else {
        const std::size_t length = H5Tget_size(type);
        std::string texts(count * length, '\0');
        read(type, texts.data());
        for (std::size_t k = 0; k < count; ++k)
            out += " \"" + std::string(texts.substr(k * length, length).c_str()) + '"';
    }
    return out;
}

std::string typeName(hid_t type) {
    const std::string bits = std::to_string(8 * H5Tget_size(type));
    switch (H5Tget_class(type)) {
    case H5T_INTEGER:
        return (H5Tget_sign(type) == H5T_SGN_NONE ? "uint" : "int") + bits;
    case H5T_FLOAT:
        return "float" + bits;
    case H5T_STRING:
        return "text";
    default:
        return "type " + std::to_string(H5Tget_class(type));
    }
}

std::string shapeOf(hid_t space) {
    std::vector<hsize_t> shape(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    std::string out;
    for (const hsize_t each : shape)
        out += ' ' + std::to_string(each);
    return out.empty() ? " one" : out;
}

void dumpAttributes(hid_t object, const std::string& path, std::string& out) {
    for (hsize_t i = 0;; ++i) {
        const hid_t attribute =
            H5Aopen_by_idx(object, ".", H5_INDEX_NAME, H5_ITER_INC, i, H5P_DEFAULT, H5P_DEFAULT);
        if (attribute < 0)
            return;
        std::array<char, 200> name{};
        H5Aget_name(attribute, name.size(), name.data());
        const hid_t type = H5Aget_type(attribute), space = H5Aget_space(attribute);
        const bool isVersion = std::string_view(name.data()).find("ersion") != std::string_view::npos;
        out += path + '@' + name.data() + ':' +
               (isVersion ? std::string(" <version>")
                          : valuesOf(type, space,
                                     [&](hid_t memory, void* into) { H5Aread(attribute, memory, into); })) +
               '\n';
        H5Sclose(space);
        H5Tclose(type);
        H5Aclose(attribute);
    }
}

void dumpGroup(hid_t group, const std::string& path, std::string& out) { // NOLINT(misc-no-recursion)
    dumpAttributes(group, path, out);
    H5G_info_t info{};
    H5Gget_info(group, &info);
    for (hsize_t i = 0; i < info.nlinks; ++i) {
        std::array<char, 200> name{};
        H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size(), H5P_DEFAULT);
        const hid_t object = H5Oopen(group, name.data(), H5P_DEFAULT);
        const std::string inner = path + name.data();
        if (H5Iget_type(object) == H5I_GROUP) {
            dumpGroup(object, inner + '/', out);
        } else {
            const hid_t type = H5Dget_type(object), space = H5Dget_space(object);
            out += inner + " (" + typeName(type) + shapeOf(space) + "):" +
                   valuesOf(type, space,
                            [&](hid_t memory, void* into) {
                                H5Dread(object, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, into);
                            }) +
                   '\n';
            H5Sclose(space);
            H5Tclose(type);
            dumpAttributes(object, inner, out);
        }
        H5Oclose(object);
    }
}

std::string nexusOf(const std::string& path) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // the end of attributes is found by asking for one more
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    EXPECT_GE(file, 0) << path;
    const hid_t root = H5Gopen2(file, "/", H5P_DEFAULT);
    std::string out;
    dumpGroup(root, "/", out);
    H5Gclose(root);
    H5Fclose(file);
    return withoutTimes(std::move(out));
}

} // namespace

// Catches an experiment that is written in another way: a key, its place, a unit or a default that changed.
// What reads its own files back does not see it.
TEST(GoldenFiles, ExamplesAreWrittenAsTheyWere) {
    int examples = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(BASK_EXAMPLES)) {
        const std::filesystem::path& path = entry.path();
        const std::string name = std::filesystem::relative(path, BASK_EXAMPLES).string();
        if (path.extension() != ".json" || name == "paper/expected.json" || name.starts_with("recipes"))
            continue;
        const auto experiment = readExperiment(path.string());
        ASSERT_TRUE(experiment) << describe(experiment.error());
        expectGolden("examples/" + name, shortened(experimentToJson(*experiment)), kLibraries);
        ++examples;
    }
    EXPECT_GE(examples, 30);
}

// Catches a table, a column or an attribute that is lost, renamed, or has another unit or value.
TEST(GoldenFiles, ARunIsRecordedAndExportedAsItWas) {
    const auto experiment = readExperiment(BASK_EXAMPLES "/two-circles.json");
    ASSERT_TRUE(experiment) << describe(experiment.error());
    const QTemporaryDir folder;
    SimulatedRunOptions options;
    options.duration_s = 10.0;
    options.sessionPath = folder.filePath("run.bask").toStdString();
    options.labels = {"operator", "sample", "batch"};
    ASSERT_TRUE(runSimulated(*experiment, options));
    expectGolden("run.sql.txt", sqlOf(options.sessionPath), kRun);
    const auto record = readSession(options.sessionPath);
    ASSERT_TRUE(record) << describe(record.error());
    const auto nexus = exportNexus(*record, folder.path().toStdString());
    ASSERT_TRUE(nexus) << describe(nexus.error());
    expectGolden("run.nexus.txt", nexusOf(*nexus), kRun);
}

// Catches a comparison that takes anything.
TEST(GoldenFiles, LinesAreComparedByTheirNumbers) {
    EXPECT_TRUE(test::isSameLine("a 1.0000000001, x -2e-3", "a 1, x -0.002", 1e-9));
    EXPECT_FALSE(test::isSameLine("a 1.00001", "a 1", 1e-9));
    EXPECT_FALSE(test::isSameLine("a 1", "b 1", 1e-9));
    EXPECT_FALSE(test::isSameLine("a 1", "a 1 2", 1e-9));
    EXPECT_FALSE(test::isSameLine("a \"1\"", "a null", 1e-9));
    EXPECT_FALSE(test::isSameLine("a 0", "a 1e-9", 1e-9));
}

} // namespace bask
