#include "widgets/scene/scene_overlay.h"

#include "engine/base/units.h"
#include "widgets/common/theme.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bask {

namespace {

constexpr double kPadding = 12.0; ///< between the view's edge and anything
constexpr double kTick = 5.0;
constexpr double kBarWidth = 12.0;
constexpr double kMinAxis = 40.0;       ///< a shorter axis is seen end on and left out
constexpr double kMinForValues = 480.0; ///< in a narrower view labels are names only
constexpr double kAnyCost = std::numeric_limits<double>::infinity();
constexpr QSizeF kMinForBar{320.0, 200.0};
constexpr QSizeF kMinForText{120.0, 90.0};

double lengthOf(QPointF p) {
    return std::hypot(p.x(), p.y());
}

/// Digits after the point that tell neighbouring ticks apart.
int decimalsFor(double step) {
    int decimals = 0;
    while (decimals < 3 &&
           std::abs(step * std::pow(10.0, decimals) - std::round(step * std::pow(10.0, decimals))) > 1e-6)
        ++decimals;
    return decimals;
}

QString numberText(double value, int decimals) {
    if (std::abs(value) < 1e-9)
        value = 0.0;
    QString text = QLocale().toString(value, 'f', decimals);
    return text.replace(QLocale().negativeSign(), QStringLiteral("\u2212"));
}

/// An axis laid along the edge of a box that bounds it on screen.
struct AxisLine {
    QPointF from;
    QPointF to;
    QPointF outward; ///< unit, away from the box
};

/// Of the four parallel edges, the outermost one below (or, for an upright axis, on the left).
AxisLine outerEdge(const Box& box, const Projection& projection, int axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const auto corner = [&](double a, int i, int j) {
        Eigen::Vector3d p;
        p[axis] = a;
        p[u] = i == 0 ? box.min()[u] : box.max()[u];
        p[v] = j == 0 ? box.min()[v] : box.max()[v];
        return projection(p);
    };
    const QPointF middle = projection(box.center());
    AxisLine best;
    double score = -1.0;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            const AxisLine line{corner(box.min()[axis], i, j), corner(box.max()[axis], i, j), {}};
            const QPointF along = line.to - line.from;
            const double length = lengthOf(along);
            if (length < 1e-6)
                continue;
            QPointF across(-along.y() / length, along.x() / length);
            const bool upright = std::abs(along.y()) > 1.5 * std::abs(along.x());
            // Point down, or to the left when upright.
            if (upright ? across.x() > 0.0 : across.y() < 0.0)
                across = -across;
            const double offset = QPointF::dotProduct(0.5 * (line.from + line.to) - middle, across);
            if (offset > score) {
                score = offset;
                best = {line.from, line.to, across};
            }
        }
    return best;
}

/// Rectangle of a text beside a point, its nearest side at `distance` in direction `d`.
QRectF beside(QPointF point, QPointF d, double distance, QSizeF size) {
    const double reach = 0.5 * (std::abs(d.x()) * size.width() + std::abs(d.y()) * size.height());
    const QPointF centre = point + d * (distance + reach);
    return {centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size};
}

QFont smaller(QFont font) {
    if (font.pointSizeF() > 0.0)
        font.setPointSizeF(0.9 * font.pointSizeF());
    return font;
}

QRectF boundsOf(const SceneLabel& label, const Projection& projection) {
    QPolygonF polygon;
    for (const Eigen::Vector3d& p : label.outline_R)
        polygon << projection(p);
    return polygon.boundingRect();
}

} // namespace

struct SceneOverlay::Frame {
    QPainter& painter;
    QSizeF size;
    const Projection& projection;
    const OverlayContent& content;
    bool dark;
    QColor text;
    QColor quiet;
    QColor line;
    QColor ground;
    QFontMetricsF metrics;
};

QMarginsF SceneOverlay::margins(const QFont& font, QSizeF size) {
    const QFontMetricsF metrics(smaller(font));
    const double label = metrics.horizontalAdvance(QStringLiteral("\u221200"));
    const double line = metrics.height();
    const bool bar = size.width() >= kMinForBar.width() && size.height() >= kMinForBar.height();
    const double right = bar ? 2.0 * kPadding + kBarWidth + 2.0 * label + 16.0 : kPadding + label;
    return {kPadding + kTick + 4.0 + label, kPadding + line + 6.0, right,
            kPadding + kTick + 4.0 + 2.0 * line};
}

void SceneOverlay::paint(QPainter& painter, QSizeF size, const QPalette& palette,
                         const Projection& projection, const OverlayContent& content) {
    if (size.width() < kMinForText.width() || size.height() < kMinForText.height() || content.frame.isEmpty())
        return;
    const bool dark = isDark(palette);
    const QFont small = smaller(painter.font());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(small);
    Frame frame{painter,
                size,
                projection,
                content,
                dark,
                palette.color(QPalette::Text),
                secondaryText(dark),
                secondaryText(dark),
                palette.color(QPalette::Base),
                QFontMetricsF(small)};
    m_layout.begin(QRectF(QPointF(0.0, 0.0), size).adjusted(6.0, 6.0, -6.0, -6.0));
    if (content.hasBar && size.width() >= kMinForBar.width() && size.height() >= kMinForBar.height())
        paintBar(frame);
    paintAxes(frame);
    paintLabels(frame);
}

