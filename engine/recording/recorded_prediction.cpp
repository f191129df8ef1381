#include "engine/recording/recorded_prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace bask {
namespace {

/// In the order of PredictedEnd.
constexpr std::array kEndWords{"settled", "limit", "cut", "fault"};
constexpr std::size_t kMaxSets = 8; // more of them than a run makes are not read

/// Puts a row into its sample: a moment has a row of each object, and another set begins where time goes
/// back.
void take(PredictedRun& run, std::size_t object, std::size_t objects, SessionStore::Row row) {
    const double time_s = numberOf(row[0]);
    if (!std::isfinite(time_s))
        return;
    if (!run.samples.empty() && time_s < run.samples.back().time_s)
        run.samples.clear();
    if (run.samples.empty() || time_s > run.samples.back().time_s) {
        const std::vector<double> unknown(objects, std::numeric_limits<double>::quiet_NaN());
        PredictedSample sample;
        sample.time_s = time_s;
        sample.temperatures_K = sample.lowest_K = sample.highest_K = unknown;
        run.samples.push_back(std::move(sample));
    }
    PredictedSample& sample = run.samples.back();
    sample.temperatures_K[object] = numberOf(row[2]);
    sample.lowest_K[object] = numberOf(row[3]);
    sample.highest_K[object] = numberOf(row[4]);
}

} // namespace

const char* predictedEndWord(PredictedEnd end) {
    return kEndWords.at(static_cast<std::size_t>(end));
}

Result<PredictedRun> readPrediction(const SessionStore& store, const std::vector<std::string>& objects) {
    PredictedRun run;
    const auto columns = store.columns("prediction");
    if (!columns)
        return columns.error();
    if (columns->empty())
        return run;
    const std::size_t most = kMaxSets * PredictedRun::kMaxSamples * std::max<std::size_t>(objects.size(), 1);
    auto read = store.select("SELECT time_s, object, temperature_K, lowest_K, highest_K FROM prediction "
                             "ORDER BY rowid LIMIT " +
                                 std::to_string(most),
                             [&](SessionStore::Row row) {
                                 const auto found = std::ranges::find(objects, textOf(row[1]));
                                 if (found != objects.end())
                                     take(run, static_cast<std::size_t>(found - objects.begin()),
                                          objects.size(), row);
                             });
    if (read)
        read = store.select(std::string("SELECT value FROM meta WHERE key = '") + kPredictedEndKey + '\'',
                            [&](SessionStore::Row row) {
                                const auto found = std::ranges::find(kEndWords, textOf(row[0]));
                                if (found != kEndWords.end())
                                    run.end = static_cast<PredictedEnd>(found - kEndWords.begin());
                            });
    if (!read)
        return read.error();
    const bool hasBand = std::ranges::any_of(run.samples, [](const PredictedSample& sample) {
        return std::ranges::any_of(sample.lowest_K, [](double K) { return std::isfinite(K); });
    });
    for (PredictedSample& sample : run.samples)
        if (!hasBand) {
            sample.lowest_K.clear();
            sample.highest_K.clear();
        }
    return run;
}

} // namespace bask
