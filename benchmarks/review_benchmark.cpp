// The Review page with a session of a day at 10 Hz with three objects: opening it until its traces are drawn,
// going to a moment with all that shows it, and moving and zooming both plots that are seen at once. Wanted:
// 1 s, 100 ms, 30 frames a second, tens of MB.

#include "benchmarks/day_session.h"
#include "engine/base/message_code.h"
#include "engine/recording/recorded_session.h"
#include "widgets/plots/trace_plot.h"
#include "widgets/review/replay_view.h"
#include "widgets/review/review_page.h"

#include <QApplication>

namespace bask {
namespace {

using namespace benchmarks;

/// As large as in a window of 1400 x 900.
struct ShownPage {
    ReviewPage page;

    ShownPage() {
        page.resize(1390, 760);
        page.show();
        QCoreApplication::processEvents();
    }
    bool open() {
        auto session =
            day().isThere ? RecordedSession::open(day().path) : Error(MessageCode::FileNotFound, {});
        if (session)
            page.setSession(*session, QStringList());
        draw();
        return session.ok();
    }
    void draw() {
        for (TracePlot* plot : page.findChildren<TracePlot*>())
            if (plot->isVisible())
                plot->redraw();
        QCoreApplication::processEvents();
    }
    TracePlot* plot() { return page.findChild<TracePlot*>(QStringLiteral("review.measured_K")); }
};

void openReview(benchmark::State& state) {
    if (!day().isThere)
        return state.SkipWithError("no session");
    ShownPage shown;
    for (auto _ : state) {
        state.PauseTiming();
        shown.page.clear();
        const double before_MB = resident_MB();
        state.ResumeTiming();
        if (!shown.open())
            return state.SkipWithError("no session");
        state.PauseTiming();
        state.counters["MB"] = resident_MB() - before_MB;
        if (shown.plot()->visibleHighest() < kSpike_K - 273.15)
            return state.SkipWithError("a spike is not in the picture");
        state.ResumeTiming();
    }
}
BENCHMARK(openReview)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(5);

/// Tiles, lines at the moment and the slider.
void seekReview(benchmark::State& state) {
    ShownPage shown;
    if (!shown.open())
        return state.SkipWithError("no session");
    std::mt19937 random(3);
    std::uniform_real_distribution<double> moment_s(0.0, kDay * kPeriod_s);
    Times times;
    for (auto _ : state) {
        const double time_s = moment_s(random);
        const Stopwatch watch;
        shown.page.replay()->seek(time_s);
        QCoreApplication::processEvents();
        times.add(watch);
    }
    times.tell(state);
}
BENCHMARK(seekReview)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(300);

/// Both plots moved over the day at a width of so many seconds, or zoomed in and out about a moment (0).
void panAndZoomReview(benchmark::State& state) {
    ShownPage shown;
    if (!shown.open())
        return state.SkipWithError("no session");
    const double before_MB = resident_MB();
    const double day_s = kDay * kPeriod_s, width_s = static_cast<double>(state.range(0));
    int frame = 0;
    Times times;
    for (auto _ : state) {
        const double share = 0.5 - 0.5 * std::cos(0.05 * frame++);
        const double half_s = width_s > 0.0 ? 0.5 * width_s : 0.5 * day_s * std::pow(10.0 / day_s, share);
        const double centre_s =
            width_s > 0.0 ? half_s + share * (day_s - width_s) * std::min(1.0, 20.0 * width_s / day_s)
                          : 0.6 * day_s;
        const Stopwatch watch;
        shown.plot()->setTimeRange(centre_s - half_s, centre_s + half_s);
        emit shown.plot()->timeRangeChosen(centre_s - half_s, centre_s + half_s); // the other one follows
        shown.draw();
        times.add(watch);
    }
    times.tell(state);
    state.counters["more_MB"] = resident_MB() - before_MB;
}
BENCHMARK(panAndZoomReview)
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
