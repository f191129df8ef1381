// bask view-factor: reads cases (source, object, pose) from a JSON file and answers each with F21 and its
// gradient.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/commands/shape_json.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/text_file.h"
#include "engine/radiation/shade.h"

#include <QCommandLineParser>
#include <QFile>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

namespace bask {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr qint64 kMaxShapeBytes = qint64{256} << 20;

// Bare words such as NaN and numbers too large for a double are no JSON, yet they spoil one case, not the
// file: they are put in quotes, and the case that they stand in is then refused with their place.
std::string withOddNumbersQuoted(const std::string& text) {
    std::string result;
    result.reserve(text.size());
    const auto isWord = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '+' || c == '-' || c == '.';
    };
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i + 1;
        bool quote = false;
        if (text[i] == '"') {
            while (end < text.size() && text[end] != '"')
                end += text[end] == '\\' ? 2 : 1;
            end = std::min(end + 1, text.size());
        } else if (isWord(text[i])) {
            while (end < text.size() && isWord(text[end]))
                ++end;
            const std::string word = text.substr(i, end - i);
            char* rest = nullptr;
            const double value = std::strtod(word.c_str(), &rest);
            quote = *rest == '\0' && !std::isfinite(value);
        }
        if (quote)
            result += '"';
        result.append(text, i, end - i);
        if (quote)
            result += '"';
        i = end;
    }
    return result;
}

// A case as it stands in the file; with blockers if it has a list of them, even an empty one.
struct Case {
    Shape source, object;
    Pose X_SO;
    std::optional<std::vector<Blocker>> blockers;
};

// What an answer says of a case, and how exact it is known: a case may carry it, for comparison.
constexpr std::array<const char*, 8> kAnswerKeys{"view_factor",    "unshaded",          "gradient",
                                                 "gradient_rigid", "error_estimate",    "visibility",
                                                 "tolerance",      "gradient_tolerance"};
constexpr double kTolerance = 1e-13, kShadeTolerance = 1e-11;

Result<Case> readCase(const json& one) {
    Case result;
    Failure failure;
    Fields fields(one, {}, failure);
    if (const json* id = fields.find("id", true); id && !id->is_string() && !id->is_number_integer())
        fields.fail(MessageCode::JsonWrongType, "id", {"text", typeName(*id)});
    const auto part = [&](Fields& of, const char* key, auto& out, auto read) {
        readPart(of, key, true,
                 [&](const json& j, const std::string& path) { out = read(j, path, failure); });
    };
    part(fields, "source", result.source, readCaseShape);
    part(fields, "object", result.object, readCaseShape);
    part(fields, "pose", result.X_SO, readCasePose);
    if (fields.find("blockers", false))
        result.blockers.emplace();
    readEach(fields, "blockers", false, [&](const json& j, const std::string& path) {
        Shape shape;
        Pose X_SB;
        Fields blocker(j, path, failure);
        part(blocker, "shape", shape, readCaseShape);
        part(blocker, "pose", X_SB, readCasePose);
        blocker.close();
        if (!failure)
            result.blockers->push_back({RadiatingContour(shape), X_SB});
    });
    for (const char* key : kAnswerKeys)
        fields.find(key, false);
    fields.close();
    if (failure)
        return *failure;
    return result;
}

ordered_json numbers(const Vector6d& values) {
    ordered_json list = ordered_json::array();
    for (double value : values)
        list.push_back(value + 0.0); // no minus zero
    return list;
}

void evaluate(const Case& one, ordered_json& result) {
    const RadiatingContour source(one.source), object(one.object);
    if (!one.blockers) {
        const ViewFactor factor = viewFactor(source, object, one.X_SO, {.tolerance = kTolerance});
        result["view_factor"] = factor.value;
        result["gradient"] = numbers(factor.gradient);
        result["visibility"] = visibilityName(factor.visibility);
        result["error_estimate"] = factor.errorEstimate;
        return;
    }
    const ShadedViewFactor factor =
        shadedViewFactor(source, object, one.X_SO, *one.blockers,
                         {.unshaded = {.tolerance = kTolerance}, .tolerance = kShadeTolerance});
    result["view_factor"] = factor.value;
    result["unshaded"] = factor.unshaded;
    result["gradient"] = numbers(factor.gradient);
    result["gradient_rigid"] = numbers(factor.gradientRigid);
    result["visibility"] = visibilityName(factor.visibility);
    result["error_estimate"] = factor.errorEstimate;
}

