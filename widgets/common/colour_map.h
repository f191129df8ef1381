#pragma once
// Viridis, trimmed at the end that would vanish into a light or a dark background.

#include <QColor>

namespace bask {

/// Colour of a fraction of the range (clamped to 0..1); a NaN gives the neutral grey of "not known".
QColor mapColour(double fraction, bool dark);

/// Grey for a temperature that is not known.
QColor unknownColour(bool dark);

/// Least and most of a colour bar (shown unit) that holds the interval and begins and ends on a whole step.
struct NiceRange {
    double min = 0.0;
    double max = 1.0;
    double step = 1.0;
};

/// At most about `steps` steps of 1, 2 or 5 times a power of ten. Swaps and widens an empty interval.
NiceRange niceRange(double min, double max, int steps);

} // namespace bask
