#include "engine/model/vision_spec.h"

#include <algorithm>

namespace bask {

bool VisionSpec::marks(Part part) const {
    return std::ranges::find(markers, part, &MarkerSpec::part) != markers.end();
}

bool VisionSpec::followsSource() const {
    return marks(Part::Source) && camera && cameraPose;
}

MarkerLayout markerLayout(const VisionSpec& vision) {
    MarkerLayout layout;
    layout.dictionary.name = vision.dictionary;
    for (const MarkerSpec& marker : vision.markers)
        layout.markers.push_back({marker.part, marker.id, marker.side_m, poseFromCoordinates(marker.pose)});
    return layout;
}

} // namespace bask
