#include "engine/recording/thermal_frames.h"

#include "engine/base/message_code.h"
#include "engine/recording/ro_crate.h"
#include "engine/recording/session_facts.h"
#include "engine/recording/session_file.h"
#include "engine/recording/session_store.h"
#include "engine/recording/session_verify.h"
#include "engine/recording/staged_files.h"
#include "engine/thermography/frame_picture_file.h"

#include <algorithm>

namespace bask {
namespace {

using TakeFrame = std::function<void(double time_s, const std::string& png)>;

Result<void> eachFrame(const SessionStore& store, const TakeFrame& take) {
    const auto columns = store.columns("thermal_frame");
    if (!columns || columns->empty())
        return columns ? Result<void>() : Result<void>(columns.error());
    return store.select("SELECT time_s, png FROM thermal_frame ORDER BY rowid", [&](SessionStore::Row row) {
        if (const auto* png = std::get_if<SqlBlob>(&row[1]))
            take(numberOf(row[0]), png->bytes);
    });
}

} // namespace

Result<void> readThermalFrames(const std::string& path, const TakeFrame& take) {
    const auto store = SessionStore::open(path);
    return store ? eachFrame(**store, take) : store.error();
}

Result<std::vector<double>> thermalFrameTimes(const std::string& path) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    const auto columns = (*store)->columns("thermal_frame");
    if (!columns)
        return columns.error();
    std::vector<double> times_s;
    Result<void> read;
    if (!columns->empty())
        read = (*store)->select("SELECT time_s FROM thermal_frame WHERE typeof(png) = 'blob' ORDER BY rowid",
                                [&](SessionStore::Row row) { times_s.push_back(numberOf(row[0])); });
    return read ? Result<std::vector<double>>(std::move(times_s)) : read.error();
}

Result<std::vector<std::string>> exportThermalFrames(const std::string& path, const std::string& folder,
                                                     const ShareDone& told) {
    const auto store = SessionStore::open(path);
    if (!store)
        return store.error();
    auto facts = readFacts(**store, path);
    if (!facts)
        return facts.error();
    facts->verification = verificationOf(path);
    const auto profile = thermalProfile(facts->experiment, facts->simulated);
    if (!profile)
        return Error(MessageCode::NoThermalFrames, path);
    auto files = StagedFiles::into(folder);
    if (!files)
        return files.error();
    Result<void> done;
    std::string times = "file,time_s\n";
    int number = 0;
    ShareCount count(told, roughRows(**store, "thermal_frame"));
    const auto read = eachFrame(**store, [&](double time_s, const std::string& png) {
        const std::string digits = std::to_string(++number);
        const std::string name =
            "frame_" + std::string(7 - std::min<std::size_t>(7, digits.size()), '0') + digits + ".tif";
        const auto counts = countsOfImage(png, *profile, path);
        if (done && !counts)
            done = counts.error();
        if (done)
            done = files->write(name, tiffOfCounts(*counts));
        times += name + ',' + formatNumber(time_s, 12) + '\n';
        count.add();
    });
    if (!read)
        return read.error();
    if (number == 0)
        return Error(MessageCode::NoThermalFrames, path);
    if (done)
        done = files->write("times.csv", times);
    if (done)
        done = addCrate(*files, *facts);
    if (!done)
        return done.error();
    tellShare(told, 1.0);
    return files->commit();
}

} // namespace bask
