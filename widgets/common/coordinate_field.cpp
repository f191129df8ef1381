#include "widgets/common/coordinate_field.h"

#include "engine/base/pose.h"

#include <QDoubleSpinBox>

namespace bask {

void setCoordinateRange(QDoubleSpinBox& field, int coordinate, const ValidRange& range) {
    constexpr double kMmPerCm = 10.0;
    const double scale = coordinate < kThetaX ? kMmPerCm : 1.0;
    field.setRange(scale * range.min, scale * range.max);
}

} // namespace bask
