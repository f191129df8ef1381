#include "widgets/plots/figure_paths.h"

#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kColours = 48; // steps of the gradient: a path is one curve a step

constexpr int kMarkersOfPath = 6;

constexpr double kNameGap = 7.0; // px, from a start to its name
constexpr int kNamePadding = 3;

/// Where a point stands in a view.
struct View {
    QPointF (*of)(const PathPoint&);
    QCPAxisRect* rect;
};

/// Blue to red, ever lighter: a black-and-white print keeps the order.
QCPColorGradient coolToWarm() {
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    gradient.setColorStopAt(0.0, QColor(0x12, 0x24, 0xa8));
    gradient.setColorStopAt(0.5, QColor(0x96, 0x3c, 0x92));
    gradient.setColorStopAt(1.0, QColor(0xee, 0x4b, 0x3a));
    return gradient;
}

double distance(const QPointF& a, const QPointF& b) {
    return std::hypot(b.x() - a.x(), b.y() - a.y());
}

class Drawing {
public:
    Drawing(QCustomPlot& plot, const PathsFigure& figure) : m_plot(plot), m_figure(figure) {}

    void add(const View& view) {
        QList<QPointF> source;
        for (const QPointF& point : m_figure.source_cm)
            source << view.of({point.x(), point.y(), 0.0, 0.0});
        if (!source.isEmpty())
            source << source.front();
        line(view, source, QPen(themePalette(false).color(QPalette::Text), 2.2));
        for (int i = 0; i < m_figure.paths.size(); ++i) {
            addPath(view, m_figure.paths[i]);
            addMarkers(view, m_figure.paths[i], i);
        }
    }

    /// Which marker is which object's.
    void addMarkerNames(const View& view) {
        for (int i = 0; i < m_figure.paths.size(); ++i) {
            QCPGraph* graph = addPoints(view, figureMarker(i, themePalette(false).color(QPalette::Text)));
            graph->setName(m_figure.paths[i].name);
            graph->addToLegend();
        }
        addLegend(m_plot, 4);
    }

    /// A name that would be over another one stands under its start. When the scales are known.
    void settleNames() {
        QList<std::pair<const QCPAxisRect*, QRectF>> taken;
        for (const Name& name : m_names) {
            const QPointF at(name.rect->axis(QCPAxis::atBottom)->coordToPixel(name.start.x()),
                             name.rect->axis(QCPAxis::atLeft)->coordToPixel(name.start.y()));
            const QSizeF size =
                QFontMetricsF(name.item->font()).size(0, name.item->text()) + QSizeF(2.0 * kNamePadding, 0.0);
            QRectF box(at.x() - 0.5 * size.width(), at.y() - kNameGap - size.height(), size.width(),
                       size.height());
            const auto isFree = [&] {
                return std::ranges::none_of(taken, [&](const auto& other) {
                    return other.first == name.rect && other.second.intersects(box);
                });
            };
            if (!isFree()) {
                name.item->setPositionAlignment(Qt::AlignHCenter | Qt::AlignTop);
                box.moveTop(at.y() + kNameGap);
                while (!isFree())
                    box.translate(0.0, size.height());
                name.item->position->setCoords(0.0, box.top() - at.y());
            }
            taken.emplace_back(name.rect, box);
        }
    }

    QColor colour(double temperature_degC) {
        const QCPRange range(m_figure.coldest_degC, m_figure.hottest_degC);
        const double step = range.size() / kColours;
        const double middle =
            range.lower + (std::floor((temperature_degC - range.lower) / step) + 0.5) * step;
        return QColor::fromRgb(m_gradient.color(std::clamp(middle, range.lower, range.upper), range));
    }

private:
    void line(const View& view, const QList<QPointF>& points, const QPen& pen) {
        auto* curve = new QCPCurve(view.rect->axis(QCPAxis::atBottom), view.rect->axis(QCPAxis::atLeft));
        QVector<QCPCurveData> data;
        for (const QPointF& point : points)
            data << QCPCurveData(static_cast<double>(data.size()), point.x(), point.y());
        curve->data()->set(data, true);
        curve->setPen(pen);
    }