void SceneOverlay::paintAxes(Frame& frame) {
    for (int axis = 0; axis < 3; ++axis)
        paintAxis(frame, axis);
}

void SceneOverlay::paintAxis(Frame& frame, int axis) {
    const AxisLine line = outerEdge(frame.content.frame, frame.projection, axis);
    const double length = lengthOf(line.to - line.from);
    if (length < kMinAxis)
        return;
    QPainter& painter = frame.painter;
    painter.setPen(QPen(frame.line, 1.0));
    painter.drawLine(line.from, line.to);
    const double unit = frame.content.axes == PoseSubset::Rotation ? degFromRad(1.0) : 100.0; // degrees or cm
    const double from = frame.content.frame.min()[axis] * unit;
    const double to = frame.content.frame.max()[axis] * unit;
    const NiceRange range = niceRange(from, to, std::max(1, static_cast<int>(length / 44.0)));
    const int decimals = decimalsFor(range.step);
    double widest = 0.0;
    for (double k = std::ceil(from / range.step - 1e-6); k * range.step <= to + 1e-6; k += 1.0) {
        const double value = k * range.step;
        const QPointF at = line.from + (line.to - line.from) * ((value - from) / (to - from));
        painter.setPen(QPen(frame.line, 1.0));
        painter.drawLine(at, at + line.outward * kTick);
        const QString text = numberText(value, decimals);
        const QSizeF size(frame.metrics.horizontalAdvance(text), frame.metrics.ascent());
        const QRectF place = beside(at, line.outward, kTick + 4.0, size);
        widest = std::max(widest, std::abs(line.outward.x()) * size.width() +
                                      std::abs(line.outward.y()) * size.height());
        if (!m_layout.isFree(place))
            continue;
        painter.setPen(frame.quiet);
        painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, text);
        m_layout.take(place.adjusted(-3.0, -1.0, 3.0, 1.0));
    }
    constexpr int kPieces = 16; // a slanting line's bounds would be a large rectangle
    for (int i = 0; i < kPieces; ++i)
        m_layout.take(QRectF(line.from + (line.to - line.from) * i / kPieces,
                             line.from + (line.to - line.from) * (i + 1) / kPieces)
                          .normalized()
                          .adjusted(-1.0, -1.0, 1.0, 1.0));

    static constexpr std::array<const char*, 9> kTitles{
        QT_TR_NOOP("x (cm)"),          QT_TR_NOOP("y (cm)"),          QT_TR_NOOP("z (cm)"),
        QT_TR_NOOP("object's x (cm)"), QT_TR_NOOP("object's y (cm)"), QT_TR_NOOP("object's z (cm)"),
        QT_TR_NOOP("θx (°)"),          QT_TR_NOOP("θy (°)"),          QT_TR_NOOP("θz (°)")};
    const QString title =
        tr(kTitles[static_cast<std::size_t>(axis + 3 * static_cast<int>(frame.content.axes))]);
    const QSizeF size(frame.metrics.horizontalAdvance(title), frame.metrics.ascent());
    QRectF place = beside(0.5 * (line.from + line.to), line.outward, kTick + 4.0 + widest + 6.0, size);
    // Beside an upright axis there is little room: its title stands at its upper end.
    if (std::abs(line.outward.x()) > std::abs(line.outward.y()) + 0.2 || !m_layout.isFree(place)) {
        const bool up = line.from.y() < line.to.y();
        place = beside(up ? line.from : line.to, QPointF(0.0, -1.0), 8.0, size);
        place.moveLeft(std::max(place.left(), 6.0));
    }
    painter.setPen(frame.text);
    painter.drawText(place, Qt::AlignCenter | Qt::TextDontClip, title);
    m_layout.take(place.adjusted(-3.0, -1.0, 3.0, 1.0));
}

