#include "app/commands/thermal_input.h"

#include <QCommandLineParser>

#include <cstdio>
#include <utility>

namespace bask {

Result<std::optional<ThermalProfile>> profileOption(const QCommandLineParser& parser) {
    if (!parser.isSet("profile"))
        return std::optional<ThermalProfile>();
    auto found = findThermalProfile(parser.value("profile").toStdString());
    if (!found)
        return found.error();
    return std::optional(std::move(*found));
}

void tellWarnings(const char* command, const std::string& path, const ThermalFrame& frame) {
    for (const Message& warning : frame.warnings)
        std::fprintf(stderr, "bask %s: %s: %s\n", command, path.c_str(), describe(warning).c_str());
}

} // namespace bask
