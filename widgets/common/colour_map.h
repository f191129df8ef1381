#pragma once
// Viridis, cut at the end that would be invisible on a light or a dark background.

#include <QColor>

namespace bask {

/// Returns the colour of a fraction of the range (clamped to 0..1); for NaN the neutral grey of "not known".
QColor mapColour(double fraction, bool dark);

/// Grey for a temperature that is not known.
QColor unknownColour(bool dark);

/// Minimum and maximum of a colour bar (shown unit) that contains the interval and begins and ends on a whole
/// step.
struct NiceRange {
    double min = 0.0;
    double max = 1.0;
    double step = 1.0;
};

/// Returns a range with at most about `steps` steps of 1, 2 or 5 times a power of ten. Swaps the ends of a
/// reversed interval and widens an empty one.
NiceRange niceRange(double min, double max, int steps);

} // namespace bask
