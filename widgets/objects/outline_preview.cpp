#include "widgets/objects/outline_preview.h"

#include "engine/base/units.h"
#include "widgets/common/colour_map.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kMargin = 14.0;
constexpr int kCurvePoints = 720;
constexpr int kColours = 32;
constexpr double kMinScale_mm = 0.001; // a perfect fit is not coloured by its rounding
constexpr double kMinStep = 0.5;       // px: what is shorter is not drawn
constexpr double kRawWidth = 4.0;
constexpr double kSample = 22.0; // of a line, in the legend
constexpr double kCentroidRadius = 2.5;
constexpr double kBarWidth = 10.0;
constexpr double kBarRoom = 64.0;

QColor faded(const QPalette& palette, double weight) {
    return mixed(palette.color(QPalette::Text), palette.color(QPalette::Base), weight);
}

/// What is far off stands out from the ground, light or dark.
QColor distanceColour(double fraction, bool dark) {
    return mapColour(dark ? fraction : 1.0 - fraction, dark);
}

/// In pixels, without the points that lie within half a pixel of the one before.
QPolygonF drawn(const QPolygonF& polygon_mm, const QTransform& map) {
    QPolygonF kept;
    for (const QPointF& p_mm : polygon_mm)
        if (const QPointF p = map.map(p_mm); kept.isEmpty() || QLineF(kept.back(), p).length() >= kMinStep)
            kept << p;
    return kept;
}

/// Within a millionth of the size: a series that was read from a file is not the fit to the last digit.
bool isSame(const FourierContour& a, const FourierContour& b) {
    if (a.harmonics() != b.harmonics() || a.harmonics() == 0)
        return false;
    const double allowed = 1e-6 * std::abs(a.coefficient(1));
    return std::ranges::equal(a.coefficients(), b.coefficients(),
                              [allowed](const auto& x, const auto& y) { return std::abs(x - y) <= allowed; });
}

} // namespace

Contour registered(const Contour& raw, const Shape& shape) {
    const auto* series = outlineAs<FourierContour>(shape);
    if (series == nullptr || raw.points_m.empty())
        return raw;
    // The least-squares constant term is the mean over arc length, so the two means coincide.
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double length = 0.0;
    for (std::size_t i = 0; i < raw.points_m.size(); ++i) {
        const Eigen::Vector2d& a = raw.points_m[i];
        const Eigen::Vector2d& b = raw.points_m[(i + 1) % raw.points_m.size()];
        const double edge = (b - a).norm();
        sum += 0.5 * edge * (a + b);
        length += edge;
    }
    const std::complex<double> c0 = series->coefficient(0);
    const Eigen::Vector2d shift = Eigen::Vector2d(c0.real(), c0.imag()) - sum / length;
    Contour moved = raw;
    for (Eigen::Vector2d& p : moved.points_m)
        p += shift;
    return moved;
}

OutlinePreview::OutlinePreview(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    retranslate();
}

void OutlinePreview::setObject(const QString& name, const Shape& shape, const Contour& raw,
                               const QColor& color) {
    m_name = name;
    m_color = color;
    const auto* series = outlineAs<FourierContour>(shape);
    m_series = series != nullptr ? *series : FourierContour();
    std::vector<std::vector<Eigen::Vector2d>> rings = shapeRings(shape, kCurvePoints);
    m_used_mm = polygon_mm({rings.front()});
    m_holes_mm.clear();
    for (std::size_t k = 1; k < rings.size(); ++k) {
        m_holes_mm.push_back(polygon_mm({rings[k]}));
        std::ranges::reverse(rings[k]); // as principalAxes takes holes
    }
    m_axes = principalAxes(rings);
    m_raw_mm = outlineAs<Contour>(shape) != nullptr ? QPolygonF() : polygon_mm(registered(raw, shape));
    m_rawPoints = static_cast<int>(raw.points_m.size());
    m_distances_mm.clear();
    retranslate();
    update();
}

void OutlinePreview::setDistances(const FourierFit& fit, const std::vector<Eigen::Vector2d>& points_m,
                                  const std::vector<double>& distances_m) {
    if (!isSame(fit.contour, m_series) || points_m.empty() || points_m.size() != distances_m.size())
        return;
    m_raw_mm.clear();
    m_raw_mm.reserve(static_cast<qsizetype>(points_m.size()));
    for (const Eigen::Vector2d& p : points_m) {
        const Eigen::Vector2d q = (p - fit.centre_m) * kMmPerM;
        m_raw_mm << QPointF(q.x(), q.y());
    }
    m_distances_mm.resize(distances_m.size());
    std::ranges::transform(distances_m, m_distances_mm.begin(), [](double d_m) { return d_m * kMmPerM; });
    m_max_mm = *std::ranges::max_element(m_distances_mm);
    retranslate();
    update();
}

