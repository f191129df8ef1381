#pragma once
// Fields for the coordinates of a pose.

#include "engine/base/parameter.h"

class QDoubleSpinBox;

namespace bask {

/// Lets a field, in millimetres or degrees, take what files may have: a valid range in cm or degrees.
void setCoordinateRange(QDoubleSpinBox& field, int coordinate, const ValidRange& range);

} // namespace bask
