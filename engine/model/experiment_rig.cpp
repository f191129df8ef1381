#include "engine/model/experiment_rig.h"

namespace bask {

std::shared_ptr<const RigGeometry> rigGeometry(const Experiment& experiment) {
    std::vector<Shape> shapes;
    std::vector<Vector6d> mountings;
    for (const ObjectSpec& object : experiment.objects) {
        shapes.push_back(object.shape);
        mountings.push_back(object.mounting);
    }
    return std::make_shared<RigGeometry>(experiment.source.shape, shapes, mountings, experiment.robot,
                                         poseFromCoordinates(experiment.source.pose));
}

} // namespace bask
