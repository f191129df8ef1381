#pragma once
// The grid of `bask field` as typed: axes, fixed coordinates and the named presets.

#include "engine/radiation/field_sampler.h"

#include <string>
#include <vector>

namespace bask {

/// "x=-0.2:0.2:0.01,theta_x=0:1.5:0.1": first, last and step, in m and rad; last counts when it lies on the
/// grid to within a millionth of a step. Errors name the axis and the number.
Result<std::vector<FieldAxis>> parseFieldAxes(const std::string& text);

/// "z=0.05,theta_x=0": sets those of `fixed`; a coordinate that is an axis is refused. `option` is named in
/// errors.
Result<void> parseFixed(const std::string& text, const std::vector<FieldAxis>& axes, Vector6d& fixed,
                        const std::string& option = "--hold");

/// The sampling grid of the paper.
struct PresetGrid {
    std::vector<FieldAxis> axes;
    Vector6d fixed = Vector6d::Zero();
};

/// paper-translation: x, y = -20 ... 19 cm, z = 1 ... 30 cm by 1 cm, parallel. paper-rotation: the angles
/// -90 ... 88 degrees by 2, at (0, 0, 5) cm.
Result<PresetGrid> presetGrid(const std::string& name);

Shape presetSource(); ///< disk of 10 cm
Shape presetObject(); ///< disk of 1.5 cm

} // namespace bask
