// A second quantity of the run on the right axis of a trace plot: a scale of its own, colours by object,
// groups of dots in place of dashes, so that it is told from the left one without colours.

#include "widgets/plots/figure_style.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_canvas.h"

#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bask {
namespace {

constexpr int kLongestRightName = 100; // px, in front of its mark

} // namespace

void TracePlot::Canvas::setRight(std::optional<Quantity> wanted) {
    rightAxis.quantity = wanted == quantity ? std::nullopt : wanted;
    yAxis2->setVisible(rightAxis.quantity.has_value());
    rebuild();
}

/// The graphs went with clearGraphs().
void TracePlot::Canvas::rebuildRight() {
    rightAxis.graphs.clear();
    for (QCPItemText* label : std::as_const(rightAxis.labels))
        removeItem(label);
    rightAxis.labels.clear();
    if (!rightAxis.quantity)
        return;
    const auto count = static_cast<int>(bask::seriesCount(*rightAxis.quantity, traces->objects()));
    for (int i = 0; i < count; ++i) {
        rightAxis.graphs << addGraph(xAxis, yAxis2);
        rightAxis.graphs.back()->setAdaptiveSampling(true);
        rightAxis.labels << makeLineLabel();
    }
}

QString TracePlot::Canvas::rightName(int series) const {
    const QString ofRun = quantitySeries(*rightAxis.quantity, static_cast<std::size_t>(series));
    return (ofRun.isEmpty() ? names.value(series) : ofRun) + QStringLiteral(" \u25b8");
}

QString TracePlot::Canvas::rightAxisText() const {
    return rightAxis.quantity ? quantityAxis(*rightAxis.quantity, unit) : QString();
}

QPen TracePlot::Canvas::penOfRight(int series) const {
    const bool isOfObjects = plottedColumn(*rightAxis.quantity) != nullptr;
    QPen pen(isOfObjects ? seriesColor(series, dark) : inkOfRun(series), 1.5);
    pen.setCapStyle(Qt::FlatCap);
    pen.setDashPattern(dotGroups(series));
    return pen;
}

void TracePlot::Canvas::styleRight(Density density) {
    QFont slanted = font();
    slanted.setItalic(true);
    const QFontMetrics metrics(slanted);
    for (int i = 0; i < rightAxis.graphs.size(); ++i) {
        const QPen pen = penOfRight(i);
        rightAxis.graphs[i]->setPen(density == Density::Loose ? pen : plainPen(pen, density));
        rightAxis.labels[i]->setFont(slanted);
        rightAxis.labels[i]->setColor(pen.color());
        rightAxis.labels[i]->setText(metrics.elidedText(rightName(i), Qt::ElideMiddle, kLongestRightName));
    }
}

/// The room of the right axis with its words, px: as much as on the left.
int TracePlot::Canvas::rightAxisWidth() const {
    const QFontMetrics metrics(font());
    return rightAxis.quantity ? metrics.horizontalAdvance(QStringLiteral("0.000")) + metrics.height() + 20
                              : 0;
}

/// Always as large as what is shown: a person zooms the left one.
void TracePlot::Canvas::fitRightAxis() {
    if (!rightAxis.quantity)
        return;
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    const QCPRange time = xAxis->range();
    for (const QCPGraph* graph : std::as_const(rightAxis.graphs)) {
        const auto points = graph->data();
        for (auto it = points->findBegin(time.lower); it != points->findEnd(time.upper); ++it)
            if (std::isfinite(it->value)) {
                low = std::min(low, it->value);
                high = std::max(high, it->value);
            }
    }
    if (!(low <= high)) { // nothing to show
        low = 0.0;
        high = 1.0;
    }
    const bool isNumber = quantityShownAs(*rightAxis.quantity) == ShownAs::Number;
    const double smallest =
        isNumber ? 0.02 * std::max(std::abs(low), std::abs(high)) : displayDifference(2.0, unit);
    const double margin = 0.06 * (high - low) + 0.5 * std::max(0.0, std::max(smallest, 1e-12) - (high - low));
    low -= margin;
    high += margin;
    // As on the left, a scale that fits stays.
    const QCPRange now = yAxis2->range();
    const double slack = 0.05 * (high - low);
    if (now.lower > low + slack || now.upper < high - slack || high - low < 0.75 * now.size())
        yAxis2->setRange(low, high);
    yAxis2->ticker()->setTickCount(yAxis->ticker()->tickCount());
}

} // namespace bask
