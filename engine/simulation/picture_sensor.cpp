#include "engine/simulation/picture_sensor.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace bask {
namespace {

constexpr std::size_t kOffsets = 65536; // of rows in the noise

std::vector<float> spotOf(double blur_px) {
    const int reach = static_cast<int>(std::ceil(3.0 * blur_px));
    std::vector<float> spot;
    float sum = 0.0F;
    for (int k = -reach; k <= reach; ++k) {
        spot.push_back(k == 0 ? 1.0F : static_cast<float>(std::exp(-0.5 * k * k / (blur_px * blur_px))));
        sum += spot.back();
    }
    for (float& weight : spot)
        weight /= sum;
    return spot;
}

} // namespace

PictureSensor::PictureSensor(const PictureQuality& quality, int width)
    : m_quality(quality), m_spot(spotOf(quality.blur_px)), m_across(m_spot.size()) {
    const auto columns = static_cast<std::size_t>(std::max(width, 0));
    std::mt19937_64 random(quality.seed);
    std::normal_distribution<float> normal;
    m_noise.resize(kOffsets + columns);
    for (float& value : m_noise)
        value = static_cast<float>(quality.noise_grey) * normal(random);
    m_sum.resize(columns);
    m_padded.resize(columns + m_spot.size() - 1);
    for (Row& row : m_across)
        row.resize(columns);
}

PictureSensor::Row& PictureSensor::blurredRow(int y) {
    const auto taps = static_cast<int>(m_spot.size());
    return m_across[static_cast<std::size_t>((y + taps) % taps)];
}

// Rows and columns at the border stand for those beyond it.
void PictureSensor::blurAcross(const GreyCanvas& canvas, int y) {
    const std::size_t columns = m_sum.size(), reach = m_spot.size() / 2;
    const auto row = static_cast<std::size_t>(std::clamp(y, 0, canvas.height - 1));
    const float* const from = canvas.values.data() + row * columns;
    std::fill_n(m_padded.begin(), reach, from[0]);
    std::copy_n(from, columns, m_padded.data() + reach);
    std::fill_n(m_padded.data() + reach + columns, reach, from[columns - 1]);
    Row& to = blurredRow(y);
    std::fill(to.begin(), to.end(), 0.0F);
    for (std::size_t k = 0; k < m_spot.size(); ++k) {
        const float weight = m_spot[k], *const shifted = m_padded.data() + k;
        for (std::size_t x = 0; x < columns; ++x)
            to[x] += weight * shifted[x];
    }
}

void PictureSensor::blurDown(int y) {
    const auto reach = static_cast<int>(m_spot.size() / 2);
    std::fill(m_sum.begin(), m_sum.end(), 0.0F);
    for (int k = -reach; k <= reach; ++k) {
        const float weight = m_spot[static_cast<std::size_t>(k + reach)];
        const Row& row = blurredRow(y + k);
        for (std::size_t x = 0; x < m_sum.size(); ++x)
            m_sum[x] += weight * row[x];
    }
}

void PictureSensor::finish(int y, int height, std::uint64_t number, std::uint8_t* to) const {
    std::seed_seq seeds{m_quality.seed, m_quality.seed >> 32, number, number >> 32,
                        static_cast<std::uint64_t>(y)};
    std::uint32_t chosen = 0;
    seeds.generate(&chosen, &chosen + 1);
    const float* const noise = m_noise.data() + chosen % kOffsets;
    const auto fall = static_cast<float>(0.5 * m_quality.lightFall);
    const float light = 1.0F - fall * static_cast<float>(y) / static_cast<float>(height);
    const float step = fall / static_cast<float>(m_sum.size());
    for (std::size_t x = 0; x < m_sum.size(); ++x) {
        const float value = m_sum[x] * (light - step * static_cast<float>(static_cast<int>(x))) + noise[x];
        to[x] = static_cast<std::uint8_t>(static_cast<int>(std::clamp(value + 0.5F, 0.0F, 255.0F)));
    }
}

GreyPicture PictureSensor::caught(const GreyCanvas& canvas, std::uint64_t number) {
    GreyPicture picture{canvas.width, canvas.height, std::vector<std::uint8_t>(canvas.values.size())};
    const auto reach = static_cast<int>(m_spot.size() / 2);
    for (int y = -reach; y < reach; ++y)
        blurAcross(canvas, y);
    for (int y = 0; y < canvas.height; ++y) { // row by row while they are in the cache
        blurAcross(canvas, y + reach);
        blurDown(y);
        finish(y, canvas.height, number, picture.values.data() + static_cast<std::size_t>(y) * m_sum.size());
    }
    return picture;
}

} // namespace bask
