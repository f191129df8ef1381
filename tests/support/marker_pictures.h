#pragma once
// Pictures of markers whose places are known, for tests and benchmarks of what follows them: white cards on a
// grey ground with noise, through a camera without distortion.

#include "engine/calibration/marker_layout.h"
#include "engine/calibration/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

namespace bask::test {

/// 1280 x 720, f = 1000 px.
inline CameraModel plainCamera() {
    CameraModel camera;
    camera.width = 1280;
    camera.height = 720;
    camera.fx = camera.fy = 1000.0;
    camera.cx = 639.5;
    camera.cy = 359.5;
    return camera;
}

/// A part so far before the camera that faces it and is then turned about its own axes.
inline Pose facingFrom(const Eigen::Vector3d& p_CP, const Eigen::Vector3d& turn_rad) {
    return poseFromRotationVector(p_CP, {std::numbers::pi, 0, 0}) *
           poseFromRotationVector(Eigen::Vector3d::Zero(), turn_rad);
}

/// Four 50 mm markers in the corners of a square of 20 cm on the source (0 to 3).
inline MarkerLayout fourOnTheSource() {
    MarkerLayout layout{{"4X4_50"}, {}};
    int id = 0;
    for (const auto& [x, y] : {std::pair(-0.1, 0.1), {0.1, 0.1}, {0.1, -0.1}, {-0.1, -0.1}})
        layout.markers.push_back({Part::Source, id++, 0.05, Pose(Eigen::Translation3d(x, y, 0))});
    return layout;
}

class MarkerPictures {
public:
    static constexpr double kNoise_grey = 2.0; ///< standard deviation of a pixel

    explicit MarkerPictures(CameraModel camera, unsigned seed = 1)
        : m_camera(std::move(camera)), m_random(seed), m_noise(1U << 16U) {
        std::normal_distribution<double> noise(0.0, kNoise_grey);
        for (int& value : m_noise)
            value = static_cast<int>(std::lround(noise(m_random)));
    }

    GreyPicture blank() {
        constexpr int kGround = 120;
        GreyPicture picture{m_camera.width, m_camera.height, {}};
        picture.values.assign(static_cast<std::size_t>(picture.width * picture.height), kGround);
        return picture;
    }

    void draw(GreyPicture& picture, const PlacedMarker& marker, const MarkerDictionary& dictionary,
              const Pose& X_CP) const {
        constexpr double kCard = 0.7; // half of the card, in sides
        const Pose X_CM = X_CP * marker.X_PM;
        if (X_CM.linear().col(2).dot(X_CM.translation()) >= 0.0 || X_CM.translation().z() < 0.05)
            return; // its back, or behind the camera
        Eigen::Vector2d min(1e9, 1e9), max(-1e9, -1e9);
        for (const auto& [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
            const Eigen::Vector3d corner(x * kCard * marker.side_m, y * kCard * marker.side_m, 0.0);
            const Eigen::Vector2d p = shownAt(Lens(m_camera), Eigen::Vector3d(X_CM * corner));
            min = min.cwiseMin(p);
            max = max.cwiseMax(p);
        }
        Eigen::Matrix3d toPicture;
        toPicture << X_CM.linear().col(0), X_CM.linear().col(1), X_CM.translation();
        const Eigen::Matrix3d toMarker = toPicture.inverse();
        std::array<Eigen::Vector3d, 9> offsets; // a pixel is the mean of nine rays
        for (int k = 0; k < 9; ++k)
            offsets[static_cast<std::size_t>(k)] =
                toMarker *
                Eigen::Vector3d((k % 3 - 1) / (3.0 * m_camera.fx), (k / 3 - 1) / (3.0 * m_camera.fy), 0.0);
        const std::vector<std::string> cells = markerCells(dictionary, marker.id);
        const int left = std::max(0, static_cast<int>(min.x()) - 1);
        const int right = std::min(picture.width - 1, static_cast<int>(max.x()) + 2);
        const int bottom = std::min(picture.height - 1, static_cast<int>(max.y()) + 2);
        for (int v = std::max(0, static_cast<int>(min.y()) - 1); v <= bottom; ++v)
            for (int u = left; u <= right; ++u) {
                std::uint8_t& value = picture.values[static_cast<std::size_t>(v * picture.width + u)];
                int sum = 0;
                const Eigen::Vector3d middle =
                    toMarker *
                    Eigen::Vector3d((u - m_camera.cx) / m_camera.fx, (v - m_camera.cy) / m_camera.fy, 1.0);
                for (const Eigen::Vector3d& offset : offsets) {
                    const Eigen::Vector3d at = middle + offset;
                    const double scale = 1.0 / (at.z() * marker.side_m);
                    sum += brightness({scale * at.x(), scale * at.y()}, cells, value);
                }
                value = static_cast<std::uint8_t>(sum / 9);
            }
    }

    void addNoise(GreyPicture& picture) {
        for (int v = 0; v < picture.height; ++v) {
            std::size_t k = m_random() % m_noise.size();
            for (int u = 0; u < picture.width; ++u) {
                std::uint8_t& value = picture.values[static_cast<std::size_t>(v * picture.width + u)];
                value = static_cast<std::uint8_t>(std::clamp(value + m_noise[k], 0, 255));
                if (++k == m_noise.size()) // a remainder for each pixel takes longer than all else
                    k = 0;
            }
        }
    }

    /// The markers of `layout` on a part at X_CP.
    GreyPicture of(const MarkerLayout& layout, const Pose& X_CP) {
        GreyPicture picture = blank();
        for (const PlacedMarker& marker : layout.markers)
            draw(picture, marker, layout.dictionary, X_CP);
        addNoise(picture);
        return picture;
    }

private:
    // At a place in sides from the marker's middle, y up.
    static int brightness(const Eigen::Vector2d& p, const std::vector<std::string>& cells,
                          std::uint8_t ground) {
        constexpr double kCard = 0.7;
        constexpr int kBlack = 20, kWhite = 230;
        if (p.cwiseAbs().maxCoeff() > kCard)
            return ground;
        const double count = static_cast<double>(cells.size());
        const double column = std::floor((p.x() + 0.5) * count), row = std::floor((0.5 - p.y()) * count);
        if (column < 0.0 || row < 0.0 || column >= count || row >= count)
            return kWhite;
        return cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == '1' ? kWhite
                                                                                             : kBlack;
    }

    CameraModel m_camera;
    std::mt19937 m_random;
    std::vector<int> m_noise;
};

/// From rest to rest in a unit of time, with least jerk: 0 before, 1 after.
inline double carriedShare(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

} // namespace bask::test
