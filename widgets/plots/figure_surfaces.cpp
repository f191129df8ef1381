#include "widgets/plots/figure_surfaces.h"

#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"

#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bask {
namespace {

constexpr double kAzimuth = -60.0 * std::numbers::pi / 180.0, kElevation = 24.0 * std::numbers::pi / 180.0;
constexpr int kFiner =
    2; // surfaces are drawn on so many times finer pixels: their edges must not be smoothed
constexpr float kOpacity = 0.7F;
constexpr int kHead = 96, kMargin = 24; // pixels

/// Parallel projection: to the right, up, and towards the eye, which is at greater x and lesser y.
Eigen::Vector3d turned(const Eigen::Vector3d& p) {
    static const double ca = std::cos(kAzimuth), sa = std::sin(kAzimuth);
    static const double ce = std::cos(kElevation), se = std::sin(kElevation);
    return {-sa * p.x() + ca * p.y(), -ca * se * p.x() - sa * se * p.y() + ce * p.z(),
            ca * ce * p.x() + sa * ce * p.y() + se * p.z()};
}

/// From a panel's axes to pixels of its rectangle.
class Projection {
public:
    Projection(const SurfacePanel& panel, const QRectF& place) : m_place(place) {
        m_middle = 0.5 * (panel.lower + panel.upper);
        m_scale = 1.0 / (panel.upper - panel.lower).maxCoeff();
        // The box fills the rectangle but for what the numbers and labels need.
        double right = 0.0, up = 0.0;
        for (int corner = 0; corner < 8; ++corner) {
            Eigen::Vector3d p;
            for (int k = 0; k < 3; ++k)
                p[k] = (corner >> k & 1) != 0 ? panel.upper[k] : panel.lower[k];
            const Eigen::Vector3d seen = turned((p - m_middle) * m_scale);
            right = std::max(right, std::abs(seen.x()));
            up = std::max(up, std::abs(seen.y()));
        }
        m_zoom = std::min(place.width() / (2.0 * right), place.height() / (2.0 * up));
    }

