// How the canvas of a thermal picture is painted.

#include "widgets/common/colour_map.h"
#include "widgets/common/display.h"
#include "widgets/common/picture_painting.h"
#include "widgets/common/theme.h"
#include "widgets/thermal/thermal_canvas.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr bool kOnPicture = true; // colours over the picture are those for a dark ground, in either theme
constexpr double kBarGap = 10.0, kBar = 14.0, kTick = 4.0;
constexpr double kSpotArm = 9.0;

QPolygonF triangle(QPointF tip, double size) {
    return {{tip, tip + QPointF(-size, -0.6 * size), tip + QPointF(-size, 0.6 * size)}};
}

} // namespace

// The ends with the unit, whole steps between where there is room.
std::vector<ThermalCanvas::BarLabel> ThermalCanvas::barLabels(double height) const {
    const double from = displayTemperature(m_look.range.min_K, m_unit);
    const double to = displayTemperature(m_look.range.max_K, m_unit);
    std::vector<BarLabel> out{{m_look.range.min_K, formatTemperature(m_look.range.min_K, m_unit)},
                              {m_look.range.max_K, formatTemperature(m_look.range.max_K, m_unit)}};
    const double step = niceRange(from, to, std::max(1, static_cast<int>(height / 40.0))).step;
    const double needed = 1.8 * fontMetrics().height() * (to - from) / std::max(1.0, height);
    for (double k = std::ceil(from / step); k * step < to; k += 1.0)
        if (k * step - from > needed && to - k * step > needed) {
            const double T_K = kelvinFromDisplay(k * step, m_unit);
            out.push_back({T_K, formatTemperatureNumber(T_K, m_unit, step < 1.0 ? 1 : 0)});
        }
    return out;
}

double ThermalCanvas::barWidth() const {
    // The usual, so that the picture does not change its size with a digit more.
    int widest = fontMetrics().horizontalAdvance(formatTemperature(kelvinFromDisplay(100.0, m_unit), m_unit));
    for (const BarLabel& label : barLabels(0.0)) // the ends, with their unit, are the longest
        widest = std::max(widest, fontMetrics().horizontalAdvance(label.text));
    return kBarGap + kBar + kTick + 3.0 + widest;
}

QRectF ThermalCanvas::barRect() const {
    const QRectF place = pictureRect();
    return {place.right() + kBarGap, place.top() + 0.5, kBar, place.height() - 1.0};
}

void ThermalCanvas::paintPicture(QPainter& painter) {
    const QRectF place = pictureRect();
    if (!hasPicture(m_view)) {
        painter.fillRect(place, palette().color(QPalette::Base));
        return;
    }
    const QSize size = (place.size() * devicePixelRatioF()).toSize();
    if (m_scaled.size() != size) {
        m_scaled = QPixmap::fromImage(prepared().image.copy(m_pixels).scaled(
            size, Qt::IgnoreAspectRatio, m_isSmooth ? Qt::SmoothTransformation : Qt::FastTransformation));
        m_scaled.setDevicePixelRatio(devicePixelRatioF());
    }
    painter.drawPixmap(place.topLeft(), m_scaled);
}

void ThermalCanvas::paintOutlines(QPainter& painter) {
    const QTransform map = fromPixels();
    for (std::size_t i = 0; i < m_view.objects.size(); ++i) {
        QPen pen(seriesColor(static_cast<int>(i), kOnPicture), m_chosen == i ? 3.0 : 1.8);
        pen.setJoinStyle(Qt::RoundJoin);
        if (!m_view.objects[i].T_K)
            pen.setDashPattern({4.0, 3.0});
        paintCased(painter, map.map(outlineOf(i)), pen);
    }
}

void ThermalCanvas::paintLabels(QPainter& painter) {
    const QRectF place = pictureRect();
    constexpr double kNarrow = 420.0, kTooNarrow = 150.0;
    if (place.width() < kTooNarrow)
        return;
    const auto overlaps = [this](const QRectF& rect) {
        return std::ranges::any_of(m_labels, [&rect](const QRectF& other) { return rect.intersects(other); });
    };
    m_layout.begin(place.adjusted(3.0, 3.0, -3.0, -3.0));
    if (m_pinned && m_pixels.contains(*m_pinned)) { // asked for by a person, so first
        m_labels.push_back(spotBox(*m_pinned));
        m_layout.take(m_labels.back());
    }
    const QTransform map = fromPixels();
    std::vector<QRectF> anchors;
    for (std::size_t i = 0; i < m_view.objects.size(); ++i) {
        anchors.push_back(map.mapRect(outlineOf(i).boundingRect()) & place);
        m_layout.take(anchors.back(), 0.4);
    }
    for (std::size_t i = 0; i < m_view.objects.size(); ++i) {
        if (anchors[i].isEmpty())
            continue;
        const QString text = labelOf(i, place.width() < kNarrow);
        const QSizeF size = plateSize(painter.font(), text);
        if (size.width() > place.width() - 6.0 || size.height() > place.height() - 6.0)
            continue;
        const QRectF box = m_layout.place(i, anchors[i], size);
        if (overlaps(box))
            continue; // the list beside the picture has it
        paintPlate(painter, box, text, seriesColor(static_cast<int>(i), kOnPicture));
        m_labels.push_back(box);
    }
}

