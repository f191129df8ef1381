#pragma once
// A slider over a range of one pose coordinate.

#include "engine/base/pose.h"
#include "engine/base/units.h"

#include <QSlider>

#include <algorithm>
#include <cmath>

namespace bask {

/// Steps of 1 mm or half a degree; an arrow key moves one step, a page an eighth of the range.
class CoordinateSlider : public QSlider {
public:
    explicit CoordinateSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {}

    /// m or rad. The slider keeps its relative position in the range.
    void setCoordinate(int coordinate, double min, double max) {
        m_stepsPerUnit = coordinate < kThetaX ? 1000.0 : 2.0 * degFromRad(1.0);
        setRange(steps(min), steps(max));
        setPageStep(std::max(1, (maximum() - minimum()) / 8));
    }
    double place() const { return value() / m_stepsPerUnit; }
    void setPlace(double place) { setValue(steps(place)); }

private:
    int steps(double place) const { return static_cast<int>(std::lround(place * m_stepsPerUnit)); }

    double m_stepsPerUnit = 1000.0;
};

} // namespace bask
