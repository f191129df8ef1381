// View factors with shade beside the ones without, in the same run: the three cases of shade.h.

#include "engine/radiation/shade.h"
#include "tests/support/shaded_scene.h"
#include "tests/support/thread_time.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <vector>

namespace bask {
namespace {

const RadiatingContour& source() {
    static const RadiatingContour kDisk(Disk{0.08});
    return kDisk;
}
const RadiatingContour& object() {
    static const RadiatingContour kDisk(Disk{0.015});
    return kDisk;
}
const Pose kPose(Eigen::Translation3d(0.0, 0.0, 0.1));

Blocker plateAt(double x, double z) {
    static const RadiatingContour kDisk(Disk{0.02});
    return {kDisk, Pose(Eigen::Translation3d(x, 0.0, z))};
}

void unshaded(benchmark::State& state) {
    for (auto _ : state)
        benchmark::DoNotOptimize(viewFactor(source(), object(), kPose));
}
BENCHMARK(unshaded);

void shaded(benchmark::State& state, const std::vector<Blocker>& blockers) {
    const ShadeOptions options{.unshaded = {}, .tolerance = 1e-6};
    for (auto _ : state)
        benchmark::DoNotOptimize(shadedViewFactor(source(), object(), kPose, blockers, options));
}
BENCHMARK_CAPTURE(shaded, case1_in_one_plane, std::vector<Blocker>{plateAt(0.04, 0.1)});
BENCHMARK_CAPTURE(shaded, case1_beside, std::vector<Blocker>{plateAt(0.15, 0.05)});
BENCHMARK_CAPTURE(shaded, case2, std::vector<Blocker>{plateAt(0.0, 0.04)});
BENCHMARK_CAPTURE(shaded, case3, std::vector<Blocker>{plateAt(0.05, 0.04)});
BENCHMARK_CAPTURE(shaded, case3_two, (std::vector<Blocker>{plateAt(0.05, 0.04), plateAt(0.03, 0.07)}));

// Random scenes of which both blockers take something, in a way that needs case 3.
void randomScenes(benchmark::State& state) {
    const int count = static_cast<int>(state.range(0));
    const ShadeOptions options{.unshaded = {}, .tolerance = 1e-6};
    std::vector<double> times_us;
    for (auto _ : state) {
        ShadedScenes scenes(1);
        while (static_cast<int>(times_us.size()) < count) {
            const ShadedScene scene = scenes.next(2);
            const auto take = [&](std::size_t blocker) {
                const ShadedViewFactor factor = shadedViewFactor(scene.source, scene.object, scene.X_SO,
                                                                 {&scene.blockers[blocker], 1}, options);
                return factor.unshaded - factor.value > 1e-5 &&
                       (factor.gradientRigid - viewFactor(scene.source, scene.object, scene.X_SO).gradient)
                               .norm() > 0.0;
            };
            if (!take(0) || !take(1))
                continue;
            const double from_s = test::threadTime_s();
            benchmark::DoNotOptimize(
                shadedViewFactor(scene.source, scene.object, scene.X_SO, scene.blockers, options));
            times_us.push_back(1e6 * (test::threadTime_s() - from_s));
        }
    }
    std::ranges::sort(times_us);
    const auto share = [&](double part) { return times_us[static_cast<std::size_t>(part * (count - 1))]; };
    state.counters["median_us"] = share(0.5);
    state.counters["p99_us"] = share(0.99);
}
BENCHMARK(randomScenes)->Arg(1000)->Iterations(1)->Unit(benchmark::kSecond);

} // namespace
} // namespace bask