void OutlinePreview::clear() {
    m_name.clear();
    m_used_mm.clear();
    m_holes_mm.clear();
    m_raw_mm.clear();
    m_distances_mm.clear();
    m_series = FourierContour();
    retranslate();
    update();
}

void OutlinePreview::retranslate() {
    setAccessibleName(tr("Outline"));
    const auto text = [](double value_mm, int decimals) {
        return QLocale().toString(value_mm, 'f', decimals);
    };
    const QRectF box = m_used_mm.boundingRect();
    QStringList sentences;
    if (!m_used_mm.isEmpty())
        sentences
            << tr("%1, %2 mm wide and %3 mm high").arg(m_name, text(box.width(), 1), text(box.height(), 1))
            << axesText();
    if (isColoured())
        sentences << tr("Imported outline at most %1 mm from the Fourier outline").arg(text(m_max_mm, 3));
    setAccessibleDescription(sentences.join(QStringLiteral(". ")));
}

QString OutlinePreview::axesText() const {
    return tr("Centroid, principal axes: radii of gyration %1 mm and %2 mm")
        .arg(QLocale().toString(m_axes.major_m * kMmPerM, 'f', 1),
             QLocale().toString(m_axes.minor_m * kMmPerM, 'f', 1));
}

void OutlinePreview::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

void OutlinePreview::paintGrid(QPainter& painter, const QTransform& map) const {
    const double pixelsPerMm = map.m11();
    const double step = niceLength(std::max(60.0 / pixelsPerMm, 1e-6));
    const QRectF visible = map.inverted().mapRect(QRectF(rect()));
    painter.setPen(QPen(faded(palette(), 0.09), 1.0));
    for (double x = std::ceil(visible.left() / step) * step; x <= visible.right(); x += step)
        painter.drawLine(QLineF(map.map(QPointF(x, visible.top())), map.map(QPointF(x, visible.bottom()))));
    for (double y = std::ceil(visible.top() / step) * step; y <= visible.bottom(); y += step)
        painter.drawLine(QLineF(map.map(QPointF(visible.left(), y)), map.map(QPointF(visible.right(), y))));
}

void OutlinePreview::paintDistances(QPainter& painter, const QTransform& map) const {
    // What is nearer than half a pixel is drawn as one, with the largest of its distances; stretches of one
    // colour are one line.
    const bool dark = isDark(this);
    const double perMm = kColours / std::max(m_max_mm, kMinScale_mm);
    const auto levelOf = [&](double distance_mm) {
        return std::min(static_cast<int>(distance_mm * perMm), kColours - 1);
    };
    const auto draw = [&](const QPolygonF& line, int level) {
        painter.setPen(QPen(distanceColour((level + 0.5) / kColours, dark), kRawWidth, Qt::SolidLine,
                            Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(line);
    };
    QPolygonF line{map.map(m_raw_mm.front())};
    int level = -1; // of the line
    double max_mm = m_distances_mm.front();
    for (qsizetype k = 1; k <= m_raw_mm.size(); ++k) {
        const qsizetype at = k % m_raw_mm.size();
        const QPointF p = map.map(m_raw_mm[at]);
        max_mm = std::max(max_mm, m_distances_mm[static_cast<std::size_t>(at)]);
        if (at != 0 && QLineF(line.back(), p).length() < kMinStep)
            continue;
        const int next = levelOf(max_mm);
        if (level >= 0 && next != level) {
            draw(line, level);
            line = {line.back()};
        }
        level = next;
        line << p;
        max_mm = m_distances_mm[static_cast<std::size_t>(at)];
    }
    draw(line, level);
}

void OutlinePreview::paintOutlines(QPainter& painter, const QTransform& map) const {
    QColor fill = m_color;
    fill.setAlphaF(0.16f);
    QPainterPath used;
    used.addPolygon(drawn(m_used_mm, map));
    used.closeSubpath();
    for (const QPolygonF& hole : m_holes_mm) {
        used.addPolygon(drawn(hole, map));
        used.closeSubpath();
    }
    painter.fillPath(used, fill);
    if (isColoured())
        paintDistances(painter, map);
    painter.strokePath(used, QPen(m_color, isColoured() ? 1.4 : 2.2));
    if (!isColoured() && !m_raw_mm.isEmpty()) {
        painter.setPen(QPen(faded(palette(), 0.8), 1.2, Qt::DashLine));
        painter.drawPolygon(drawn(m_raw_mm, map));
    }
}

void OutlinePreview::paintAxes(QPainter& painter, const QTransform& map) const {
    const auto at = [&](const Eigen::Vector2d& p_m) { return map.map(QPointF(p_m.x(), p_m.y()) * kMmPerM); };
    const Eigen::Vector2d minor(-m_axes.major.y(), m_axes.major.x());
    painter.setPen(QPen(palette().color(QPalette::Text), 1.2));
    for (const Eigen::Vector2d& half :
         {Eigen::Vector2d(m_axes.major * m_axes.major_m), Eigen::Vector2d(minor * m_axes.minor_m)})
        painter.drawLine(at(m_axes.centroid_m - half), at(m_axes.centroid_m + half));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(at(m_axes.centroid_m), kCentroidRadius, kCentroidRadius);
    painter.setBrush(Qt::NoBrush);
}

QLinearGradient OutlinePreview::colours(const QPointF& from, const QPointF& to) const {
    QLinearGradient gradient(from, to);
    for (int k = 0; k <= kColours; ++k)
        gradient.setColorAt(static_cast<double>(k) / kColours,
                            distanceColour(static_cast<double>(k) / kColours, isDark(this)));
    return gradient;
}

void OutlinePreview::paintLegend(QPainter& painter, const QRectF& area) const {
    const double line = fontMetrics().height() + 3.0;
    const QPen text(palette().color(QPalette::Text));
    QPointF at(area.left(), area.top() + line / 2.0);
    const auto entry = [&](const QPen& pen, const QString& words) {
        painter.setPen(pen);
        painter.drawLine(at, at + QPointF(kSample, 0.0));
        painter.setPen(text);
        const QRectF room(at.x() + kSample + 8.0, at.y() - line / 2.0, area.width() - kSample - 8.0, line);
        painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(room.width())));
        at += QPointF(0.0, line);
    };
    if (isColoured())
        entry(
            QPen(colours(at, at + QPointF(kSample, 0.0)), kRawWidth),
            tr("Imported outline, %1 points, coloured by its distance").arg(QLocale().toString(m_rawPoints)));
    else if (!m_raw_mm.isEmpty())
        entry(QPen(faded(palette(), 0.8), 1.2, Qt::DashLine),
              tr("Imported outline, %1 points").arg(QLocale().toString(m_rawPoints)));
    entry(QPen(m_color, isColoured() ? 1.4 : 2.2),
          m_series.harmonics() > 0 ? tr("Fourier outline, %1").arg(harmonicsText(m_series.harmonics()))
                                   : tr("Outline used"));
    const QPointF middle = at + QPointF(kSample / 2.0, 0.0);
    painter.setPen(QPen(text.color(), 1.2));
    painter.drawLine(middle - QPointF(0.0, 5.0), middle + QPointF(0.0, 5.0));
    entry(painter.pen(), axesText());
    painter.setPen(QPen(text.color(), 1.2));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawEllipse(middle, kCentroidRadius, kCentroidRadius);
    painter.setBrush(Qt::NoBrush);
}

