// A session of a day at 10 Hz with three objects: recording it, its file, opening it, going to a moment of
// it, and the frames of its plot. Wanted: 2 % of a core, 400 MB, 1 s, 100 ms, 30 frames a second. Beside it,
// as before version 2: every sample read when the file is opened.

#include "benchmarks/day_session.h"
#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "engine/recording/run_metrics.h"
#include "engine/recording/session_identification.h"
#include "tests/support/first_version.h"
#include "widgets/plots/trace_plot.h"

#include <QApplication>
#include <QFileInfo>

namespace bask {
namespace {

using namespace benchmarks;

/// The same as a file of version 1.
struct FirstVersionFile {
    std::string path = day().folder.filePath(QStringLiteral("first.bask")).toStdString();
    bool isThere = day().isThere &&
                   QFile::copy(QString::fromStdString(day().path), QString::fromStdString(path)) &&
                   test::makeFirstVersion(path);
};

const FirstVersionFile& firstVersion() {
    static const FirstVersionFile file;
    return file;
}

double megabytes(const std::string& path) {
    return 1e-6 * static_cast<double>(QFileInfo(QString::fromStdString(path)).size());
}

std::unique_ptr<TracePlot> shownPlot() {
    auto plot = std::make_unique<TracePlot>(Quantity::Temperature);
    plot->resize(1100, 420);
    plot->show();
    QCoreApplication::processEvents();
    return plot;
}

/// An hour, committed each half second.
void recordHour(benchmark::State& state) {
    const QTemporaryDir folder;
    const std::string path = folder.filePath(QStringLiteral("hour.bask")).toStdString();
    const std::clock_t start = std::clock();
    for (auto _ : state)
        if (!record(path, kHour, 5, state.range(0) != 0))
            return state.SkipWithError("cannot record");
    const double spent_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    state.counters["percent_of_a_core"] =
        100.0 * spent_s / (3600.0 * static_cast<double>(state.iterations()));
    state.counters["day_MB"] = 24.0 * megabytes(path);
}
BENCHMARK(recordHour)->ArgName("followed")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->Iterations(2);

/// Until the plot of the whole day is drawn.
void openDay(benchmark::State& state) {
    if (!day().isThere)
        return state.SkipWithError("no session");
    for (auto _ : state) {
        state.PauseTiming();
        const double before_MB = resident_MB();
        state.ResumeTiming();
        const auto session = RecordedSession::open(day().path);
        if (!session)
            return state.SkipWithError(describe(session.error()).c_str());
        const auto plot = shownPlot();
        plot->setRun(*session);
        plot->redraw();
        state.PauseTiming();
        state.counters["session_and_plot_MB"] = resident_MB() - before_MB;
        if (plot->visibleHighest() < kSpike_K - 273.15)
            return state.SkipWithError("a spike is not in the picture");
        state.ResumeTiming();
    }
    state.counters["file_MB"] = megabytes(day().path);
}
BENCHMARK(openDay)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

/// As before: every sample into memory, version 1 (0) or 2 (1).
void openDayWhole(benchmark::State& state) {
    const bool isThere = state.range(0) == 0 ? firstVersion().isThere : day().isThere;
    const std::string& path = state.range(0) == 0 ? firstVersion().path : day().path;
    if (!isThere)
        return state.SkipWithError("no session");
    for (auto _ : state) {
        const double before_MB = resident_MB();
        auto session = readSession(path);
        if (!session)
            return state.SkipWithError(describe(session.error()).c_str());
        const auto plot = shownPlot();
        plot->setObjects({QStringLiteral("circle"), QStringLiteral("bunny"), QStringLiteral("hand")});
        plot->setSamples(session->samples);
        plot->redraw();
        state.counters["session_and_plot_MB"] = resident_MB() - before_MB;
    }
    state.counters["file_MB"] = megabytes(path);
}
BENCHMARK(openDayWhole)
    ->ArgName("newer")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(1);

/// Its metrics and heat rates, all samples read once.
void countDay(benchmark::State& state) {
    const auto session =
        day().isThere ? RecordedSession::open(day().path) : Error(MessageCode::FileNotFound, {});
    if (!session)
        return state.SkipWithError("no session");
    for (auto _ : state) {
        const double before_MB = resident_MB();
        RunMetricsCount metrics((*session)->facts());
        HeatRecords heat((*session)->facts());
        const auto read = readSamples(day().path, [&](const TraceSample& sample) {
            metrics.add(sample);
            heat.add(sample);
        });
        const Stopwatch watch;
        benchmark::DoNotOptimize(heat.identify());
        state.counters["rates_cpu_ms"] = watch.cpu_ms();
        state.counters["MB"] = resident_MB() - before_MB;
        if (!read || metrics.metrics().samples != kDay)
            return state.SkipWithError("not all samples");
    }
}
BENCHMARK(countDay)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

/// The sample at random moments, as replay wants it.
void seekDay(benchmark::State& state) {
    const auto session =
        day().isThere ? RecordedSession::open(day().path) : Error(MessageCode::FileNotFound, {});
    if (!session)
        return state.SkipWithError("no session");
    std::mt19937 random(3);
    std::uniform_real_distribution<double> moment_s(0.0, (*session)->lastTime_s());
    Times times;
    for (auto _ : state) {
        const double time_s = moment_s(random);
        const Stopwatch watch;
        const auto sample = (*session)->sampleAt(time_s);
        times.add(watch);
        if (!sample || std::abs(sample->time_s - time_s) > 2.0 * kPeriod_s)
            return state.SkipWithError("not the sample of that moment");
    }
    times.tell(state);
}
BENCHMARK(seekDay)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(500);

/// Frames of a plot: moved over the day at a width of so many seconds, or zoomed in and out about a moment
/// (0).
void frames(benchmark::State& state, TracePlot& plot) {
    Times times;
    const double day_s = kDay * kPeriod_s, width_s = static_cast<double>(state.range(0));
    int frame = 0;
    for (auto _ : state) {
        const Stopwatch watch;
        const double share = 0.5 - 0.5 * std::cos(0.05 * frame++);
        if (width_s > 0.0) {
            const double from_s = share * (day_s - width_s) * std::min(1.0, 20.0 * width_s / day_s);
            plot.setTimeRange(from_s, from_s + width_s);
        } else {
            const double half_s = 0.5 * day_s * std::pow(10.0 / day_s, share);
            plot.setTimeRange(0.6 * day_s - half_s, 0.6 * day_s + half_s);
        }
        plot.redraw();
        times.add(watch);
    }
    times.tell(state);
}

void panAndZoomDay(benchmark::State& state) {
    const auto session =
        day().isThere ? RecordedSession::open(day().path) : Error(MessageCode::FileNotFound, {});
    if (!session)
        return state.SkipWithError("no session");
    const auto plot = shownPlot();
    plot->setRun(*session);
    frames(state, *plot);
}
BENCHMARK(panAndZoomDay)
    ->ArgName("width_s")
    ->Arg(0)
    ->Arg(60)
    ->Arg(600)
    ->Arg(1600)
    ->Arg(7200)
    ->Arg(43200)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Iterations(300);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    benchmark::Initialize(&argc, argv);
    const QApplication application(argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
