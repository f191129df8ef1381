// The thermal picture in a window of 1280 x 800, from a new view until it is drawn, with three objects of
// 300 points. Wanted at 256 x 192: 10 ms, a quarter of the time between two pictures.

#include "widgets/common/theme.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QApplication>
#include <QPixmap>

#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

namespace bask {
namespace {

ThermalView sceneOf(int width, int height) {
    ThermalPicture picture{width, height, {}};
    std::mt19937 random(1);
    std::normal_distribution<double> noise_K(298.0, 0.05);
    for (int k = 0; k < width * height; ++k)
        picture.T_K.push_back(noise_K(random));
    ThermalView view;
    constexpr int kPoints = 300;
    for (int i = 0; i < 3; ++i) {
        ThermalObjectView object;
        object.T_K = 313.0 + i;
        object.uncertainty_K = 0.2;
        const double radius = 0.12 * height, x = (0.2 + 0.3 * i) * width, y = 0.5 * height;
        for (int k = 0; k < kPoints; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kPoints;
            object.outline_px.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
        }
        for (int k = 0; k < width * height; ++k) {
            const int column = k % width, row = k / width;
            if (std::hypot(column - x, row - y) < radius - 1.5) {
                object.pixels.push_back(k);
                picture.T_K[static_cast<std::size_t>(k)] += 15.0 + i;
            }
        }
        view.objects.push_back(object);
    }
    view.picture = std::make_shared<ThermalPicture>(picture);
    return view;
}

void showPicture(benchmark::State& state) {
    ThermalView view = sceneOf(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    ThermalPictureView shown;
    shown.setNames({"circle", "bunny", "hand"});
    shown.resize(1280, 800);
    shown.show();
    QCoreApplication::processEvents();
    QPixmap drawn(shown.size());
    for (auto _ : state) {
        view.time_s += 0.04;
        shown.setView(view);
        shown.render(&drawn);
    }
}
BENCHMARK(showPicture)->Args({160, 120})->Args({256, 192})->Args({640, 512})->Unit(benchmark::kMillisecond);

} // namespace
} // namespace bask

int main(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    benchmark::Initialize(&argc, argv);
    QApplication application(argc, argv);
    bask::applyTheme(application, bask::Theme::Light);
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
