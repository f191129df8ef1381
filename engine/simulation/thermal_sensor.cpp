#include "engine/simulation/thermal_sensor.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

constexpr double kNoiseAt_K = 300.0;

using Engine = std::mt19937_64;

Engine engineFor(std::uint64_t seed, std::uint64_t event) {
    std::seed_seq seeds{seed, seed >> 32, event, event >> 32};
    return Engine(seeds);
}

std::vector<float> blurred(const GreyCanvas& canvas, double blur_px) {
    std::vector<float> out = canvas.values;
    if (blur_px <= 0.0)
        return out;
    cv::Mat picture(canvas.height, canvas.width, CV_32F, out.data());
    cv::GaussianBlur(picture, picture, cv::Size(), blur_px, blur_px, cv::BORDER_REPLICATE);
    return out;
}

} // namespace

ThermalSensor::ThermalSensor(const BandRadiance& band, const ThermalSensorErrors& errors, int width,
                             int height, double own_K)
    : m_band(band), m_errors(errors), m_own_K(own_K) {
    Engine random = engineFor(errors.seed, 0);
    std::normal_distribution<double> normal;
    m_gain = errors.gain * normal(random);
    const double offset_K = errors.offset_K * normal(random), corner_K = errors.narcissus_K * normal(random);
    const double middleX = 0.5 * (width - 1), middleY = 0.5 * (height - 1);
    for (int v = 0; v < height; ++v)
        for (int u = 0; u < width; ++u) {
            const double dx = u - middleX, dy = v - middleY;
            const double share = (dx * dx + dy * dy) / (middleX * middleX + middleY * middleY);
            m_fixed_K.push_back(
                static_cast<float>(offset_K + corner_K * share + errors.pattern_K * normal(random)));
        }
}

bool ThermalSensor::isShut(double time_s) const {
    return m_errors.shutterPeriod_s > 0.0 && std::fmod(time_s, m_errors.shutterPeriod_s) < m_errors.shutter_s;
}

std::optional<double> ThermalSensor::opened_s(double time_s) const {
    if (!(m_errors.shutterPeriod_s > 0.0) || time_s < m_errors.shutter_s)
        return std::nullopt;
    const double opened_s =
        std::floor(time_s / m_errors.shutterPeriod_s) * m_errors.shutterPeriod_s + m_errors.shutter_s;
    return opened_s <= time_s ? opened_s : opened_s - m_errors.shutterPeriod_s;
}

double ThermalSensor::offset_K(double time_s) const {
    const double events =
        m_errors.shutterPeriod_s > 0.0 ? std::floor(time_s / m_errors.shutterPeriod_s) : 0.0;
    Engine random = engineFor(m_errors.seed + 1, static_cast<std::uint64_t>(std::max(events, 0.0)));
    std::normal_distribution<double> normal;
    const double shutter_K = m_errors.shutterOffset_K * normal(random);
    return shutter_K +
           m_errors.drift_K_min * normal(random) * (time_s - events * m_errors.shutterPeriod_s) / 60.0;
}

ThermalPicture ThermalSensor::caught(const GreyCanvas& radiance, double time_s, std::uint64_t number,
                                     std::span<const PixelBox> parts) const {
    const std::vector<float> seen = blurred(radiance, m_errors.blur_px);
    const double offset = offset_K(time_s), noise = m_errors.noise_K * m_band.derivative(kNoiseAt_K);
    const double least = m_band.radiance(kMinBand_K), most = m_band.radiance(kMaxBand_K);
    Engine random = engineFor(m_errors.seed + 2, number);
    std::normal_distribution<double> normal;
    ThermalPicture out{radiance.width, radiance.height, std::vector<double>(seen.size(), m_own_K)};
    for (const PixelBox& part : parts)
        for (int v = part.top; v < part.bottom; ++v)
            for (int u = part.left; u < part.right; ++u) {
                const std::size_t k = static_cast<std::size_t>(v) * static_cast<std::size_t>(radiance.width) +
                                      static_cast<std::size_t>(u);
                const double noisy = static_cast<double>(seen[k]) + noise * normal(random);
                const double T_K = m_band.temperature(std::clamp(noisy, least, most));
                out.T_K[k] = T_K + m_gain * (T_K - m_own_K) + static_cast<double>(m_fixed_K[k]) + offset;
            }
    return out;
}

} // namespace bask
