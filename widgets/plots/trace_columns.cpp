#include "widgets/plots/trace_columns.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double finiteOrNaN(double value) {
    return std::isfinite(value) ? value : kNaN;
}

} // namespace

void TraceColumns::reset(std::size_t objects) {
    *this = TraceColumns();
    m_objects = objects;
    m_columns.resize(objects);
    m_targets.resize(objects);
}

std::size_t TraceColumns::append(const std::vector<TraceSample>& samples) {
    const std::size_t first = rows();
    for (const TraceSample& sample : samples) {
        if (!std::isfinite(sample.time_s) || (!m_time_s.empty() && sample.time_s <= m_time_s.back()))
            continue;
        m_time_s.push_back(sample.time_s);
        m_translation_m_s.push_back(finiteOrNaN(sample.twist.head<3>().norm()));
        m_rotation_rad_s.push_back(finiteOrNaN(sample.twist.tail<3>().norm()));
        for (std::size_t i = 0; i < m_objects; ++i) {
            const bool known = i < sample.objects.size();
            const ObjectSample object = known ? sample.objects[i] : ObjectSample{};
            const double measured_K = known && object.valid ? finiteOrNaN(object.measured_K) : kNaN;
            ObjectColumns& columns = m_columns[i];
            columns.measured_K.push_back(measured_K);
            columns.error_K.push_back(finiteOrNaN(measured_K - object.target_K));
            columns.viewFactor.push_back(known ? finiteOrNaN(object.viewFactor) : kNaN);
            columns.rate_K_s.push_back(known && object.valid ? finiteOrNaN(object.rate_K_s) : kNaN);
            columns.lambda1.push_back(known ? finiteOrNaN(object.lambda1) : kNaN);
            auto& steps = m_targets[i];
            if (known && std::isfinite(object.target_K) &&
                (steps.empty() || steps.back().second != object.target_K))
                steps.emplace_back(sample.time_s, object.target_K);
        }
    }
    return first;
}

std::size_t TraceColumns::seriesCount(Quantity quantity, std::size_t objects) {
    return quantity == Quantity::Speed ? 2 : objects;
}

double TraceColumns::value(Quantity quantity, std::size_t series, std::size_t row) const {
    if (quantity == Quantity::Speed)
        return series == 0 ? m_translation_m_s[row] : m_rotation_rad_s[row];
    const ObjectColumns& columns = m_columns[series];
    switch (quantity) {
    case Quantity::Error:
        return columns.error_K[row];
    case Quantity::ViewFactor:
        return columns.viewFactor[row];
    case Quantity::Rate:
        return columns.rate_K_s[row];
    case Quantity::Strength:
        return columns.lambda1[row];
    default:
        return columns.measured_K[row];
    }
}

std::size_t TraceColumns::lowerRow(double time_s) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(m_time_s, time_s) - m_time_s.begin());
}

std::size_t TraceColumns::nearestRow(double time_s) const {
    if (m_time_s.empty())
        return 0;
    const std::size_t after = std::min(lowerRow(time_s), rows() - 1);
    return after > 0 && time_s - m_time_s[after - 1] < m_time_s[after] - time_s ? after - 1 : after;
}

} // namespace bask