    Eigen::Vector3d seen(const Eigen::Vector3d& p) const { return turned((p - m_middle) * m_scale); }
    QPointF operator()(const Eigen::Vector3d& p) const { return pixel(seen(p)); }
    QPointF pixel(const Eigen::Vector3d& seen) const {
        return m_place.center() + QPointF(seen.x() * m_zoom, -seen.y() * m_zoom);
    }
    /// How a normal of the panel's axes looks.
    Eigen::Vector3d normal(const Eigen::Vector3d& n) const { return turned(n).normalized(); }

private:
    QRectF m_place;
    Eigen::Vector3d m_middle;
    double m_scale = 1.0, m_zoom = 1.0;
};

/// One triangle or piece of a line, to be drawn from far to near.
struct Piece {
    double depth = 0.0;
    std::array<QPointF, 3> corners;
    QColor color;
    bool isLine = false;
};

QColor shaded(const QColor& color, const Eigen::Vector3d& normal) {
    static const Eigen::Vector3d light = Eigen::Vector3d(-0.35, 0.75, 0.55).normalized();
    const double part = 0.55 + 0.45 * std::abs(normal.dot(light));
    return QColor::fromRgbF(static_cast<float>(color.redF() * part),
                            static_cast<float>(color.greenF() * part),
                            static_cast<float>(color.blueF() * part), kOpacity);
}

/// But for the quarter of the box that is nearest to the eye, so that what is inside can be seen.
void addSurface(std::vector<Piece>& pieces, const FigureSurface& surface, const Projection& project,
                const Eigen::Vector3d& cut) {
    std::vector<Eigen::Vector3d> seen;
    for (const Eigen::Vector3d& point : surface.points)
        seen.push_back(project.seen(point));
    for (const auto& triangle : surface.triangles) {
        Eigen::Vector3d centre = Eigen::Vector3d::Zero();
        for (const int corner : triangle)
            centre += surface.points[static_cast<std::size_t>(corner)] / 3.0;
        if (centre.x() > cut.x() && centre.y() < cut.y())
            continue;
        Piece piece;
        Eigen::Vector3d normal = Eigen::Vector3d::Zero();
        for (std::size_t k = 0; k < 3; ++k) {
            const auto corner = static_cast<std::size_t>(triangle[k]);
            piece.corners[k] = project.pixel(seen[corner]);
            piece.depth += seen[corner].z() / 3.0;
            normal += surface.normals[corner];
        }
        piece.color = shaded(surface.color, project.normal(normal));
        pieces.push_back(piece);
    }
}

QColor blueToRed(double part) {
    return QColor::fromRgbF(static_cast<float>(0.1 + 0.75 * part), 0.15F,
                            static_cast<float>(0.85 - 0.7 * part));
}

void addLine(std::vector<Piece>& pieces, const FigureLine& line, const Projection& project) {
    for (std::size_t k = 0; k + 1 < line.points.size(); ++k) {
        const Eigen::Vector3d a = project.seen(line.points[k]), b = project.seen(line.points[k + 1]);
        const double part = static_cast<double>(k) / static_cast<double>(line.points.size());
        pieces.push_back({0.5 * (a.z() + b.z()),
                          {project.pixel(a), project.pixel(b), {}},
                          line.color.isValid() ? line.color : blueToRed(part),
                          true});
    }
}

void paintPieces(QPainter& painter, const SurfacePanel& panel, const Projection& project, double lineWidth) {
    std::vector<Piece> pieces;
    for (const FigureSurface& surface : panel.surfaces)
        addSurface(pieces, surface, project, 0.5 * (panel.lower + panel.upper));
    for (const FigureLine& line : panel.lines)
        addLine(pieces, line, project);
    std::ranges::stable_sort(pieces, {}, &Piece::depth);
    for (const Piece& piece : pieces) {
        if (piece.isLine) {
            painter.setPen(QPen(piece.color, lineWidth, Qt::SolidLine, Qt::RoundCap));
            painter.drawLine(piece.corners[0], piece.corners[1]);
        } else {
            painter.setPen(Qt::NoPen);
            painter.setBrush(piece.color);
            painter.drawConvexPolygon(piece.corners.data(), 3);
        }
    }
}

using Axes = Eigen::Vector3d;

Axes corner(const SurfacePanel& panel, bool x, bool y, bool z) {
    return {x ? panel.upper.x() : panel.lower.x(), y ? panel.upper.y() : panel.lower.y(),
            z ? panel.upper.z() : panel.lower.z()};
}

/// Floor and the two walls behind.
void paintWalls(QPainter& painter, const SurfacePanel& panel, const Projection& project) {
    const auto at = [&](bool x, bool y, bool z) { return project(corner(panel, x, y, z)); };
    painter.setPen(QPen(hairline(false), 2));
    painter.setBrush(QColor(0xfa, 0xfa, 0xfb));
    painter.drawPolygon(QPolygonF{{at(0, 0, 0), at(1, 0, 0), at(1, 1, 0), at(0, 1, 0)}});
    painter.drawPolygon(QPolygonF{{at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)}});
    painter.drawPolygon(QPolygonF{{at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)}});
}

void paintWords(QPainter& painter, const QPointF& middle, const QString& words) {
    const QSizeF size = QFontMetricsF(painter.font()).size(0, words);
    painter.drawText(QRectF(middle - QPointF(size.width() / 2, size.height() / 2), size), Qt::AlignCenter,
                     words);
}

/// Numbers and label along the edge that starts at `from`, `outwards` of it on the picture.
void paintAxis(QPainter& painter, const SurfacePanel& panel, const Projection& project, int axis,
               const Axes& from, const QPointF& outwards) {
    const auto number = [&](double value) { return std::abs(value) < 1e-9 * panel.tick ? 0.0 : value; };
    painter.setPen(QPen(secondaryText(false), 2));
    Axes to = from;
    to[axis] = panel.upper[axis];
    painter.drawLine(project(from), project(to));
    painter.setFont(figureFont(26));
    const double first = std::ceil(panel.lower[axis] / panel.tick - 1e-6) * panel.tick;
    for (double value = first; value <= panel.upper[axis] + 1e-6 * panel.tick; value += panel.tick) {
        Axes place = from;
        place[axis] = value;
        painter.setPen(QPen(secondaryText(false), 2));
        painter.drawLine(project(place), project(place) + 10.0 * outwards);
        painter.setPen(themePalette(false).color(QPalette::Text));
        paintWords(painter, project(place) + 34.0 * outwards, QLocale().toString(number(value)));
    }
    painter.setFont(figureFont(28));
    paintWords(painter, project(0.5 * (from + to)) + (axis == 2 ? 112.0 : 92.0) * outwards,
               panel.axes[static_cast<std::size_t>(axis)]);
}

