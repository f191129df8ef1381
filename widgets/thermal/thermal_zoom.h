#pragma once
// Which part of a thermal picture shows its objects large.

#include "engine/thermography/thermal_view.h"

#include <QRect>

namespace bask {

/// Returns the pixels of a picture that hold all outlines with a margin, in the picture's proportions; the
/// whole picture if none is seen. `shown` is kept while it fits about as well, so that the picture does not
/// move with the objects. The view must have a picture.
QRect zoomedPixels(const ThermalView& view, const QRect& shown);

} // namespace bask
