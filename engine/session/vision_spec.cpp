#include "engine/session/vision_spec.h"

#include <algorithm>

namespace bask {

bool VisionSpec::followsSource() const {
    const bool marked = std::ranges::any_of(markers, [](const auto& m) { return m.part == Part::Source; });
    return marked && camera && cameraPose;
}

MarkerLayout markerLayout(const VisionSpec& vision) {
    MarkerLayout layout;
    layout.dictionary.name = vision.dictionary;
    for (const MarkerSpec& marker : vision.markers)
        layout.markers.push_back({marker.part, marker.id, marker.side_m, poseFromCoordinates(marker.pose)});
    return layout;
}

} // namespace bask
