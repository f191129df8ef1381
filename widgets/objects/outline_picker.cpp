#include "widgets/objects/outline_picker.h"

#include "engine/base/units.h"
#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr double kMargin_px = 18.0;
constexpr double kHandle_px = 7.0;
constexpr double kGrab_px = 14.0;
constexpr double kMaxZoom = 40.0;

QPointF asPoint(const Eigen::Vector2d& p) {
    return {p.x(), p.y()};
}

} // namespace

OutlinePicker::OutlinePicker(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setMouseTracking(true);
    retranslate();
}

void OutlinePicker::clear() {
    m_picture = {};
    m_rings.clear();
    m_selected = -1;
    m_ruler_px.reset();
    m_rulerShown = false;
    m_dragged = -1;
    m_zoom = 1.0;
    m_pan = {};
    setTool(Tool::Pick);
}

void OutlinePicker::setPicture(const QImage& picture) {
    m_picture = picture;
    update();
}

void OutlinePicker::setOutlines(const OutlineFile& file) {
    m_rings.clear();
    for (const FileOutline& outline : file.outlines) {
        Ring ring{{}, {}, outline.closed, outline.hole, outline.holeIn};
        ring.points.reserve(static_cast<qsizetype>(outline.points_m.size()));
        for (const Eigen::Vector2d& p : outline.points_m)
            ring.points << asPoint(file.plane ? file.plane->toPixels(p) : Eigen::Vector2d(kMmPerM * p));
        ring.box = ring.points.boundingRect();
        m_rings.push_back(std::move(ring));
    }
    m_selected = std::min(m_selected, static_cast<int>(m_rings.size()) - 1);
    layRuler();
    update();
}

void OutlinePicker::setSelected(int index) {
    m_selected = index;
    update();
}

void OutlinePicker::setTool(Tool tool) {
    m_tool = tool;
    setCursor(tool == Tool::Pick ? Qt::ArrowCursor : Qt::CrossCursor);
    update();
    if (std::exchange(m_secondEnd, false) && m_ruler_px)
        emit rulerMoved(*m_ruler_px); // as it is drawn, whether its second end was clicked or not
}

void OutlinePicker::setRulerShown(bool shown) {
    m_rulerShown = shown;
    m_dragged = -1;
    layRuler();
    update();
}

void OutlinePicker::layRuler() {
    if (!m_rulerShown || m_ruler_px || m_rings.empty())
        return;
    const QRectF box = m_rings.front().box;
    m_ruler_px = QLineF(box.left(), box.center().y(), box.right(), box.center().y());
    emit rulerMoved(*m_ruler_px);
}

QRectF OutlinePicker::content() const {
    if (!m_picture.isNull())
        return QRectF(m_picture.rect()).translated(-0.5, -0.5);
    QRectF all;
    for (const Ring& ring : m_rings)
        all = all.united(ring.box);
    return all;
}

QTransform OutlinePicker::map() const {
    const QRectF view = QRectF(rect()).adjusted(kMargin_px, kMargin_px, -kMargin_px, -kMargin_px);
    const QRectF all = content();
    QTransform fit = fitted(all, view);
    if (!m_picture.isNull()) // y down, as pixels go
        fit =
            QTransform::fromTranslate(0.0, -2.0 * all.center().y()) * QTransform::fromScale(1.0, -1.0) * fit;
    const QPointF middle = view.center();
    return fit * QTransform::fromTranslate(-middle.x(), -middle.y()) * QTransform::fromScale(m_zoom, m_zoom) *
           QTransform::fromTranslate(middle.x() + m_pan.x(), middle.y() + m_pan.y());
}

int OutlinePicker::ringAt(const QPointF& place) const {
    for (int i = static_cast<int>(m_rings.size()) - 1; i >= 0; --i) { // the smallest stand last
        const Ring& ring = m_rings[static_cast<std::size_t>(i)];
        if (ring.closed && !ring.hole && ring.box.contains(place) &&
            ring.points.containsPoint(place, Qt::OddEvenFill))
            return i;
    }
    return -1;
}

