#pragma once
// Shapes and poses drawn at random for the tests of the view factor, from a stated seed.

#include "engine/radiation/view_factor.h"

#include <cmath>
#include <numbers>
#include <random>

namespace bask::test {

class Draw {
public:
    explicit Draw(unsigned seed) : m_generator(seed) {}

    double between(double min, double max) {
        return std::uniform_real_distribution<double>(min, max)(m_generator);
    }

    Eigen::Vector3d vector(double max) {
        return {between(-max, max), between(-max, max), between(-max, max)};
    }

    /// A wavy simple outline of about `radius_m`, five harmonics; `wave` up to 0.25 stays simple, larger is
    /// bent inwards.
    FourierContour fourier(double radius_m, double wave) {
        std::vector<std::complex<double>> c(11);
        for (int j = -5; j <= 5; ++j)
            c[static_cast<std::size_t>(j + 5)] =
                std::polar(radius_m * wave / (1.0 + j * j), between(0.0, 2.0 * std::numbers::pi));
        c[5] = 0.0;
        c[6] = radius_m;
        return FourierContour(c);
    }

    /// A star-shaped polygon about the origin.
    Contour polygon(double radius_m, int corners) {
        Contour contour;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + between(0.0, 0.6)) / corners;
            const double r = radius_m * between(0.5, 1.0);
            contour.points_m.emplace_back(r * std::cos(angle), r * std::sin(angle));
        }
        return contour;
    }

    Shape shape(int kind, double radius_m) {
        if (kind % 3 == 0)
            return Disk{radius_m};
        if (kind % 3 == 1)
            return fourier(radius_m, 0.25);
        return polygon(radius_m, 5 + kind % 4);
    }

private:
    std::mt19937 m_generator;
};

} // namespace bask::test
