#include "app/studies/shard_run.h"

#include "app/commands/command_line.h"
#include "app/commands/parse_command.h"
#include "app/commands/progress.h"
#include "app/exact_version.h"
#include "app/studies/study_output.h"
#include "engine/base/message_code.h"
#include "engine/base/parallel.h"
#include "engine/base/program_part.h"
#include "engine/radiation/kernels/kernels.h"

#include <QFile>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <thread>

#include <elf.h>
#include <link.h>

namespace bask {
namespace {

constexpr int kMaxThreads = 1024;

Error refusedShard(const char* option, const std::string& expected, const QString& found) {
    return {MessageCode::JsonWrongType, option, {expected, '"' + found.toStdString() + '"'}};
}

Result<std::optional<Shard>> readShard(const QCommandLineParser& parser) {
    if (!parser.isSet("shard"))
        return std::optional<Shard>();
    const QString text = parser.value("shard");
    const QStringList numbers = text.split(u'/');
    bool isNumber = numbers.size() == 2, isOf = isNumber;
    Shard shard;
    if (isNumber) {
        shard.number = numbers[0].toInt(&isNumber);
        shard.of = numbers[1].toInt(&isOf);
    }
    if (!isNumber || !isOf || shard.of < 1 || shard.of > kMaxShards || shard.number < 1 ||
        shard.number > shard.of)
        return refusedShard("--shard",
                            "i/N with i from 1 to N and N up to " + std::to_string(kMaxShards) + ", as 3/64",
                            text);
    return std::optional(shard);
}

Result<void> selectProcessor(const QString& name) {
    std::string known;
    const kernels::KernelList list = kernels::runnableKernels();
    for (int k = 0; k < list.count; ++k) {
        if (name == QLatin1String(list.sets[k]->name)) {
            kernels::useKernels(*list.sets[k]);
            return {};
        }
        known += (known.empty() ? "" : ", ") + std::string(list.sets[k]->name);
    }
    return Error(MessageCode::ValueUnknown, "--processor", {name.toStdString(), known});
}

/// The linker's identification of the build, in hex: the revision alone does not tell of changes since. Of
/// bask-draw, whose parts they are that `bask` computes.
std::string buildId() {
    QFile program(QString::fromStdString(programPart("bask-draw", {})));
    const uchar* const bytes = program.open(QIODevice::ReadOnly) ? program.map(0, program.size()) : nullptr;
    const auto size = static_cast<std::size_t>(program.size());
    ElfW(Ehdr) head;
    if (bytes == nullptr || size < sizeof head)
        return "unknown";
    std::memcpy(&head, bytes, sizeof head);
    for (std::size_t k = 0; k < head.e_phnum; ++k) {
        ElfW(Phdr) segment;
        const std::size_t at = head.e_phoff + k * sizeof segment;
        if (at + sizeof segment > size)
            break;
        std::memcpy(&segment, bytes + at, sizeof segment);
        if (segment.p_type != PT_NOTE || segment.p_offset + segment.p_filesz > size)
            continue;
        const std::size_t end = segment.p_offset + segment.p_filesz;
        for (std::size_t place = segment.p_offset; place + sizeof(ElfW(Nhdr)) <= end;) {
            ElfW(Nhdr) note;
            std::memcpy(&note, bytes + place, sizeof note);
            place += sizeof note + ((note.n_namesz + 3U) & ~3U);
            constexpr std::size_t kShown = 8;
            if (note.n_type == NT_GNU_BUILD_ID && place + note.n_descsz <= end)
                return QByteArray(reinterpret_cast<const char*>(bytes + place),
                                  static_cast<int>(std::min<std::size_t>(kShown, note.n_descsz)))
                    .toHex()
                    .toStdString();
            place += (note.n_descsz + 3U) & ~3U;
        }
    }
    return "unknown";
}

} // namespace

std::string ownSoftware() {
    return "Bask " + exactVersion().toStdString() + ", build " + buildId();
}

void addShardOptions(QCommandLineParser& parser) {
    parser.addOptions(
        {{"shard",
          "Computes every N-th case from the i-th on, into a part beside the output, for bask merge (see\n"
          "docs/clusters.md).",
          "i/N"},
         {"resume", "With --shard: goes on with the part if there is one."},
         {"threads", "Threads to compute with, 1 to 1024; one for each core unless given.", "N"},
         {"processor",
          "baseline, avx2 or avx512: whose instructions compute view factors; the best of this computer "
          "unless\n"
          "given. The parts of one work must have one kind.",
          "KIND"}});
}

Result<ShardOptions> readShardOptions(const QCommandLineParser& parser) {
    ShardOptions options;
    const auto shard = readShard(parser);
    if (!shard)
        return shard.error();
    options.shard = *shard;
    options.resumes = parser.isSet("resume");
    if (options.resumes && !options.shard)
        return refusedShard("--resume", "--shard with it (1/1 for one process)", "nothing");
    if (parser.isSet("threads")) {
        bool isNumber = false;
        options.threads = parser.value("threads").toInt(&isNumber);
        if (!isNumber || options.threads < 1 || options.threads > kMaxThreads)
            return refusedShard("--threads", "a whole number from 1 to " + std::to_string(kMaxThreads),
                                parser.value("threads"));
    }
    if (parser.isSet("processor"))
        if (auto selected = selectProcessor(parser.value("processor")); !selected)
            return selected.error();
    return options;
}

std::string fullWork(const std::string& asked) {
    auto work = nlohmann::json::parse(asked);
    work["software"] = ownSoftware();
    work["processor"] = kernels::kernels().name;
    return work.dump();
}

std::string partPath(const std::string& stem, const Shard& shard) {
    const std::string of = std::to_string(shard.of);
    std::string number = std::to_string(shard.number);
    number.insert(0, of.size() - number.size(), '0'); // sorted by name they are in order
    return stem + '.' + number + "-of-" + of + ".part";
}

int runShard(const char* command, const std::string& stem, const DividedWork& work,
             const ShardOptions& options) {
    const std::string path = partPath(stem, *options.shard);
    const int threads = options.threads > 0
                            ? options.threads
                            : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    auto part =
        PartWriter::open(path, {fullWork(work.asked), work.cases, *options.shard, threads}, options.resumes);
    if (!part)
        return refuse(command, part.error());
    const std::vector<std::int64_t>& missing = (*part)->missing();
    std::mutex mutex;
    std::optional<Error> failed;
    std::atomic<bool> isOver = false;
    const auto keep = [&](std::int64_t index, const Result<std::string>& record, double took_s) {
        const std::lock_guard lock(mutex);
        if (failed)
            return;
        auto kept = record ? (*part)->add(index, *record, took_s) : Result<void>(record.error());
        if (!kept)
            failed = kept.error();
        isOver = failed.has_value();
    };
    {
        Progress progress(static_cast<double>(missing.size()), work.caseWord);
        runInParallel(
            static_cast<int>(missing.size()), options.threads,
            [&](int k) {
                if (isOver)
                    return;
                const auto start = std::chrono::steady_clock::now();
                const std::int64_t index = missing[static_cast<std::size_t>(k)];
                const auto record = work.compute(index);
                const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
                keep(index, record, took.count());
            },
            [&](int done) { progress.tell(done); });
    }
    if (!failed)
        if (const auto finished = (*part)->finish(); !finished)
            failed = finished.error();
    if (failed)
        return refuse(command, *failed);
    std::printf("%s: %lld %s\n", path.c_str(), static_cast<long long>(options.shard->share(work.cases)),
                work.caseWord.c_str());
    return kExitDone;
}

} // namespace bask
