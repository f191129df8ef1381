#include "widgets/thermal/thermal_zoom.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bask {

QRect zoomedPixels(const ThermalView& view, const QRect& shown) {
    constexpr double kMargin = 0.25, kFewest = 32.0, kTooLarge = 1.6;
    const int width = view.picture->width, height = view.picture->height;
    const QRect whole(0, 0, width, height);
    Eigen::AlignedBox2d seen;
    for (const ThermalObjectView& object : view.objects)
        for (const Eigen::Vector2d& point : object.outline_px)
            if (whole.contains(static_cast<int>(std::lround(point.x())),
                               static_cast<int>(std::lround(point.y()))))
                seen.extend(point);
    if (seen.isEmpty())
        return whole;
    // As a part of the picture's width and height.
    const Eigen::Vector2d needed = seen.sizes() * (1.0 + 2.0 * kMargin);
    const double part = std::min(1.0, std::max({needed.x() / width, needed.y() / height, kFewest / width}));
    const QRectF inside(seen.min().x(), seen.min().y(), seen.sizes().x(), seen.sizes().y());
    if (whole.contains(shown) && QRectF(shown).contains(inside) && shown.width() < kTooLarge * part * width)
        return shown;
    const QSize size(std::clamp(static_cast<int>(std::ceil(part * width)), 1, width),
                     std::clamp(static_cast<int>(std::ceil(part * height)), 1, height));
    const Eigen::Vector2d middle = seen.center();
    return {QPoint(std::clamp(static_cast<int>(std::lround(middle.x() - 0.5 * size.width())), 0,
                              width - size.width()),
                   std::clamp(static_cast<int>(std::lround(middle.y() - 0.5 * size.height())), 0,
                              height - size.height())),
            size};
}

} // namespace bask
