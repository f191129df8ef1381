// bask view-factor: reads cases (source, object, pose) from a JSON file and answers each with F21 and its
// gradient.

#include "app/commands/command_line.h"
#include "app/commands/output_file.h"
#include "app/commands/parse_command.h"
#include "app/commands/shape_json.h"
#include "engine/base/json_fields.h"
#include "engine/base/message_code.h"
#include "engine/base/plain_text.h"
#include "engine/experiment/text_file.h"
#include "engine/radiation/view_factor.h"

#include <QCommandLineParser>
#include <QFile>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace bask {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr qint64 kMaxBytes = qint64{256} << 20;

int refuse(const Error& error) {
    std::fprintf(stderr, "bask view-factor: %s\n", describe(error).c_str());
    return kExitBadInput;
}

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

Result<ViewFactor> evaluate(const json& one) {
    Shape source, object;
    Pose pose;
    Failure failure;
    Fields fields(one, {}, failure);
    if (const json* id = fields.find("id", true); id && !id->is_string() && !id->is_number_integer())
        fields.fail(MessageCode::JsonWrongType, "id", {"text", typeName(*id)});
    const auto part = [&](const char* key, auto& out, auto read) {
        readPart(fields, key, true,
                 [&](const json& j, const std::string& path) { out = read(j, path, failure); });
    };
    part("source", source, readCaseShape);
    part("object", object, readCaseShape);
    part("pose", pose, readCasePose);
    if (one.is_object() && one.contains("blockers")) // without their shade the answer would be another one
        fields.fail(MessageCode::JsonUnknownKey, {}, {"blockers", "id, source, object, pose"});
    fields.close(Fields::Unknown::Ignored);
    if (failure)
        return *failure;
    return viewFactor(RadiatingContour(source), RadiatingContour(object), pose, {.tolerance = 1e-13});
}

ordered_json answer(const json& one) {
    ordered_json result;
    result["id"] = one.is_object() && one.contains("id") ? ordered_json(one["id"]) : ordered_json(nullptr);
    try {
        const auto factor = evaluate(one);
        if (!factor) {
            result["error"] = describe(factor.error());
            return result;
        }
        result["view_factor"] = factor->value;
        result["gradient"] = ordered_json::array();
        for (double component : factor->gradient)
            result["gradient"].push_back(component + 0.0); // no minus zero
        result["visibility"] = visibilityName(factor->visibility);
        result["error_estimate"] = factor->errorEstimate;
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
    const QByteArray bytes = file.read(kMaxBytes + 1);
    if (file.error() != QFile::NoError)
        return Error{MessageCode::FileUnreadable, path, {file.errorString().toStdString()}};
    if (bytes.size() > kMaxBytes)
        return Error{MessageCode::FileTooLarge, path, {"more than 256 MiB", "256 MiB"}};
    if (bytes.trimmed().isEmpty())
        return Error{MessageCode::FileEmpty, path};
    std::string text = "{\"results\": [";
    const char* separator = "\n";
    Failure failure;
    try {
        const json document = json::parse(withOddNumbersQuoted(bytes.toStdString()));
        Fields root(document, {}, failure);
        readEach(root, "cases", true, [&](const json& one, const std::string&) {
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
        "estimate of the error. A case that cannot be answered gets an \"error\" in words.");
    parser.addOption({{"h", "help"}, "Displays this help."});
    parser.addOption(
        {{"o", "output"}, "Writes the results there instead of to standard output.", "RESULTS.json"});
    parser.addPositionalArgument(
        "CASES.json", "{\"cases\": [{\"id\", \"source\", \"object\", \"pose\": {\"translation_m\", "
                      "\"rotation_vector_rad\"}}]}; lengths in metres.");
    if (const auto code = parseCommand(parser, "view-factor", arguments, 1))
        return *code;
    const std::string path = parser.positionalArguments().front().toStdString();
    std::vector<OutputFile> outputs;
    if (parser.isSet("output"))
        outputs = {{parser.value("output").toStdString(), "results", "a list of results written by Bask"}};
    if (const auto place = checkOutputs({path}, outputs); !place)
        return refuse(place.error());
    const auto text = answersTo(path);
    if (!text)
        return refuse(text.error());
    if (outputs.empty())
        std::fwrite(text->data(), 1, text->size(), stdout);
    for (const OutputFile& output : outputs)
        if (const auto written = writeTextFile(output.path, *text); !written)
            return refuse(written.error());
    return kExitDone;
}

} // namespace bask
