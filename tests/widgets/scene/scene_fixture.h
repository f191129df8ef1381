#pragma once
// A three-object experiment made by hand, a run of it, and helpers that look at pixels.

#include "engine/model/experiment.h"
#include "engine/model/trace.h"

#include <QColor>
#include <QImage>
#include <QString>

#include <vector>

namespace bask::test {

/// A disk, a Fourier outline and a non-convex polygon on a triangle of 5 cm; targets 50, 40 and 35 C.
Experiment threeObjects();

/// `count` samples of a spiral from the start down to the source, the objects warming on the way.
std::vector<TraceSample> spiral(int count);

/// Pixels within `tolerance` of a colour in each channel.
int pixelsOf(const QImage& image, const QColor& colour, int tolerance = 24);
/// Mean place of those pixels, (-1, -1) when there are none.
QPointF middleOf(const QImage& image, const QColor& colour, int tolerance = 24);
int differentPixels(const QImage& a, const QImage& b);
int coloursIn(const QImage& image);

/// Keeps a picture in the folder that BASK_SCREENSHOTS names, if it is set.
void keepScreenshot(const QImage& image, const QString& name);

} // namespace bask::test