// The median of a few pixels, so that noise and a grain of dust do not count.
QColor OutlinePicker::colourAt(const QPointF& place) const {
    constexpr int kReach = 2;
    const QPoint middle = place.toPoint();
    std::array<std::vector<int>, 3> values;
    for (int y = middle.y() - kReach; y <= middle.y() + kReach; ++y)
        for (int x = middle.x() - kReach; x <= middle.x() + kReach; ++x)
            if (m_picture.valid(x, y)) {
                const QRgb pixel = m_picture.pixel(x, y);
                values[0].push_back(qRed(pixel));
                values[1].push_back(qGreen(pixel));
                values[2].push_back(qBlue(pixel));
            }
    if (values[0].empty())
        return {};
    for (std::vector<int>& channel : values)
        std::ranges::nth_element(channel, channel.begin() + static_cast<std::ptrdiff_t>(channel.size() / 2));
    const auto median = [](const std::vector<int>& channel) { return channel[channel.size() / 2]; };
    return {median(values[0]), median(values[1]), median(values[2])};
}

int OutlinePicker::rulerEndAt(const QPointF& position) const {
    if (!m_rulerShown || !m_ruler_px)
        return -1;
    const QLineF line = map().map(*m_ruler_px);
    const double first = QLineF(position, line.p1()).length(), second = QLineF(position, line.p2()).length();
    return std::min(first, second) > kGrab_px ? -1 : first <= second ? 0 : 1;
}

void OutlinePicker::setRulerEnd(int end, const QPointF& place) {
    if (end == 0)
        m_ruler_px->setP1(place);
    else
        m_ruler_px->setP2(place);
    update();
}

void OutlinePicker::click(const QPointF& position) {
    const QPointF place = map().inverted().map(position);
    switch (m_tool) {
    case Tool::Pick:
        if (const int index = ringAt(place); index >= 0)
            emit outlineClicked(index);
        return;
    case Tool::Measure:
        if (!m_secondEnd) {
            m_ruler_px = QLineF(place, place);
            m_secondEnd = true;
            update();
            return;
        }
        setRulerEnd(1, place);
        setTool(Tool::Pick);
        emit measured();
        return;
    case Tool::Colour:
        if (const QColor colour = colourAt(place); colour.isValid())
            emit colourPicked(colour);
        return;
    }
}

void OutlinePicker::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return QWidget::mousePressEvent(event);
    m_dragged = m_tool == Tool::Pick ? rulerEndAt(event->position()) : -1;
    if (m_dragged < 0)
        click(event->position());
}

void OutlinePicker::mouseMoveEvent(QMouseEvent* event) {
    const QPointF place = map().inverted().map(event->position());
    if (m_dragged >= 0)
        setRulerEnd(m_dragged, place);
    else if (m_tool == Tool::Measure && m_secondEnd)
        setRulerEnd(1, place);
    else if (m_tool == Tool::Pick)
        setCursor(rulerEndAt(event->position()) >= 0 ? Qt::SizeAllCursor
                  : ringAt(place) >= 0               ? Qt::PointingHandCursor
                                                     : Qt::ArrowCursor);
}

void OutlinePicker::mouseReleaseEvent(QMouseEvent*) {
    if (std::exchange(m_dragged, -1) >= 0)
        emit rulerMoved(*m_ruler_px);
}

void OutlinePicker::mouseDoubleClickEvent(QMouseEvent*) {
    m_zoom = 1.0;
    m_pan = {};
    update();
}

void OutlinePicker::wheelEvent(QWheelEvent* event) {
    const QPointF place = map().inverted().map(event->position());
    m_zoom = std::clamp(m_zoom * std::exp2(event->angleDelta().y() / 480.0), 1.0, kMaxZoom);
    if (m_zoom == 1.0)
        m_pan = {};
    else
        m_pan += event->position() - map().map(place); // what is under the pointer stays there
    update();
    event->accept();
}

