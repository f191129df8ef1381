// What it costs to divide a study, and to store a field that is larger than memory should be, beside the same
// work undivided and not stored. Each case takes a minute or more, and a gigabyte in TMPDIR.

#include "benchmarks/program_run.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace bask {
namespace {

/// A folder that is empty, and is gone afterwards.
class Folder {
public:
    Folder() : m_path(std::filesystem::temp_directory_path() / ("bask-cluster-" + std::to_string(getpid()))) {
        std::filesystem::remove_all(m_path);
        std::filesystem::create_directory(m_path);
    }
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(m_path, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string at(const std::string& name) const { return (m_path / name).string(); }

private:
    std::filesystem::path m_path;
};

/// 2,000 runs, two processes at a time with one thread each, merged; 1: by one process with two threads.
void study(benchmark::State& state) {
    const Folder folder;
    std::string script = "set -e; cd " + folder.at("") +
                         "; rm -rf out parts; bask=" BASK_PROGRAM
                         "; study='study closed-loop --controller adaptive --count 2000 --seed 7'; ";
    if (state.range(0) == 1) {
        script += "$bask $study --threads 2 -o out";
    } else {
        const std::string shards = std::to_string(state.range(0));
        script += "seq " + shards + " | xargs -P 2 -I {} $bask $study --threads 1 --shard {}/" + shards +
                  " --resume -o parts; $bask merge parts -o out";
    }
    programRun(state, {"/bin/sh", "-c", script});
}

/// 1.02e8 samples over six axes: a disk of 1.5 cm, mounted 4 cm aside, over one of 10 cm.
void field(benchmark::State& state, bool isStored) {
    const Folder folder;
    std::vector<std::string> words{BASK_PROGRAM,
                                   "field",
                                   BASK_EXAMPLES "/two-circles.json",
                                   "--object",
                                   "left",
                                   "--shade",
                                   "none",
                                   "--axes",
                                   "x=-0.1:0.1:0.01,y=-0.1:0.1:0.01,z=0.02:0.42:0.02,theta_x=-1:1:0.1,"
                                   "theta_y=-1:1:0.1,theta_z=0:2.4:0.1"};
    if (isStored)
        words.insert(words.end(), {"-o", folder.at("field.h5")});
    programRun(state, words);
}

BENCHMARK(study)->Arg(1)->Arg(7)->Arg(64)->Iterations(1)->Unit(benchmark::kSecond)->UseRealTime();
BENCHMARK_CAPTURE(field, computed, false)
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(field, stored, true)
    ->Iterations(1)
    ->Repetitions(3)
    ->Unit(benchmark::kSecond)
    ->UseRealTime();

} // namespace
} // namespace bask