    /// One curve as long as the colour stays, so that the ends meet.
    void addPath(const View& view, const FigurePath& path) {
        QList<QPointF> piece;
        for (qsizetype k = 0; k < path.points.size(); ++k) {
            const QColor now = colour(path.points[k].temperature_degC);
            piece << view.of(path.points[k]);
            const bool isLast = k + 1 == path.points.size();
            if (isLast || colour(path.points[k + 1].temperature_degC) != now) {
                if (!isLast)
                    piece << view.of(path.points[k + 1]);
                QPen pen(now, 1.6);
                pen.setCapStyle(Qt::RoundCap);
                line(view, piece, pen);
                piece.clear();
            }
        }
        if (path.points.isEmpty())
            return;
        const QColor first = colour(path.points.front().temperature_degC);
        mark(view, path.points.front(),
             {QCPScatterStyle::ssCircle, QPen(first, 1.8), QBrush(Qt::white), 7.0});
        const QColor last = colour(path.points.back().temperature_degC);
        mark(view, path.points.back(), {QCPScatterStyle::ssCircle, QPen(Qt::white, 1.5), QBrush(last), 11.0});
        addName(view, path);
    }

    /// A name at the start, where the paths are apart; paths that start at one place share theirs.
    void addName(const View& view, const FigurePath& path) {
        const QPointF start = view.of(path.points.front());
        QStringList names;
        for (const FigurePath& other : m_figure.paths) {
            const QPointF distance =
                other.points.isEmpty() ? QPointF(1e9, 0.0) : view.of(other.points.front()) - start;
            if (distance.manhattanLength() > 0.1)
                continue;
            if (names.isEmpty() && &other != &path)
                return; // said already
            names << other.name;
        }
        auto* place = new QCPItemTracer(&m_plot);
        place->setStyle(QCPItemTracer::tsNone);
        place->position->setAxes(view.rect->axis(QCPAxis::atBottom), view.rect->axis(QCPAxis::atLeft));
        place->position->setAxisRect(view.rect);
        place->position->setType(QCPItemPosition::ptPlotCoords);
        place->position->setCoords(start);
        auto* name = new QCPItemText(&m_plot);
        name->setClipToAxisRect(false);
        name->position->setParentAnchor(place->position);
        name->position->setCoords(0.0, -kNameGap);
        name->setPositionAlignment(Qt::AlignHCenter | Qt::AlignBottom);
        name->setPadding({kNamePadding, 0, kNamePadding, 0});
        name->setBrush(QColor(255, 255, 255, 200));
        name->setText(names.join(QStringLiteral(", ")));
        name->setFont(figureFont(kSmallLetters));
        name->setColor(themePalette(false).color(QPalette::Text));
        m_names.push_back({name, view.rect, start});
    }

    /// A few at equal ways along the path: without colours they tell whose it is.
    void addMarkers(const View& view, const FigurePath& path, int index) {
        if (m_figure.paths.size() < 2)
            return;
        double length = 0.0, way = 0.0;
        for (qsizetype k = 1; k < path.points.size(); ++k)
            length += distance(view.of(path.points[k - 1]), view.of(path.points[k]));
        int count = 1;
        for (qsizetype k = 1; k < path.points.size() && length > 0.0; ++k) {
            way += distance(view.of(path.points[k - 1]), view.of(path.points[k]));
            if (count <= kMarkersOfPath && way >= length * count / (kMarkersOfPath + 1)) {
                mark(view, path.points[k], figureMarker(index, colour(path.points[k].temperature_degC)));
                ++count;
            }
        }
    }

    QCPGraph* addPoints(const View& view, const QCPScatterStyle& style) {
        auto* graph = m_plot.addGraph(view.rect->axis(QCPAxis::atBottom), view.rect->axis(QCPAxis::atLeft));
        graph->setLineStyle(QCPGraph::lsNone);
        graph->setScatterStyle(style);
        return graph;
    }

    void mark(const View& view, const PathPoint& point, const QCPScatterStyle& style) {
        const QPointF place = view.of(point);
        addPoints(view, style)->addData(place.x(), place.y());
    }

    QCustomPlot& m_plot;
    const PathsFigure& m_figure;
    struct Name {
        QCPItemText* item;
        QCPAxisRect* rect;
        QPointF start;
    };
    QList<Name> m_names;
    QCPColorGradient m_gradient = coolToWarm();
};

struct Extents {
    double side = 1.0, top = 1.0; // cm: x and y from -side to side, z up to top
};

Extents extentsOf(const PathsFigure& figure) {
    Extents extents;
    const auto take = [&](double x, double y, double z) {
        extents.side = std::max({extents.side, std::abs(x), std::abs(y)});
        extents.top = std::max(extents.top, z);
    };
    for (const QPointF& point : figure.source_cm)
        take(point.x(), point.y(), 0.0);
    for (const FigurePath& path : figure.paths)
        for (const PathPoint& point : path.points)
            take(point.x_cm, point.y_cm, point.z_cm);
    return {1.15 * extents.side, 1.12 * extents.top};
}

