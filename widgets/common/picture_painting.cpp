#include "widgets/common/picture_painting.h"

#include "widgets/common/theme.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QWidget>

#include <algorithm>

namespace bask {

void paintCased(QPainter& painter, const QPolygonF& line, const QPen& pen) {
    for (const QPen& each : {QPen(QColor(0, 0, 0, 170), pen.widthF() + 2.0), pen}) {
        painter.setPen(each);
        painter.drawPolyline(line);
    }
}

QSizeF plateSize(const QFont& font, const QString& text) {
    const QFontMetricsF metrics(font);
    return {metrics.horizontalAdvance(text) + 12.0, metrics.height() + 4.0};
}

void paintPlate(QPainter& painter, const QRectF& box, const QString& text, const QColor& edge) {
    painter.fillRect(box, QColor(0, 0, 0, 190));
    painter.fillRect(QRectF(box.topLeft(), QSizeF(3.0, box.height())), edge);
    painter.setPen(Qt::white);
    painter.drawText(box.adjusted(8.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter, text);
}

void paintDimmed(QPainter& painter, const QRectF& picture) {
    painter.fillRect(picture, QColor(0, 0, 0, 130));
    painter.fillRect(picture, QBrush(QColor(255, 255, 255, 60), Qt::BDiagPattern));
}

void paintNotice(QPainter& painter, const QRectF& place, const QString& sentence, bool isProblem,
                 const QWidget& widget) {
    constexpr int kIcon = 22;
    constexpr double kPad = 14.0;
    const double besides = isProblem ? kIcon + kPad : 0.0;
    const double widest = std::clamp(place.width() - 4.0 * kPad - besides, 80.0, 440.0);
    const QRectF words =
        painter.boundingRect(QRectF(0, 0, widest, place.height()), Qt::TextWordWrap, sentence);
    QRectF box(0, 0, words.width() + 2.0 * kPad + besides,
               std::max<double>(words.height(), kIcon) + 2.0 * kPad);
    box.moveCenter(place.center());
    painter.setPen(hairline(isDark(&widget)));
    painter.setBrush(widget.palette().color(QPalette::Window));
    painter.drawRoundedRect(box, 4.0, 4.0);
    QRectF inside = box.adjusted(kPad, kPad, -kPad, -kPad);
    if (isProblem) {
        const QPixmap icon = alarmPixmap(2, isDark(&widget), kIcon, widget.devicePixelRatioF());
        painter.drawPixmap(QPointF(inside.left(), inside.center().y() - 0.5 * kIcon), icon);
        inside.adjust(besides, 0.0, 0.0, 0.0);
    }
    painter.setPen(widget.palette().color(QPalette::WindowText));
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, sentence);
}

} // namespace bask
