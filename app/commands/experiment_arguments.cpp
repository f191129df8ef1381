#include "app/commands/experiment_arguments.h"

#include "engine/base/message_code.h"
#include "engine/base/units.h"

#include <QStringList>

#include <cmath>
#include <filesystem>

namespace bask {

Error badValue(const QString& option, const QString& value, const char* expected) {
    return Error(MessageCode::JsonWrongType, "--" + option.toStdString(),
                 {expected, "\"" + value.toStdString() + "\""});
}

Result<std::vector<double>> parseTargets(const QString& text) {
    std::vector<double> out;
    for (const QString& part : text.split(u',')) {
        bool ok = false;
        const double t_degC = part.trimmed().toDouble(&ok);
        if (!ok || !std::isfinite(t_degC))
            return badValue("targets", text, "temperatures in degC with commas between");
        out.push_back(kelvinFromCelsius(t_degC));
    }
    return out;
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