void SceneOverlay::paintBar(Frame& frame) {
    QPainter& painter = frame.painter;
    const NiceRange& range = frame.content.bar;
    const double height = std::clamp(0.42 * frame.size.height(), 90.0, 240.0);
    const int decimals = decimalsFor(range.step);
    double widest = 0.0;
    for (const double value : {range.min, range.max})
        widest = std::max(widest, frame.metrics.horizontalAdvance(numberText(value, decimals)));
    const QString title =
        frame.metrics.elidedText(frame.content.barTitle, Qt::ElideMiddle, 0.4 * frame.size.width());
    const double block = kBarWidth + kTick + 4.0 + widest;
    const double titleWidth = std::max(block, frame.metrics.horizontalAdvance(title));
    const double top = kPadding + frame.metrics.height() + 6.0;
    const QRectF bar(frame.size.width() - kPadding - block, top, kBarWidth, height);

    painter.setPen(frame.text);
    const QRectF titlePlace(frame.size.width() - kPadding - titleWidth, kPadding, titleWidth,
                            frame.metrics.height());
    painter.drawText(titlePlace, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, title);
    QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
    for (int i = 0; i <= 16; ++i)
        gradient.setColorAt(i / 16.0, mapColour(i / 16.0, frame.dark));
    painter.fillRect(bar, gradient);

    const double span = range.max - range.min;
    const int steps = static_cast<int>(std::lround(span / range.step));
    const int every = std::max(1, static_cast<int>(std::ceil(steps * 1.6 * frame.metrics.height() / height)));
    for (int i = 0; i <= steps; i += every) {
        const double y = bar.bottom() - height * i / std::max(1, steps);
        painter.setPen(QPen(frame.line, 1.0));
        painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + kTick - 1.0, y));
        painter.setPen(frame.quiet);
        painter.drawText(QRectF(bar.right() + kTick + 3.0, y - 0.5 * frame.metrics.height(), widest,
                                frame.metrics.height()),
                         Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip,
                         numberText(range.min + i * range.step, decimals));
    }
    m_layout.take(
        QRectF(bar.left() - 6.0, 0.0, block + 6.0 + kPadding, bar.bottom() + frame.metrics.height()));
    m_layout.take(titlePlace.adjusted(-6.0, -kPadding, kPadding, 0.0));
}

void SceneOverlay::paintLabels(Frame& frame) {
    std::vector<QRectF> anchors;
    for (const SceneLabel& label : frame.content.labels) {
        anchors.push_back(boundsOf(label, frame.projection));
        // An object is never to be hidden by a name; the source is large enough to carry some.
        m_layout.take(anchors.back().adjusted(-4.0, -4.0, 4.0, 4.0), label.optional ? 0.05 : 2.0);
    }
    for (const std::vector<Eigen::Vector3d>& path_R : frame.content.paths_R) {
        QPolygonF line;
        for (const Eigen::Vector3d& p : path_R)
            line << frame.projection(p);
        m_layout.takeLine(line);
    }
    QFont bold = frame.painter.font();
    bold.setBold(true);
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        SceneLabel label = frame.content.labels[i];
        if (frame.size.width() < kMinForValues)
            label.value.clear();
        double width =
            QFontMetricsF(bold).horizontalAdvance(label.text) + (label.colour.isValid() ? 14.0 : 0.0) + 14.0;
        if (!label.value.isEmpty())
            width += frame.metrics.horizontalAdvance(label.value) + 8.0;
        const QSizeF size(std::ceil(width), std::ceil(frame.metrics.height() + 6.0));
        const QRectF place = m_layout.place(i, anchors[i], size, label.optional ? 0.5 : kAnyCost);
        if (!place.isEmpty())
            paintLabel(frame, label, anchors[i], place);
    }
}

void SceneOverlay::paintLabel(Frame& frame, const SceneLabel& label, const QRectF& anchor,
                              const QRectF& place) {
    QPainter& painter = frame.painter;
    const QPointF nearest(std::clamp(anchor.center().x(), place.left(), place.right()),
                          std::clamp(anchor.center().y(), place.top(), place.bottom()));
    const QPointF rim(std::clamp(nearest.x(), anchor.left(), anchor.right()),
                      std::clamp(nearest.y(), anchor.top(), anchor.bottom()));
    if (lengthOf(rim - nearest) > 12.0) {
        painter.setPen(QPen(frame.line, 1.0));
        painter.drawLine(nearest, rim);
    }
    QColor ground = frame.ground;
    ground.setAlphaF(m_layout.crossesLine(place) ? 0.45F : 0.86F); // there was no better place
    painter.setPen(Qt::NoPen);
    painter.setBrush(ground);
    painter.drawRoundedRect(place, 4.0, 4.0);
    double left = place.left() + 7.0;
    if (label.colour.isValid()) {
        painter.setBrush(label.colour);
        painter.drawRoundedRect(QRectF(left, place.center().y() - 4.0, 8.0, 8.0), 2.0, 2.0);
        left += 14.0;
    }
    painter.setBrush(Qt::NoBrush);
    const QFont plain = painter.font();
    QFont bold = plain;
    bold.setBold(true);
    const double textWidth = QFontMetricsF(bold).horizontalAdvance(label.text);
    const int flags = Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip;
    painter.setFont(bold);
    painter.setPen(frame.text);
    painter.drawText(QRectF(left, place.top(), textWidth + 1.0, place.height()), flags, label.text);
    painter.setFont(plain);
    painter.drawText(QRectF(left + textWidth + 8.0, place.top(), 10.0, place.height()), flags, label.value);
}

} // namespace bask
