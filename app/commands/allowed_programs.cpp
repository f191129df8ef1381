#include "app/commands/allowed_programs.h"

#include "engine/drivers/driver_catalogue.h"

namespace bask {

Result<std::vector<Command>> allowedPrograms(const Experiment& experiment) {
    std::vector<Command> out;
    Result<void> failed;
    const auto add = [&](const auto& spec) {
        if (!spec || driverOf(*spec).link != DriverLink::Program)
            return;
        if (const auto files = programFiles(spec->port))
            out.push_back(ConfirmProgram{spec->port, files->hash, false});
        else
            failed = files.error();
    };
    if (experiment.rig) {
        add(experiment.rig->robot);
        add(experiment.rig->thermometer);
        add(experiment.rig->source);
    }
    if (!failed)
        return failed.error();
    return out;
}

} // namespace bask