QString ThermalCanvas::spotLabel(QPoint pixel) const {
    const auto object = objectAt(pixel);
    return object ? nameOf(*object) + QStringLiteral("  ") + pixelText(pixel) : pixelText(pixel);
}

// To the right above it, where the picture has room.
QRectF ThermalCanvas::spotBox(QPoint pixel) const {
    const QRectF place = pictureRect();
    const QPointF at = pixelRect(pixel).center();
    QRectF box(QPointF(), plateSize(font(), spotLabel(pixel)));
    box.moveBottomLeft(at + QPointF(kSpotArm, -kSpotArm));
    if (box.right() > place.right())
        box.moveRight(at.x() - kSpotArm);
    if (box.top() < place.top())
        box.moveTop(at.y() + kSpotArm);
    box.moveLeft(std::max(place.left(), box.left()));
    return box;
}

void ThermalCanvas::paintSpot(QPainter& painter, QPoint pixel, bool isPinned) {
    const QPointF at = pixelRect(pixel).center();
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
        paintCased(painter, {{at + 0.45 * kSpotArm * way, at + kSpotArm * way}}, QPen(Qt::white, 1.6));
    paintPlate(painter, spotBox(pixel), spotLabel(pixel),
               isPinned ? QColor(Qt::white) : QColor(150, 150, 150));
}

void ThermalCanvas::paintBar(QPainter& painter) {
    const QRectF bar = barRect();
    const auto heightOf = [&](double T_K) {
        const double part = (T_K - m_look.range.min_K) / (m_look.range.max_K - m_look.range.min_K);
        return bar.bottom() - std::clamp(part, 0.0, 1.0) * bar.height();
    };
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    for (int k = 0; k <= 32; ++k)
        gradient.setColorAt(k / 32.0, thermalRgb(k / 32.0, m_look.palette));
    painter.setPen(secondaryText(isDark(this)));
    painter.setBrush(gradient);
    painter.drawRect(bar);
    if (m_look.isotherm) {
        const double low = heightOf(m_look.isotherm->T_K - m_look.isotherm->halfBand_K);
        const double high = m_look.isotherm->halfBand_K > 0.0
                                ? heightOf(m_look.isotherm->T_K + m_look.isotherm->halfBand_K)
                                : bar.top();
        QRectF band(bar.left() + 1.0, high, bar.width() - 2.0, std::max(2.0, low - high));
        painter.fillRect(band & bar, QColor::fromRgb(kIsothermRgb));
    }
    painter.setBrush(Qt::NoBrush);
    const QFontMetricsF metrics(painter.font());
    for (const BarLabel& label : barLabels(bar.height())) {
        const double y = heightOf(label.T_K);
        painter.setPen(secondaryText(isDark(this)));
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + kTick, y));
        const double half = 0.5 * metrics.height();
        const double middle = std::clamp(y, bar.top() + half - 3.0, bar.bottom() - half + 3.0);
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QRectF(bar.right() + kTick + 3.0, middle - half, 200.0, metrics.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, label.text);
    }
    if (const auto at = spot(); at && m_notice.isEmpty()) {
        const double T_K = m_view.picture->at(at->x(), at->y());
        if (!std::isnan(T_K)) {
            painter.setPen(Qt::NoPen);
            painter.setBrush(palette().color(QPalette::WindowText));
            painter.drawPolygon(triangle({bar.left() - 1.0, heightOf(T_K)}, 7.0));
        }
    }
}

void ThermalCanvas::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const QRectF place = pictureRect();
    m_labels.clear();
    paintPicture(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    if (hasPicture(m_view) && m_notice.isEmpty()) {
        painter.setClipRect(place);
        paintOutlines(painter);
        paintLabels(painter);
        if (m_hovered && m_hovered != m_pinned)
            paintSpot(painter, *m_hovered, false);
        if (m_pinned && m_pixels.contains(*m_pinned))
            paintSpot(painter, *m_pinned, true);
        painter.setClipping(false);
    }
    if (!m_notice.isEmpty()) {
        if (hasPicture(m_view))
            paintDimmed(painter, place);
        paintNotice(painter, place, m_notice, m_isProblem, *this);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2.0));
        painter.drawRect(place.adjusted(1.0, 1.0, -1.0, -1.0));
    }
    if (hasPicture(m_view))
        paintBar(painter);
}

} // namespace bask
