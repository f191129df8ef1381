#include "engine/radiation/lambert_batch.h"

#include "engine/radiation/kernels/kernels.h"

namespace bask {

// Repeats the last line until the kernels' vectors are full.
template <std::size_t kRows> std::array<double*, kRows> LambertBatch::Lines<kRows>::pad() {
    std::array<double*, kRows> all;
    for (std::size_t row = 0; row < kRows; ++row) {
        for (int i = count; i % kernels::kPadding != 0; ++i)
            rows[row][static_cast<std::size_t>(i)] = rows[row][static_cast<std::size_t>(count) - 1];
        all[row] = rows[row].data();
    }
    return all;
}

void LambertBatch::finishStraights() {
    if (m_straights.count == 0)
        return;
    kernels::kernels().straightFields(m_straights.pad().data(), m_straights.count);
    const auto& rows = m_straights.rows;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_straights.count); ++i)
        add(m_straights.points[i], m_straights.factors[i],
            Eigen::Vector3d(rows[0][i], rows[1][i], rows[2][i]));
    m_straights.count = 0;
}

void LambertBatch::finishArcs() {
    if (m_arcs.count == 0)
        return;
    kernels::kernels().arcFields(m_arcs.pad().data(), m_arcs.count);
    const auto& rows = m_arcs.rows;
    for (std::size_t i = 0; i < static_cast<std::size_t>(m_arcs.count); ++i)
        add(m_arcs.points[i], m_arcs.factors[i],
            *m_axes[i] * Eigen::Vector3d(rows[0][i], rows[1][i], rows[2][i]));
    m_arcs.count = 0;
}

} // namespace bask
