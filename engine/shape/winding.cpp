#include "engine/shape/winding.h"

#include <algorithm>
#include <utility>

namespace bask {

double unevenShare(const FourierContour& contour) {
    constexpr int kPoints = 2053; // prime: a curve traced several times does not fall on itself
    constexpr int kLines = 400;
    std::vector<std::complex<double>> points;
    double lowest = 1e300, highest = -1e300;
    for (int i = 0; i < kPoints; ++i) {
        points.push_back(contour.point(static_cast<double>(i) / kPoints));
        lowest = std::min(lowest, points.back().imag());
        highest = std::max(highest, points.back().imag());
    }
    std::vector<std::vector<std::pair<double, int>>> crossings(kLines); // x, and +1 upwards
    const double step = (highest - lowest) / kLines;
    for (int i = 0; i < kPoints && step > 0.0; ++i) {
        const std::complex<double> a = points[static_cast<std::size_t>(i)];
        const std::complex<double> b = points[static_cast<std::size_t>((i + 1) % kPoints)];
        const auto lineAbove = [&](double y) {
            return std::clamp(static_cast<int>(std::ceil((y - lowest) / step - 0.5)), 0, kLines);
        };
        const int first = lineAbove(std::min(a.imag(), b.imag()));
        const int last = lineAbove(std::max(a.imag(), b.imag()));
        for (int line = first; line < last; ++line) {
            const double share = (lowest + (line + 0.5) * step - a.imag()) / (b.imag() - a.imag());
            crossings[static_cast<std::size_t>(line)].emplace_back(a.real() + share * (b.real() - a.real()),
                                                                   b.imag() > a.imag() ? 1 : -1);
        }
    }
    double enclosed = 0.0, uneven = 0.0;
    for (auto& line : crossings) {
        std::ranges::sort(line);
        int winding = 0; // to the right of an upward crossing it is one less
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            winding -= line[i].second;
            const double width = line[i + 1].first - line[i].first;
            enclosed += winding != 0 ? width : 0.0;
            uneven += winding != 0 && winding != 1 ? width : 0.0;
        }
    }
    return enclosed > 0.0 ? uneven / enclosed : 0.0;
}

} // namespace bask
