#include "widgets/plots/figure_png.h"

#include "widgets/common/theme.h"

#include <QBuffer>
#include <QImage>

#include <algorithm>
#include <array>
#include <cmath>

#include <qcustomplot.h>

namespace bask {
namespace {

constexpr double kScale = 2.0; // pixels a unit of the layout

QFont fontOf(int size, bool bold = false) {
    QFont font;
    font.setPixelSize(size);
    font.setBold(bold);
    return font;
}

/// Colour, dashes and marker: any one of them is enough to tell the series apart.
QPen penOf(int index) {
    return seriesPen(index, false, 1.6);
}
QCPScatterStyle markerOf(int index) {
    static constexpr std::array kShapes{QCPScatterStyle::ssDisc,        QCPScatterStyle::ssSquare,
                                        QCPScatterStyle::ssTriangle,    QCPScatterStyle::ssDiamond,
                                        QCPScatterStyle::ssCircle,      QCPScatterStyle::ssTriangleInverted,
                                        QCPScatterStyle::ssCrossSquare, QCPScatterStyle::ssPlus};
    const QColor color = seriesColor(index, false);
    const bool isFilled = index % static_cast<int>(kShapes.size()) != 4;
    return {kShapes[static_cast<std::size_t>(index) % kShapes.size()], QPen(color, 1.3),
            isFilled ? QBrush(color) : QBrush(Qt::white), 6.5};
}

/// Labels are powers of ten, or plain numbers with another base.
void makeLogarithmic(QCPAxis* axis, int base) {
    axis->setScaleType(QCPAxis::stLogarithmic);
    const auto ticker = QSharedPointer<QCPAxisTickerLog>::create();
    ticker->setLogBase(base);
    axis->setTicker(ticker);
    if (base == 10) {
        axis->setNumberFormat(QStringLiteral("eb"));
        axis->setNumberPrecision(0);
    }
}

void style(QCPAxis* axis, const QString& label) {
    const QColor ink = themePalette(false).color(QPalette::Text);
    axis->setLabel(label);
    axis->setLabelFont(fontOf(15));
    axis->setTickLabelFont(fontOf(14));
    axis->setLabelColor(ink);
    axis->setTickLabelColor(ink);
    axis->setLabelPadding(6);
    const QPen pen(secondaryText(false), 1);
    axis->setBasePen(pen);
    axis->setTickPen(pen);
    axis->setSubTickPen(pen);
    axis->grid()->setPen(QPen(hairline(false), 1));
    axis->grid()->setZeroLinePen(Qt::NoPen);
}

void addHead(QCustomPlot& plot, const Figure& figure) {
    const auto line = [&](int row, const QString& text, const QFont& font, const QColor& color, int below) {
        auto* element = new QCPTextElement(&plot, text, font);
        element->setTextColor(color);
        element->setTextFlags(Qt::AlignLeft | Qt::TextWordWrap);
        element->setMargins({12, row == 0 ? 10 : 0, 12, below});
        plot.plotLayout()->insertRow(row);
        plot.plotLayout()->addElement(row, 0, element);
    };
    line(0, figure.title, fontOf(19, true), themePalette(false).color(QPalette::Text), 2);
    line(1, figure.note, fontOf(13), secondaryText(false), 8);
}

/// Below the axes, in rows of three.
void addLegend(QCustomPlot& plot) {
    auto* legend = plot.legend;
    legend->setVisible(true);
    legend->setFont(fontOf(14));
    legend->setBorderPen(Qt::NoPen);
    legend->setIconSize(38, 16);
    legend->setWrap(3);
    legend->setFillOrder(QCPLayoutGrid::foColumnsFirst);
    legend->setColumnSpacing(24);
    auto* below = new QCPLayoutGrid;
    below->setMargins({12, 0, 12, 8});
    const int row = plot.plotLayout()->rowCount();
    plot.plotLayout()->addElement(row, 0, below);
    below->addElement(0, 0, legend);
    plot.plotLayout()->setRowStretchFactor(row, 0.001);
}

void addSeries(QCustomPlot& plot, const Figure& figure) {
    for (int i = 0; i < figure.series.size(); ++i) {
        const FigureSeries& series = figure.series[i];
        QCPGraph* graph = plot.addGraph();
        graph->setName(series.name);
        graph->setPen(penOf(i));
        graph->setScatterStyle(series.hasMarkers ? markerOf(i) : QCPScatterStyle::ssNone);
        graph->setLineStyle(series.isJoined ? QCPGraph::lsLine : QCPGraph::lsNone);
        for (const QPointF& point : series.points)
            graph->addData(point.x(), std::max(point.y(), figure.smallest));
    }
}

/// Whole decades that hold all points; a linear axis gets a margin.
void setRanges(QCustomPlot& plot, const Figure& figure) {
    double low = 1e300, high = 0.0, left = 1e300, right = 0.0;
    for (const FigureSeries& series : figure.series)
        for (const QPointF& point : series.points) {
            left = std::min(left, point.x());
            right = std::max(right, point.x());
            low = std::min(low, std::max(point.y(), figure.smallest));
            high = std::max(high, point.y());
        }
    plot.yAxis->setRange(0.7 * std::pow(10.0, std::floor(std::log10(low))),
                         std::pow(10.0, std::ceil(std::log10(std::max(high, figure.smallest)))));
    if (figure.isXLogarithmic)
        plot.xAxis->setRange(left / 1.4, right * 1.4);
    else
        plot.xAxis->setRange(left - 0.03 * (right - left), right + 0.03 * (right - left));
}

} // namespace

QByteArray figurePng(const Figure& figure, const QString& comment) {
    QCustomPlot plot;
    plot.setBackground(Qt::white);
    style(plot.xAxis, figure.xLabel);
    style(plot.yAxis, figure.yLabel);
    makeLogarithmic(plot.yAxis, 10);
    if (figure.isXLogarithmic)
        makeLogarithmic(plot.xAxis, figure.xBase);
    plot.axisRect()->setMinimumMargins({12, 4, 20, 0});
    addSeries(plot, figure);
    setRanges(plot, figure);
    addLegend(plot);
    addHead(plot, figure);
    QImage image = plot.toPixmap(static_cast<int>(kFigureWidth_px / kScale),
                                 static_cast<int>(kFigureHeight_px / kScale), kScale)
                       .toImage();
    image.setDevicePixelRatio(1.0);
    image.setText(QStringLiteral("Description"), comment);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return bytes;
}

} // namespace bask
