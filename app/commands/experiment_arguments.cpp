#include "app/commands/experiment_arguments.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"
#include "engine/model/mounting_check.h"

#include <QCommandLineParser>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace bask {

Error badValue(const QString& option, const QString& value, const char* expected) {
    return Error(MessageCode::JsonWrongType, "--" + option.toStdString(),
                 {expected, "\"" + value.toStdString() + "\""});
}

Result<double> finiteNumber(const QString& text, const std::string& where) {
    bool ok = false;
    const double value = text.trimmed().toDouble(&ok);
    if (!ok || !std::isfinite(value))
        return Error(MessageCode::JsonWrongType, where, {"a finite number", '"' + text.toStdString() + '"'});
    return value;
}

Result<const ObjectSpec*> chosenObject(const QCommandLineParser& parser, const Experiment& experiment) {
    if (!parser.isSet("object") && experiment.objects.size() == 1)
        return &experiment.objects.front();
    std::string names;
    for (const ObjectSpec& object : experiment.objects)
        names += (names.empty() ? "" : ", ") + object.name;
    if (!parser.isSet("object"))
        return Error(MessageCode::JsonWrongType, "--object", {"one of " + names, "nothing"});
    const std::string name = parser.value("object").toStdString();
    const auto found = std::ranges::find(experiment.objects, name, &ObjectSpec::name);
    if (found == experiment.objects.end())
        return Error(MessageCode::ValueUnknown, "--object", {name, names});
    return &*found;
}

Result<void> replaceTargets(const QCommandLineParser& parser, Experiment& experiment) {
    if (!parser.isSet("targets"))
        return {};
    const QString text = parser.value("targets");
    std::vector<double> targets_K;
    for (const QString& part : text.split(u',')) {
        bool ok = false;
        const double t_degC = part.trimmed().toDouble(&ok);
        if (!ok || !std::isfinite(t_degC))
            return badValue("targets", text, "temperatures in degC with commas between");
        targets_K.push_back(kelvinFromCelsius(t_degC));
    }
    return setTargets(experiment, targets_K);
}

Result<void> replaceSourceModel(const QCommandLineParser& parser, Experiment& experiment) {
    if (!parser.isSet("source-model"))
        return {};
    const std::string model = parser.value("source-model").toStdString();
    if (model != "gray" && model != "paper")
        return Error(MessageCode::ValueUnknown, "--source-model", {model, "gray, paper"});
    experiment.source.model = model == "paper" ? SourceModel::Paper : SourceModel::Gray;
    return {};
}

void warnOfOverlaps(const char* command, const Experiment& experiment) {
    for (const MountingRemark& remark : overlapsInPlane(experiment))
        std::fprintf(stderr, "bask %s: %s\n", command, describe(remark.message).c_str());
}

std::vector<std::string> inputsOf(const std::string& path, const Experiment& experiment) {
    std::vector<std::string> inputs{path};
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const auto add = [&](const ContourOrigin& origin) {
        if (!origin.file.empty())
            inputs.push_back((folder / origin.file).string());
    };
    add(experiment.source.origin);
    for (const ObjectSpec& object : experiment.objects)
        add(object.origin);
    return inputs;
}

} // namespace bask