ordered_json answer(const json& one) {
    ordered_json result;
    result["id"] = one.is_object() && one.contains("id") ? ordered_json(one["id"]) : ordered_json(nullptr);
    try {
        if (const auto read = readCase(one); read)
            evaluate(*read, result);
        else
            result["error"] = describe(read.error());
    } catch (const std::invalid_argument& refused) {
        result["error"] = refused.what();
    }
    return result;
}

// One result a line; the library writes each number with as many digits as it takes to read it back
// unchanged.
Result<std::string> answersTo(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.exists())
        return Error{MessageCode::FileNotFound, path};
    if (!file.open(QIODevice::ReadOnly))
        return Error{MessageCode::FileUnreadable, path, {file.errorString().toStdString()}};
    const QByteArray bytes = file.read(kMaxShapeBytes + 1);
    if (file.error() != QFile::NoError)
        return Error{MessageCode::FileUnreadable, path, {file.errorString().toStdString()}};
    if (bytes.size() > kMaxShapeBytes)
        return Error{MessageCode::FileTooLarge, path, {"more than 256 MiB", "256 MiB"}};
    if (bytes.trimmed().isEmpty())
        return Error{MessageCode::FileEmpty, path};
    std::string text = "{\"results\": [";
    const char* separator = "\n";
    Failure failure;
    try {
        const json document = json::parse(withOddNumbersQuoted(bytes.toStdString()));
        Fields root(document, {}, failure);
        const auto cases = document.find("cases");
        Progress progress(cases != document.end() ? static_cast<double>(cases->size()) : 0.0, "cases");
        double answered = 0.0;
        readEach(root, "cases", true, [&](const json& one, const std::string&) {
            progress.tell(answered++);
            text += separator + answer(one).dump(-1, ' ', false, json::error_handler_t::replace);
            separator = ",\n";
        });
        root.close(Fields::Unknown::Ignored);
    } catch (const json::exception& refused) {
        failure = Error{MessageCode::JsonSyntax, {}, {plainWords(refused.what())}};
    }
    if (failure)
        return located(*failure, path);
    return text + "\n]}\n";
}

} // namespace

int viewFactorCommand(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        "Answers each case of CASES.json with the view factor F21 of the object over the source, its six\n"
        "derivatives (1/m and 1/rad, source axes, about the object's origin), what is visible and an\n"
        "estimate of the error. \"blockers\" are thin opaque plates in the source's frame; a case with them\n"
        "is answered with their shade, the view factor without them (\"unshaded\"), and the derivatives\n"
        "for a motion of the object alone (\"gradient\") and of object and blockers as one\n"
        "(\"gradient_rigid\"). What an answer says may stand in a case too and is read over. A case that\n"
        "cannot be answered gets an \"error\" in words.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption(
        {{"o", "output"}, "Writes the results there instead of to standard output.", "RESULTS.json"});
    parser.addPositionalArgument(
        "CASES.json",
        "{\"cases\": [{\"id\", \"source\", \"object\", \"pose\": {\"translation_m\", "
        "\"rotation_vector_rad\"}, \"blockers\": [{\"shape\", \"pose\"}]}]}; lengths in metres.");
    if (const auto code = parseCommand(parser, "view-factor", arguments, 1))
        return *code;
    const std::string path = parser.positionalArguments().front().toStdString();
    std::vector<OutputFile> outputs;
    if (parser.isSet("output"))
        outputs = {{parser.value("output").toStdString(), "results", "a list of results written by Bask"}};
    if (const auto place = checkOutputs({path}, outputs); !place)
        return refuse("view-factor", place.error());
    const auto text = answersTo(path);
    if (!text)
        return refuse("view-factor", text.error());
    if (outputs.empty())
        std::fwrite(text->data(), 1, text->size(), stdout);
    for (const OutputFile& output : outputs)
        if (const auto written = writeTextFile(output.path, *text); !written)
            return refuse("view-factor", written.error());
    return kExitDone;
}

} // namespace bask
