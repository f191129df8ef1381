#include "engine/calibration/marker_layout.h"

#include "engine/base/message_code.h"

#include <set>

namespace bask {

std::array<Eigen::Vector3d, 4> PlacedMarker::corners() const {
    const double h = 0.5 * side_m;
    return {X_PM * Eigen::Vector3d(-h, h, 0), X_PM * Eigen::Vector3d(h, h, 0),
            X_PM * Eigen::Vector3d(h, -h, 0), X_PM * Eigen::Vector3d(-h, -h, 0)};
}

Result<void> checkLayout(const MarkerLayout& layout) {
    std::set<int> ids;
    for (std::size_t k = 0; k < layout.markers.size(); ++k) {
        const PlacedMarker& marker = layout.markers[k];
        const std::string where = "markers[" + std::to_string(k) + "]";
        const int count = markerCount(layout.dictionary);
        if (marker.id < 0 || marker.id >= count)
            return Error{MessageCode::ValueOutOfRange,
                         where + ".id",
                         {std::to_string(marker.id), "0", std::to_string(count - 1), ""}};
        if (!ids.insert(marker.id).second)
            return Error{MessageCode::MarkerListedTwice, where + ".id", {std::to_string(marker.id)}};
        const double side_mm = 1e3 * marker.side_m;
        if (!(side_mm >= kMinMarkerSide_mm && side_mm <= kMaxMarkerSide_mm))
            return Error{MessageCode::ValueOutOfRange,
                         where + ".side_mm",
                         {formatNumber(side_mm), formatNumber(kMinMarkerSide_mm),
                          formatNumber(kMaxMarkerSide_mm), "mm"}};
        if (!marker.X_PM.matrix().allFinite())
            return Error{MessageCode::NumbersUnusable, where + ".pose", {"pose"}};
    }
    return {};
}

std::string idsText(std::span<const int> ids) {
    std::string text;
    for (const int id : ids)
        text += (text.empty() ? "" : ", ") + std::to_string(id);
    return text;
}

} // namespace bask