void paintAxes(QPainter& painter, const SurfacePanel& panel, const Projection& project) {
    paintAxis(painter, panel, project, 0, corner(panel, false, false, false), {-0.7, 0.72});
    paintAxis(painter, panel, project, 1, corner(panel, true, false, false), {0.85, 0.52});
    paintAxis(painter, panel, project, 2, corner(panel, false, false, false), {-1.0, 0.0});
}

/// Swatches in one row below the box.
void paintLegend(QPainter& painter, const SurfacePanel& panel, const QRectF& place) {
    QList<const FigureSurface*> entries;
    for (const FigureSurface& surface : panel.surfaces)
        if (std::ranges::none_of(entries, [&](const FigureSurface* e) { return e->name == surface.name; }))
            entries << &surface;
    painter.setFont(figureFont(26));
    const QFontMetricsF metrics(painter.font());
    double width = 0.0;
    for (const FigureSurface* entry : entries)
        width += 60.0 + metrics.horizontalAdvance(entry->name);
    double x = place.center().x() - 0.5 * width;
    for (const FigureSurface* entry : entries) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(entry->color);
        painter.drawRect(QRectF(x, place.center().y() - 11, 22, 22));
        painter.setPen(themePalette(false).color(QPalette::Text));
        const double advance = metrics.horizontalAdvance(entry->name);
        painter.drawText(QRectF(x + 30, place.top(), advance + 2, place.height()), Qt::AlignVCenter,
                         entry->name);
        x += 60.0 + advance;
    }
}

void paintPanel(QImage& image, const SurfacePanel& panel, const QRectF& place) {
    const QRectF box = place.adjusted(185, 60, -70, -150);
    const Projection project(panel, box);
    {
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setFont(figureFont(30, true));
        painter.setPen(themePalette(false).color(QPalette::Text));
        painter.drawText(QRectF(place.left(), place.top(), place.width(), 50), Qt::AlignCenter, panel.title);
        paintWalls(painter, panel, project);
        paintAxes(painter, panel, project);
        paintLegend(painter, panel, QRectF(place.left(), place.bottom() - 50, place.width(), 40));
    }
    // Translucent triangles that share an edge leave a seam when their edges are smoothed.
    QImage finer(place.size().toSize() * kFiner, QImage::Format_ARGB32_Premultiplied);
    finer.fill(Qt::transparent);
    {
        QPainter painter(&finer);
        painter.scale(kFiner, kFiner);
        painter.translate(-place.topLeft());
        paintPieces(painter, panel, project, 3.5);
    }
    QPainter painter(&image);
    painter.drawImage(place.topLeft(),
                      finer.scaled(place.size().toSize(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation));
}

} // namespace

QByteArray surfacesPng(const SurfacesFigure& figure, const QString& comment) {
    const int rows = (static_cast<int>(figure.panels.size()) + figure.columns - 1) / figure.columns;
    QImage image(figure.columns * figure.panelWidth_px, kHead + rows * figure.panelHeight_px,
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    {
        QPainter painter(&image);
        painter.setFont(figureFont(38, true));
        painter.setPen(themePalette(false).color(QPalette::Text));
        painter.drawText(QRectF(kMargin, 8, image.width() - 2 * kMargin, 48), Qt::AlignVCenter, figure.title);
        painter.setFont(figureFont(26));
        painter.setPen(secondaryText(false));
        painter.drawText(QRectF(kMargin, 56, image.width() - 2 * kMargin, 38), Qt::AlignVCenter, figure.note);
    }
    for (int k = 0; k < figure.panels.size(); ++k)
        paintPanel(image, figure.panels[k],
                   QRectF(k % figure.columns * figure.panelWidth_px,
                          kHead + k / figure.columns * figure.panelHeight_px, figure.panelWidth_px,
                          figure.panelHeight_px));
    return pngOf(image, comment);
}

} // namespace bask
