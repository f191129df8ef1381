// Fields on all cores: the paper's two subsets, with the memory that their sampling takes beside the result.

#include "engine/base/units.h"
#include "engine/radiation/field_sampler.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::size_t> liveBytes{0};
std::atomic<std::size_t> peakBytes{0};

void* counted(void* block) {
    if (block == nullptr)
        throw std::bad_alloc();
    const std::size_t live = liveBytes += malloc_usable_size(block);
    std::size_t peak = peakBytes;
    while (live > peak && !peakBytes.compare_exchange_weak(peak, live)) {
    }
    return block;
}

void release(void* block) {
    if (block != nullptr)
        liveBytes -= malloc_usable_size(block);
    std::free(block);
}

std::size_t roundedUp(std::size_t size, std::size_t alignment) {
    return (size + alignment - 1) / alignment * alignment;
}

} // namespace

// GCC takes the pair malloc and replaced delete for a mistake once it has inlined one of them.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) {
    return counted(std::malloc(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto a = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(a, roundedUp(size, a)));
}
void operator delete(void* block) noexcept {
    release(block);
}
void operator delete(void* block, std::size_t) noexcept {
    release(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
    release(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    release(block);
}

namespace bask {
namespace {

FieldRequest paperRequest(std::vector<FieldAxis> axes) {
    FieldRequest request{RadiatingContour(Disk{0.10}), RadiatingContour(Disk{0.015}), std::move(axes)};
    request.fixed[kZ] = 0.05;
    return request;
}

FieldRequest translations() {
    return paperRequest({{kX, -0.20, 0.01, 40}, {kY, -0.20, 0.01, 40}, {kZ, 0.01, 0.01, 30}});
}

FieldRequest rotations() {
    const auto angle = [](Coordinate c) { return FieldAxis{c, radFromDeg(-90.0), radFromDeg(2.0), 90}; };
    return paperRequest({angle(kThetaX), angle(kThetaY), angle(kThetaZ)});
}

void sample(benchmark::State& state, const FieldRequest& request, int threads) {
    std::size_t samples = 0;
    std::size_t beside = 0;
    for (auto _ : state) {
        const std::size_t before = liveBytes;
        peakBytes = before;
        const auto field = sampleField(request, {threads, {}, {}});
        samples = (*field)->values.size();
        beside = std::max(beside, peakBytes - before - samples * sizeof(double));
    }
    state.counters["samples/s"] =
        benchmark::Counter(static_cast<double>(samples), benchmark::Counter::kIsIterationInvariantRate);
    state.counters["beside_kB"] = static_cast<double>(beside) / 1e3;
}

FieldRequest withGradient(FieldRequest request) {
    request.withGradient = true;
    return request;
}

/// The baseline: the same poses, each by itself, on one thread.
void oneByOne(benchmark::State& state, bool withGradient) {
    const FieldRequest request = translations();
    std::vector<Pose> poses;
    for (int k = 0; k < request.axes[2].count; ++k)
        for (int j = 0; j < request.axes[1].count; ++j)
            for (int i = 0; i < request.axes[0].count; ++i) {
                Pose X = Pose::Identity();
                X.translation() << request.axes[0].at(i), request.axes[1].at(j), request.axes[2].at(k);
                poses.push_back(X);
            }
    for (auto _ : state)
        for (const Pose& X : poses)
            if (withGradient)
                benchmark::DoNotOptimize(viewFactor(request.source, request.object, X).gradient);
            else
                benchmark::DoNotOptimize(viewFactorValue(request.source, request.object, X));
    state.counters["samples/s"] =
        benchmark::Counter(static_cast<double>(poses.size()), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(oneByOne, translations48000, false)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(oneByOne, translations48000_gradient, true)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, translations48000_gradient_oneThread, withGradient(translations()), 1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, translations48000, translations(), 0)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, translations48000_oneThread, translations(), 1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, rotations729000, rotations(), 0)->UseRealTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(sample, rotations729000_oneThread, rotations(), 1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask
