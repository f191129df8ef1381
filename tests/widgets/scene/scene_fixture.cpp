#include "tests/widgets/scene/scene_fixture.h"

#include "engine/base/units.h"

#include <QDir>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bask::test {

namespace {

ObjectSpec object(const std::string& name, Shape shape, double x_cm, double y_cm, double target_degC) {
    ObjectSpec spec;
    spec.name = name;
    spec.shape = std::move(shape);
    spec.mounting[kX] = x_cm / 100.0;
    spec.mounting[kY] = y_cm / 100.0;
    spec.target_K = kelvinFromCelsius(target_degC);
    return spec;
}

/// Palm and four fingers: a plain polygon fill would spill between them.
Contour hand() {
    const std::vector<Eigen::Vector2d> points_mm{
        {-14, -26}, {14, -26}, {20, 2},   {19, 24},  {13, 24}, {11, 4},  {9, 4},
        {8, 30},    {2, 30},   {1, 5},    {-1, 5},   {-3, 29}, {-9, 29}, {-9, 3},
        {-11, 3},   {-14, 20}, {-20, 19}, {-18, -4}, {-32, 8}, {-36, 3}, {-20, -18}};
    Contour contour;
    for (const Eigen::Vector2d& p_mm : points_mm)
        contour.points_m.push_back(p_mm / 1000.0);
    return contour;
}

double inBetween(double a, double b, double t) {
    return a + (b - a) * t;
}

bool near(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) <= tolerance && std::abs(qGreen(a) - qGreen(b)) <= tolerance &&
           std::abs(qBlue(a) - qBlue(b)) <= tolerance;
}

/// Looks at every pixel by its row: QImage::pixel() takes several times as long.
template <class Look> void eachPixel(const QImage& image, Look look) {
    const QImage plain = image.convertToFormat(QImage::Format_ARGB32);
    for (int y = 0; y < plain.height(); ++y) {
        const auto* row = reinterpret_cast<const QRgb*>(plain.constScanLine(y));
        for (int x = 0; x < plain.width(); ++x)
            look(x, y, row[x]);
    }
}

} // namespace

Experiment threeObjects() {
    Experiment experiment;
    experiment.title = "Three objects";
    experiment.objects = {object("circle", Disk{0.015}, 0.0, 5.0, 50.0),
                          object("clover",
                                 FourierContour({{0.0015, 0.001},
                                                 {0.004, 0.0},
                                                 {0.0, 0.0},
                                                 {0.0, 0.0},
                                                 {0.026, 0.0},
                                                 {0.0, 0.002},
                                                 {0.0, 0.0}}),
                                 -4.35, -2.5, 40.0),
                          object("hand", hand(), 4.35, -2.5, 35.0)};
    return experiment;
}

std::vector<TraceSample> spiral(int count) {
    std::vector<TraceSample> samples(static_cast<std::size_t>(count));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < count; ++i) {
        const double t = count > 1 ? static_cast<double>(i) / (count - 1) : 1.0;
        const double angle = 2.2 * std::numbers::pi * t;
        const double radius = 0.12 * t * (1.3 - t) * 2.0;
        TraceSample& sample = samples[static_cast<std::size_t>(i)];
        sample.time_s = i;
        sample.coordinates << radius * std::cos(angle), radius * std::sin(angle), inBetween(0.24, 0.05, t),
            0.3 * std::sin(angle), 0.0, 0.0;
        sample.source_K = kelvinFromCelsius(200.0);
        for (const double target_degC : {50.0, 40.0, 35.0}) {
            ObjectSample reading;
            reading.estimated_K = kelvinFromCelsius(inBetween(25.0, target_degC, 1.0 - std::exp(-4.0 * t)));
            reading.measured_K = reading.estimated_K;
            reading.true_K = nan;
            reading.valid = true;
            sample.objects.push_back(reading);
        }
    }
    return samples;
}

int pixelsOf(const QImage& image, const QColor& colour, int tolerance) {
    int count = 0;
    eachPixel(image,
              [&, wanted = colour.rgb()](int, int, QRgb seen) { count += near(seen, wanted, tolerance); });
    return count;
}

QPointF middleOf(const QImage& image, const QColor& colour, int tolerance) {
    QPointF sum;
    int count = 0;
    eachPixel(image, [&, wanted = colour.rgb()](int x, int y, QRgb seen) {
        if (near(seen, wanted, tolerance)) {
            sum += QPointF(x, y);
            ++count;
        }
    });
    return count > 0 ? sum / count : QPointF(-1.0, -1.0);
}

int differentPixels(const QImage& a, const QImage& b) {
    if (a.size() != b.size())
        return a.width() * a.height();
    const QImage other = b.convertToFormat(QImage::Format_ARGB32);
    int count = 0;
    eachPixel(a, [&](int x, int y, QRgb seen) {
        count += !near(seen, reinterpret_cast<const QRgb*>(other.constScanLine(y))[x], 6);
    });
    return count;
}

int coloursIn(const QImage& image) {
    std::vector<QRgb> colours;
    eachPixel(image, [&](int, int, QRgb seen) {
        if (colours.empty() || colours.back() != seen)
            colours.push_back(seen);
    });
    std::ranges::sort(colours);
    return static_cast<int>(colours.size() - std::ranges::unique(colours).size());
}

void keepScreenshot(const QImage& image, const QString& name) {
    const QString folder = qEnvironmentVariable("BASK_SCREENSHOTS");
    if (!folder.isEmpty() && QDir().mkpath(folder))
        image.save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

} // namespace bask::test