void OutlinePicker::paintRings(QPainter& painter, const QTransform& map) const {
    const QColor accent = accentColor(isDark(this));
    const QColor plain = m_picture.isNull() ? palette().color(QPalette::Text) : QColor(0x20, 0x20, 0x20);
    const auto isOfSelected = [this](const Ring& ring) {
        return m_selected >= 0 && ring.holeIn == static_cast<std::size_t>(m_selected);
    };
    painter.setBrush(Qt::NoBrush);
    for (const Ring& ring : m_rings) {
        QPen pen(plain, 1.2);
        if (ring.hole)
            pen.setDashPattern({4.0, 3.0});
        if (!ring.closed)
            pen.setDashPattern({1.0, 3.0});
        const QPolygonF drawn = map.map(ring.points);
        if (!m_picture.isNull()) { // a light rim, since the picture may be as dark as the line
            painter.setPen(QPen(QColor(255, 255, 255, 200), 3.0));
            ring.closed ? painter.drawPolygon(drawn) : painter.drawPolyline(drawn);
        }
        painter.setPen(pen);
        ring.closed ? painter.drawPolygon(drawn) : painter.drawPolyline(drawn);
    }
    if (m_selected < 0 || m_selected >= static_cast<int>(m_rings.size()))
        return;
    const Ring& chosen = m_rings[static_cast<std::size_t>(m_selected)];
    QPainterPath path;
    path.setFillRule(Qt::OddEvenFill);
    path.addPolygon(map.map(chosen.points));
    if (chosen.closed)
        path.closeSubpath();
    for (const Ring& ring : m_rings)
        if (isOfSelected(ring)) {
            path.addPolygon(map.map(ring.points));
            path.closeSubpath();
        }
    QColor fill = accent;
    fill.setAlphaF(0.28f);
    if (chosen.closed)
        painter.fillPath(path, fill);
    painter.strokePath(path, QPen(accent, 2.6));
}

void OutlinePicker::paintRuler(QPainter& painter, const QTransform& map) const {
    const QLineF line = map.map(*m_ruler_px);
    const QColor ink(0x10, 0x10, 0x10), rim(0xff, 0xff, 0xff);
    QPointF across(0.0, 1.0);
    if (line.length() > 0.0)
        across = QPointF(-line.dy(), line.dx()) / line.length();
    for (const auto& [colour, width] : {std::pair(rim, 5.0), std::pair(ink, 2.0)}) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(line);
        for (const QPointF& end : {line.p1(), line.p2()}) {
            painter.drawLine(end - kHandle_px * across, end + kHandle_px * across);
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(end, kHandle_px, kHandle_px);
        }
    }
    const QString text =
        tr("%1 px").arg(QLocale().toString(m_ruler_px->length(), 'f', m_ruler_px->length() < 100.0 ? 1 : 0));
    QRectF box = painter.fontMetrics().boundingRect(text).adjusted(-5, -2, 5, 2);
    box.moveCenter(line.center() - QPointF(0.0, 16.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(rim);
    painter.drawRoundedRect(box, 3.0, 3.0);
    painter.setPen(ink);
    painter.drawText(box, Qt::AlignCenter, text);
}

void OutlinePicker::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().color(QPalette::Base));
    if (m_picture.isNull() && m_rings.empty())
        return;
    const QTransform view = map();
    if (!m_picture.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform, view.m11() < 2.0);
        painter.drawImage(view.mapRect(content()), m_picture);
    }
    paintRings(painter, view);
    if (m_rulerShown && m_ruler_px)
        paintRuler(painter, view);
    if (m_picture.isNull()) {
        painter.setPen(QPen(palette().color(QPalette::Text), 1.4));
        paintScaleBar(painter, QRectF(rect()).adjusted(kMargin_px, kMargin_px, -kMargin_px, -8.0),
                      view.m11());
    }
}

void OutlinePicker::retranslate() {
    setAccessibleName(tr("Outlines of the file"));
    setToolTip(tr("Click an outline to choose it. The wheel zooms, a double click shows all."));
}

void OutlinePicker::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

} // namespace bask
