#pragma once
// Outlines and holes as arrays of numbers under the keys of a JSON object.

#include "engine/base/json_fields.h"
#include "engine/shape/contour.h"
#include "engine/shape/fourier_contour.h"

#include <string>
#include <vector>

namespace bask {

/// [[x, y], ...], m; counter-clockwise whatever the file has. Empty where there is no such key.
Contour readPoints(Fields& fields, const std::string& key);
/// An array of such rings.
std::vector<Contour> readHoles(Fields& fields, const std::string& key);
/// [[order, re, im], ...], m; counter-clockwise, too.
FourierContour readCoefficients(Fields& fields, const std::string& key);

} // namespace bask