void OutlinePreview::paintColourBar(QPainter& painter, const QRectF& area) const {
    const double line = fontMetrics().height();
    const QRectF bar(area.right() - kBarWidth, area.top() + line + 4.0, kBarWidth,
                     area.height() - 2.0 * line - 8.0);
    painter.fillRect(bar, colours(bar.bottomLeft(), bar.topLeft()));
    painter.setPen(palette().color(QPalette::Text));
    const auto label = [&](double bottom, const QString& text) {
        painter.drawText(QRectF(0.0, bottom - line, area.right(), line), Qt::AlignRight | Qt::AlignVCenter,
                         text);
    };
    label(area.top() + line, tr("%1 mm").arg(QLocale().toString(std::max(m_max_mm, kMinScale_mm), 'f', 3)));
    label(area.bottom(), tr("0 mm"));
}

void OutlinePreview::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    const QRectF area = QRectF(rect()).adjusted(kMargin, kMargin, -kMargin, -kMargin);
    if (m_used_mm.isEmpty()) {
        painter.setPen(faded(palette(), 0.65));
        painter.drawText(area, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Drop a drawing, a CSV or a picture of a silhouette here, or add a disk."));
        return;
    }
    const double legend = 3.0 * (fontMetrics().height() + 3.0) + 6.0;
    QRectF view = area.adjusted(0.0, legend, 0.0, -fontMetrics().height() - 14.0);
    const QRectF besideView(view.right() - kBarRoom, view.top(), kBarRoom, view.height());
    if (m_series.harmonics() > 0)
        view.adjust(kBarRoom, 0.0, -kBarRoom, 0.0); // whether coloured yet or not, so that nothing jumps
    const QRectF content = m_used_mm.boundingRect().united(m_raw_mm.boundingRect());
    const QTransform map = fitted(content, view);
    paintGrid(painter, map);
    paintOutlines(painter, map);
    paintAxes(painter, map);
    paintLegend(painter, area);
    if (isColoured())
        paintColourBar(painter, besideView);
    painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
    paintScaleBar(painter, area, map.m11());
    const QRectF box = m_used_mm.boundingRect();
    painter.drawText(
        area, Qt::AlignRight | Qt::AlignBottom,
        tr("%1 mm \u00d7 %2 mm")
            .arg(QLocale().toString(box.width(), 'f', 1), QLocale().toString(box.height(), 'f', 1)));
}

} // namespace bask
