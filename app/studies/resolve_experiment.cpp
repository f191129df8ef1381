// resolve_experiment IN.json OUT.json: at build time, writes an experiment without the files that it names. A
// study, and each shard of one, begins a tenth of a second earlier with coefficients than with pictures to be
// traced.

#include "engine/base/message.h"
#include "engine/experiment/experiment_file.h"

#include <cstdio>

int main(int argc, char** argv) {
    if (argc != 3)
        return 2;
    const auto experiment = bask::readExperiment(argv[1]);
    if (!experiment) {
        std::fprintf(stderr, "%s\n", bask::describe(experiment.error()).c_str());
        return 2;
    }
    const auto written = bask::writeExperiment(*experiment, argv[2]);
    if (!written)
        std::fprintf(stderr, "%s\n", bask::describe(written.error()).c_str());
    return written ? 0 : 2;
}
