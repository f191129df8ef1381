#pragma once
// Random scenes of a laboratory: an object before a source, and plates that may stand between.

#include "engine/radiation/plate_crossing.h"
#include "engine/radiation/shade.h"

#include <cmath>
#include <numbers>
#include <random>

namespace bask {

struct ShadedScene {
    RadiatingContour source, object;
    Pose X_SO;
    std::vector<Blocker> blockers;
};

class ShadedScenes {
public:
    explicit ShadedScenes(unsigned seed) : m_random(seed) {}

    /// Returns a scene in which no blocker passes through the object or the source.
    ShadedScene next(int blockers) {
        const double radius = uniform(0.06, 0.15);
        const double kind = uniform(0.0, 1.0);
        const Shape source = kind < 0.7    ? Shape(Disk{radius})
                             : kind < 0.85 ? polygon(radius, 4 + integer(4), 1.0)
                                           : polygon(radius, 9, 0.55);
        const Eigen::Vector3d place(uniform(-0.7, 0.7) * radius, uniform(-0.7, 0.7) * radius,
                                    uniform(0.04, 0.2));
        ShadedScene scene{
            RadiatingContour(source), RadiatingContour(plate(uniform(0.01, 0.03))), tilted(place), {}};
        while (static_cast<int>(scene.blockers.size()) < blockers) {
            const double share = uniform(0.15, 1.0);
            const Eigen::Vector3d aside(uniform(-0.05, 0.05), uniform(-0.05, 0.05), 0.0);
            const Blocker blocker{RadiatingContour(plate(uniform(0.008, 0.035))),
                                  tilted(share * place + aside)};
            if (!platesCross(blocker.contour, blocker.X_S, scene.object, scene.X_SO) &&
                !platesCross(blocker.contour, blocker.X_S, scene.source, Pose::Identity()))
                scene.blockers.push_back(blocker);
        }
        return scene;
    }

    double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(m_random);
    }

private:
    int integer(int below) { return std::uniform_int_distribution<int>(0, below - 1)(m_random); }

    Contour polygon(double radius, int corners, double least) {
        Contour contour;
        for (int i = 0; i < corners; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + uniform(-0.3, 0.3)) / corners;
            const double away = radius * uniform(least, 1.0);
            contour.points_m.emplace_back(away * std::cos(angle), away * std::sin(angle));
        }
        return contour;
    }

    FourierContour fourier(double radius, int harmonics) {
        for (;;) {
            std::vector<std::complex<double>> coefficients(static_cast<std::size_t>(2 * harmonics + 1));
            for (int j = -harmonics; j <= harmonics; ++j) {
                const double size = j == 0 ? 0.0 : 0.18 * radius / (0.7 * j * j + 1.0);
                coefficients[static_cast<std::size_t>(j + harmonics)] =
                    j == 1 ? 0.75 * radius : std::complex<double>(uniform(-size, size), uniform(-size, size));
            }
            const FourierContour contour(coefficients);
            if (contour.area() > 0.0 && !findCrossing(contour))
                return contour;
        }
    }

    Shape plate(double radius) {
        const double kind = uniform(0.0, 1.0);
        if (kind < 0.45)
            return Disk{radius};
        if (kind < 0.8)
            return polygon(radius, 3 + integer(5), uniform(0.55, 1.0));
        if (kind < 0.9)
            return fourier(radius, 2 + integer(6));
        return withHoles(Disk{radius}, {polygon(radius * uniform(0.2, 0.5), 5, 1.0)});
    }

    // One in five by up to 70 degrees, the others by up to 20.
    Pose tilted(const Eigen::Vector3d& place) {
        const Eigen::Vector3d axis =
            Eigen::Vector3d(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
        const double most = uniform(0.0, 1.0) < 0.8 ? 0.35 : 1.2;
        return poseFromRotationVector(place, uniform(0.0, most) * axis.normalized());
    }

    std::mt19937_64 m_random;
};

} // namespace bask
