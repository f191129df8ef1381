#include "tests/engine/recording/recording.h"

#include "engine/base/clock.h"

#include <QCoreApplication>
#include <QTimer>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace bask::test {
namespace {

constexpr double kNotMeasured = std::numeric_limits<double>::quiet_NaN();

bool same(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

bool sameObject(const ObjectSample& a, const ObjectSample& b) {
    return same(a.measured_K, b.measured_K) && same(a.estimated_K, b.estimated_K) &&
           same(a.rate_K_s, b.rate_K_s) && same(a.target_K, b.target_K) && same(a.viewFactor, b.viewFactor) &&
           same(a.unshadedViewFactor, b.unshadedViewFactor) && same(a.lambda1, b.lambda1) &&
           same(a.lambda2, b.lambda2) && same(a.true_K, b.true_K) && a.valid == b.valid &&
           same(a.camera.T_K, b.camera.T_K) && same(a.camera.uncertainty_K, b.camera.uncertainty_K) &&
           same(a.camera.spread_K, b.camera.spread_K) && same(a.camera.pixels, b.camera.pixels);
}

} // namespace

Experiment twoDisks() {
    Experiment e;
    e.title = "two disks, \"quoted\", with a comma";
    for (const char* name : {"left, the", "right"}) {
        ObjectSpec object;
        object.name = name;
        object.shape = Disk{0.015};
        object.mounting[kX] = e.objects.empty() ? -0.04 : 0.04;
        e.objects.push_back(object);
    }
    return e;
}

TraceSample madeUpSample(const Experiment& experiment, int k) {
    TraceSample s;
    s.time_s = k * 1.0001;
    for (std::size_t i = 0; i < experiment.objects.size(); ++i) {
        const double x = k + 0.1 * static_cast<double>(i);
        ObjectSample o;
        o.measured_K = 300.0 + std::sqrt(x);
        o.estimated_K = k < 10 ? kNotMeasured : o.measured_K + 1e-3 / 3.0;
        o.rate_K_s = k < 10 ? kNotMeasured : std::sin(x);
        o.target_K = experiment.objects[i].target_K;
        o.viewFactor = 1.0 / (1.5 + x);
        o.unshadedViewFactor = o.viewFactor + 0.01 * static_cast<double>(i);
        o.lambda1 = i == 0 ? 0.1 / (1.0 + x) : kNotMeasured;
        o.lambda2 = 1e-11 / (1.0 + x);
        o.true_K = o.measured_K - 0.01;
        o.valid = k % 7 != 0;
        if (thermalProfile(experiment, true) && k % 5 != 0)
            o.camera = {o.measured_K + 0.1, 0.2 + 0.01 * x, k % 3 == 0 ? kNotMeasured : 1.0 / (2.0 + x),
                        50.0 + k};
        s.objects.push_back(o);
    }
    s.coordinates << 0.1 * std::sin(0.7 * k), -0.07, 0.15 + 1e-4 * k, 0.6 * std::sin(0.3 * k), -0.2,
        3.0 * std::sin(0.1 * k);
    s.twist << 0.01, -0.02, 1.0 / 3.0, 0.1, 0.0, -0.05 / (k + 1.0);
    s.source_K = 473.15 + 0.1 * k;
    s.source << 0.02 * std::cos(0.2 * k), 0.3, -0.001 * k, 0.4 * std::sin(0.5 * k), 0.1,
        -2.0 * std::sin(0.3 * k);
    s.smallestSingularValue = 0.7 / (k + 1.0);
    if (k % 3 == 0)
        s.limits.add(Limit::Workspace, k % 6);
    return s;
}

ThermalPicture madeUpPicture(const ThermalProfile& profile, int k) {
    ThermalPicture picture{profile.width, profile.height, {}};
    for (int i = 0; i < profile.width * profile.height; ++i)
        picture.T_K.push_back(profile.temperature_K(29000 + (i * 7 + k * 13) % 5000));
    picture.T_K[5] = std::numeric_limits<double>::infinity();
    return picture;
}

TraceSample asVersionOne(TraceSample sample) {
    for (ObjectSample& object : sample.objects)
        for (const ObjectColumn& column : kObjectColumns)
            if (column.stored.isLater)
                column.value.set(object, kNotMeasured);
    for (const RunColumn& column : kRunColumns)
        if (column.stored.isLater)
            column.value.set(sample, kNotMeasured);
    return sample;
}

bool sameSample(const TraceSample& a, const TraceSample& b) {
    bool objects = a.objects.size() == b.objects.size();
    for (std::size_t i = 0; objects && i < a.objects.size(); ++i)
        objects = sameObject(a.objects[i], b.objects[i]);
    return objects && a.time_s == b.time_s && a.twist == b.twist && a.source_K == b.source_K &&
           a.smallestSingularValue == b.smallestSingularValue && a.limits == b.limits &&
           (a.coordinates - b.coordinates).cwiseAbs().maxCoeff() < 1e-12 &&
           (a.source - b.source).cwiseAbs().maxCoeff() < 1e-12;
}

int recordUntilKilled(const std::string& path) {
    const Experiment experiment = twoDisks();
    auto writer = SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced);
    if (!writer)
        return 1;
    const SteadyClock clock;
    const double start_s = clock.now_s();
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&, k = 0]() mutable {
        TraceSample sample = madeUpSample(experiment, k++);
        sample.time_s = clock.now_s() - start_s;
        if (!(*writer)->add(sample))
            QCoreApplication::exit(1);
        std::printf("%.6f\n", sample.time_s);
        std::fflush(stdout);
    });
    timer.start(10);
    return QCoreApplication::exec();
}

int recordAndAcknowledge(const std::string& path, unsigned seed) {
    constexpr double kNever_s = 1e6;
    const Experiment experiment = twoDisks();
    auto writer = SessionWriter::create(path, experiment, true, kNever_s,
                                        SessionWriter::Earlier::Replaced); // by flush() alone
    if (!writer)
        return 1;
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> atOnce(1, 40);
    for (int k = 0;;) {
        std::printf("%d\n", k);
        std::fflush(stdout);
        const int end = k + atOnce(random);
        while (k < end)
            if (!(*writer)->add(madeUpSample(experiment, k++)))
                return 1;
        if (k % 5 == 0 && !(*writer)->add(TraceNote{1.0 * k, "note"}))
            return 1;
        if (!(*writer)->flush())
            return 1;
    }
}

int replaceUntilKilled(const std::string& path) {
    const Experiment experiment = twoDisks();
    for (;;) {
        auto writer = SessionWriter::create(path, experiment, true, 0.5, SessionWriter::Earlier::Replaced);
        if (!writer || !(*writer)->add(madeUpSample(experiment, 0)) || !(*writer)->finish("stopped"))
            return 1;
        writer->reset();
        std::printf("replaced\n");
        std::fflush(stdout);
    }
}

} // namespace bask::test
