#include "widgets/rig/check_mark.h"

#include "widgets/common/theme.h"

#include <QPainter>

namespace bask {

QPixmap checkMarkPixmap(CheckMark mark, bool dark, int size, double devicePixelRatio) {
    QPixmap pixmap(QSize(size, size) * devicePixelRatio);
    pixmap.setDevicePixelRatio(devicePixelRatio);
    pixmap.fill(Qt::transparent);
    if (mark == CheckMark::None)
        return pixmap;
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = mark == CheckMark::Tick    ? accentColor(dark)
                          : mark == CheckMark::Cross ? alarmColor(1, dark)
                                                     : secondaryText(dark);
    painter.setPen(QPen(colour, size * 0.14, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const auto at = [size](double x, double y) { return QPointF(x * size, y * size); };
    if (mark == CheckMark::Tick)
        painter.drawPolyline(QPolygonF{at(0.16, 0.54), at(0.40, 0.78), at(0.84, 0.24)});
    if (mark == CheckMark::Cross) {
        painter.drawLine(at(0.22, 0.22), at(0.78, 0.78));
        painter.drawLine(at(0.78, 0.22), at(0.22, 0.78));
    }
    if (mark == CheckMark::Waiting) // a clock
    {
        painter.setPen(QPen(colour, size * 0.10, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawEllipse(QRectF(at(0.12, 0.12), at(0.88, 0.88)));
        painter.drawPolyline(QPolygonF{at(0.5, 0.28), at(0.5, 0.52), at(0.66, 0.62)});
    }
    return pixmap;
}

} // namespace bask
