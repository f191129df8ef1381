#include "widgets/plots/figure_png.h"

#include "widgets/common/theme.h"
#include "widgets/plots/figure_style.h"

#include <algorithm>
#include <cmath>

#include <qcustomplot.h>

namespace bask {
namespace {

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

void addSeries(QCustomPlot& plot, const Figure& figure) {
    for (int i = 0; i < figure.series.size(); ++i) {
        const FigureSeries& series = figure.series[i];
        QCPGraph* graph = plot.addGraph();
        graph->setName(series.name);
        graph->setPen(seriesPen(i, false, 1.6));
        graph->setScatterStyle(series.hasMarkers ? figureMarker(i, seriesColor(i, false))
                                                 : QCPScatterStyle::ssNone);
        graph->setLineStyle(series.isJoined ? QCPGraph::lsLine : QCPGraph::lsNone);
        for (const QPointF& point : series.points)
            graph->addData(point.x(),
                           figure.isYLogarithmic ? std::max(point.y(), figure.smallest) : point.y());
    }
}

/// From the first to the last of the series' numbers; from 0 to 1 when there are none.
FigureRange extent(const Figure& figure, double (*of)(const QPointF&)) {
    FigureRange range{1e300, -1e300};
    for (const FigureSeries& series : figure.series)
        for (const QPointF& point : series.points)
            range = {std::min(range.min, of(point)), std::max(range.max, of(point))};
    return range.min <= range.max ? range : FigureRange{};
}

QCPRange withMargin(const FigureRange& range, double part) {
    const double margin = part * std::max(range.max - range.min, 1e-9);
    return {range.min - margin, range.max + margin};
}

/// Whole decades that hold all points; a linear axis gets a margin.
void setRanges(QCustomPlot& plot, const Figure& figure) {
    const FigureRange x = extent(figure, [](const QPointF& point) { return point.x(); });
    const FigureRange y = extent(figure, [](const QPointF& point) { return point.y(); });
    if (figure.isYLogarithmic)
        plot.yAxis->setRange(0.7 * std::pow(10.0, std::floor(std::log10(std::max(y.min, figure.smallest)))),
                             std::pow(10.0, std::ceil(std::log10(std::max(y.max, figure.smallest)))));
    else
        plot.yAxis->setRange(withMargin(figure.yRange.value_or(y), 0.05));
    if (figure.isXLogarithmic)
        plot.xAxis->setRange(x.min / 1.4, x.max * 1.4);
    else if (figure.xRange)
        plot.xAxis->setRange(figure.xRange->min, figure.xRange->max);
    else
        plot.xAxis->setRange(withMargin(x, 0.03));
}

} // namespace

QByteArray figurePng(const Figure& figure, const QString& comment) {
    QCustomPlot plot;
    plot.setBackground(Qt::white);
    styleAxis(plot.xAxis, figure.xLabel);
    styleAxis(plot.yAxis, figure.yLabel);
    if (figure.isYLogarithmic)
        makeLogarithmic(plot.yAxis, 10);
    if (figure.isXLogarithmic)
        makeLogarithmic(plot.xAxis, figure.xBase);
    plot.axisRect()->setMinimumMargins({12, 4, 20, 0});
    addSeries(plot, figure);
    setRanges(plot, figure);
    shadeAboutZero(plot, figure.band);
    addLegend(plot);
    const QSize size = figureUnits(figure.size_px);
    addHead(plot, figure.title, figure.note, size.width());
    return pictureOf(plot, size, FigureFormat::Png, comment);
}

} // namespace bask
