#include "engine/session/vision_spec.h"

#include <algorithm>
#include <numbers>

namespace bask {

bool VisionSpec::followsSource() const {
    const bool marked = std::ranges::any_of(markers, [](const auto& m) { return m.part == Part::Source; });
    return marked && camera && cameraPose;
}

SimulatedCameraSpec::SimulatedCameraSpec() {
    model.width = 1280;
    model.height = 720;
    model.fx = 1002.0;
    model.fy = 1000.0;
    model.cx = 645.0;
    model.cy = 355.0;
    model.distortion = {-0.12, 0.06, 0.0008, -0.0005, 0.0};
    const double degree = std::numbers::pi / 180.0;
    pose << 0.0, -0.45, 0.55, -140.0 * degree, 0.0, 0.0;
}

MarkerLayout markerLayout(const VisionSpec& vision) {
    MarkerLayout layout;
    layout.dictionary.name = vision.dictionary;
    for (const MarkerSpec& marker : vision.markers)
        layout.markers.push_back({marker.part, marker.id, marker.side_m, poseFromCoordinates(marker.pose)});
    return layout;
}

} // namespace bask
