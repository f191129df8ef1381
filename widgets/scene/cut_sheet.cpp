#include "widgets/scene/cut_sheet.h"

#include <algorithm>
#include <array>

namespace bask {

CutSheet sheetOf(const Field& field, int axis, double position) {
    const auto normal = static_cast<std::size_t>(axis);
    const std::size_t u = (normal + 1) % 3, v = (normal + 2) % 3;
    const std::vector<FieldAxis>& axes = field.axes;
    const double layer =
        std::clamp((position - axes[normal].first) / axes[normal].step, 0.0, axes[normal].count - 1.0);
    const int below = std::min(static_cast<int>(layer), std::max(0, axes[normal].count - 2));
    const double share = layer - below;
    CutSheet sheet;
    sheet.columns = axes[u].count;
    std::array<int, 3> index{};
    const auto value = [&] {
        const auto count = [&axes](std::size_t a) { return static_cast<std::size_t>(axes[a].count); };
        return field.values[static_cast<std::size_t>(index[0]) +
                            count(0) * (static_cast<std::size_t>(index[1]) +
                                        count(1) * static_cast<std::size_t>(index[2]))];
    };
    for (index[v] = 0; index[v] < axes[v].count; ++index[v])
        for (index[u] = 0; index[u] < axes[u].count; ++index[u]) {
            index[normal] = below;
            double F = value();
            if (share > 0.0) {
                index[normal] = below + 1;
                F += share * (value() - F);
            }
            Eigen::Vector3d point;
            point[static_cast<int>(u)] = axes[u].at(index[u]);
            point[static_cast<int>(v)] = axes[v].at(index[v]);
            point[static_cast<int>(normal)] = axes[normal].at(0) + layer * axes[normal].step;
            sheet.points.push_back(point);
            sheet.values.push_back(F);
        }
    return sheet;
}

} // namespace bask
