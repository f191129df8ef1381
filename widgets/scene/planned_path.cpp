#include "widgets/scene/planned_path.h"

#include <algorithm>

namespace bask {

std::vector<Eigen::Vector3d> dashedLine(const std::vector<Eigen::Vector3d>& line, double dash_m) {
    std::vector<Eigen::Vector3d> ends;
    bool isDash = true;
    double left_m = dash_m; // of the dash or the gap
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector3d way = line[i] - line[i - 1];
        const double length_m = way.norm();
        double from_m = 0.0;
        while (from_m < length_m) {
            const double to_m = std::min(from_m + left_m, length_m);
            if (isDash) {
                ends.emplace_back(line[i - 1] + from_m / length_m * way);
                ends.emplace_back(line[i - 1] + to_m / length_m * way);
            }
            left_m -= to_m - from_m;
            if (to_m < length_m || left_m <= 0.0) {
                isDash = !isDash;
                left_m = dash_m;
            }
            from_m = to_m;
        }
    }
    return ends;
}

std::vector<Eigen::Vector3d> plannedPath(const std::vector<Eigen::Vector3d>& line, double dash_m) {
    std::vector<Eigen::Vector3d> ends = dashedLine(line, dash_m);
    if (!line.empty())
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-0.5, 0.5})
                ends.emplace_back(line.back() + side * dash_m * Eigen::Vector3d::Unit(axis));
    return ends;
}

} // namespace bask