QCPAxisRect* addRect(QCustomPlot& plot, QCPLayoutGrid& views, int column, const QString& title,
                     const QString& xLabel, const QString& yLabel) {
    auto* rect = new QCPAxisRect(&plot);
    rect->setupFullAxesBox(true);
    styleAxis(rect->axis(QCPAxis::atBottom), xLabel);
    styleAxis(rect->axis(QCPAxis::atLeft), yLabel);
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        rect->axis(side)->setTicks(false);
        rect->axis(side)->setBasePen(QPen(secondaryText(false), 1));
    }
    rect->setMinimumMargins({12, 4, 16, 0});
    auto* words = new QCPTextElement(&plot, title, figureFont(kSmallLetters));
    words->setTextColor(secondaryText(false));
    views.addElement(0, column, words);
    views.addElement(1, column, rect);
    return rect;
}

/// Equal centimetres both ways, about the middle of the wanted ranges.
void setEqualScales(QCPAxisRect* rect, const QCPRange& across, const QCPRange& up) {
    const double perPixel =
        std::max(across.size() / std::max(rect->width(), 1), up.size() / std::max(rect->height(), 1));
    const double width = perPixel * rect->width(), height = perPixel * rect->height();
    rect->axis(QCPAxis::atBottom)->setRange(across.center() - 0.5 * width, across.center() + 0.5 * width);
    rect->axis(QCPAxis::atLeft)->setRange(up.center() - 0.5 * height, up.center() + 0.5 * height);
}

void addColours(QCustomPlot& plot, QCPLayoutGrid& views, const PathsFigure& figure) {
    auto* scale = new QCPColorScale(&plot);
    scale->setGradient(coolToWarm());
    scale->setDataRange({figure.coldest_degC, figure.hottest_degC});
    scale->setType(QCPAxis::atRight);
    scale->setBarWidth(14);
    styleAxis(scale->axis(), figure.temperature);
    scale->axis()->grid()->setVisible(false);
    // As high as the views.
    auto* group = new QCPMarginGroup(&plot);
    views.element(1, 0)->setMarginGroup(QCP::msTop | QCP::msBottom, group);
    scale->setMarginGroup(QCP::msTop | QCP::msBottom, group);
    views.addElement(1, 2, scale);
    views.setColumnStretchFactor(2, 0.001);
}

} // namespace

QByteArray pathsPng(const PathsFigure& figure, const QString& comment) {
    return pathsPicture(figure, FigureFormat::Png, comment);
}

QByteArray pathsPicture(const PathsFigure& figure, FigureFormat format, const QString& comment) {
    QCustomPlot plot;
    plot.setBackground(Qt::white);
    plot.setAutoAddPlottableToLegend(false);
    plot.axisRect()->insetLayout()->take(plot.legend); // or it would go with the rectangle
    plot.plotLayout()->clear();
    auto* views = new QCPLayoutGrid;
    plot.plotLayout()->addElement(0, 0, views);
    const View above{
        [](const PathPoint& p) { return QPointF(p.x_cm, p.y_cm); },
        addRect(plot, *views, 0, figure.above, QStringLiteral("x (cm)"), QStringLiteral("y (cm)"))};
    const View aside{
        [](const PathPoint& p) { return QPointF(p.y_cm, p.z_cm); },
        addRect(plot, *views, 1, figure.aside, QStringLiteral("y (cm)"), QStringLiteral("z (cm)"))};
    aside.rect->axis(QCPAxis::atBottom)->setRangeReversed(true);
    views->setRowStretchFactor(0, 0.001);
    Drawing drawing(plot, figure);
    drawing.add(above);
    drawing.add(aside);
    addColours(plot, *views, figure);
    if (figure.paths.size() > 1)
        drawing.addMarkerNames(above);
    const QSize size = figureUnits(figure.size_px);
    if (figure.hasHeading)
        addHead(plot, figure.title, figure.note, size.width());
    else if (!figure.corner.isEmpty())
        addCorner(plot, figure.corner, size.width());
    plot.toPixmap(size.width(), size.height()); // lays out: the scales depend on it
    const Extents extents = extentsOf(figure);
    setEqualScales(above.rect, {-extents.side, extents.side}, {-extents.side, extents.side});
    setEqualScales(aside.rect, {-extents.side, extents.side}, {-0.08 * extents.top, extents.top});
    drawing.settleNames();
    return pictureOf(plot, size, format, comment);
}

} // namespace bask
