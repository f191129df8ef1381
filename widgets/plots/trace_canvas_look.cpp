// Pens, texts, line-end labels and markers of a trace plot.

#include "widgets/plots/figure_style.h"
#include "widgets/plots/quantity_words.h"
#include "widgets/plots/trace_canvas.h"

#include "engine/radiation/mounted_objects.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QLabel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace bask {
namespace {

constexpr int kLongestLabel = 130; // px; longer names are elided
constexpr int kLongestMarker = 220;

QColor withAlpha(QColor color, int alpha) {
    color.setAlpha(alpha);
    return color;
}

} // namespace

QPen TracePlot::Canvas::penOfSeries(int series) const {
    const bool isPlain = !overlays.empty(); // dashes tell the runs apart then
    if (!isOfRun())
        return isPlain ? QPen(seriesColor(series, dark), 1.8) : seriesPen(series, dark, 1.8);
    QPen pen(inkOfRun(series), 1.6);
    if (series == 1 && !isPlain)
        pen.setDashPattern({6, 2.5});
    return pen;
}

/// Of the theme that it is told: its own palette may still be that of the one before.
QColor TracePlot::Canvas::inkOfRun(int series) const {
    return series == 0 ? themePalette(dark).color(QPalette::Text) : accentColor(dark);
}

void TracePlot::Canvas::restyle(bool darkGround) {
    dark = darkGround;
    const QPalette colors = themePalette(dark);
    const QColor ink = colors.color(QPalette::Text);
    const QColor quiet = secondaryText(dark);
    setBackground(colors.brush(QPalette::Base));
    for (QCPAxis* axis : {xAxis, yAxis, yAxis2}) {
        axis->setBasePen(QPen(quiet, 1));
        axis->setTickPen(QPen(quiet, 1));
        axis->setSubTickPen(Qt::NoPen);
        axis->setTickLabelColor(ink);
        axis->setLabelColor(quiet);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->setTickLengthIn(0);
        axis->setTickLengthOut(4);
        axis->setLabelPadding(3);
        axis->grid()->setPen(QPen(withAlpha(hairline(dark), 170), 1));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
    for (int i = 0; i < m_series.size(); ++i) {
        m_series[i]->setPen(penOfSeries(i));
        QFont bold = font();
        bold.setBold(true);
        m_labels[i]->setFont(bold);
        m_labels[i]->setColor(penOfSeries(i).color());
    }
    stylePrediction();
    const QColor band = withAlpha(dark ? QColor(255, 255, 255) : QColor(0, 0, 0), dark ? 30 : 22);
    const auto targets = static_cast<double>(m_targets.size());
    for (int i = 0; i < m_targets.size(); ++i) {
        m_bandLow[i]->setPen(Qt::NoPen);
        m_bandHigh[i]->setPen(Qt::NoPen);
        m_bandHigh[i]->setBrush(band);
        // Interleaved dashes: where targets coincide the line shows every object's colour in turn.
        QPen pen(seriesColor(i, dark), 1.4);
        pen.setCapStyle(Qt::FlatCap);
        pen.setDashPattern({5.0, std::max(4.0, 5.0 * (targets - 1.0))});
        pen.setDashOffset(5.0 * i);
        m_targets[i]->setPen(pen);
    }
    m_errorBand->setPen(Qt::NoPen);
    m_errorBand->setBrush(band);
    m_reference->setPen(QPen(quantity == Quantity::Speed ? ink : quiet, 1,
                             quantity == Quantity::Speed ? Qt::DashLine : Qt::SolidLine));
    m_empty->setColor(quiet);
    m_empty->setBrush(colors.color(QPalette::Base)); // the line of zero runs behind it
    m_empty->setPadding(QMargins(6, 2, 6, 2));
    m_empty->setFont(font());
    m_predictionText->setColor(quiet);
    m_predictionText->setFont(font());
    m_predictionText->setPadding(QMargins(3, 0, 3, 0));
    m_predictionText->setBrush(withAlpha(colors.color(QPalette::Base), 140)); // measured lines cross it
    m_cursor->setPen(QPen(quiet, 1));
    m_pinned->setPen(QPen(accentColor(dark), 1, Qt::DashLine));
    m_position->setPen(QPen(accentColor(dark), 2));
    for (const Marker& marker : std::as_const(markers)) {
        marker.line->setPen(QPen(withAlpha(quiet, 190), 1, Qt::DotLine));
        marker.label->setColor(quiet);
        marker.label->setFont(font());
    }
    styleRight(Density::Loose);
    QPalette readoutColors = colors;
    readoutColors.setColor(QPalette::Window, withAlpha(colors.color(QPalette::Base), 235));
    m_readout->setPalette(readoutColors);
    fitMargins();
    schedule();
}

QString TracePlot::Canvas::axisText() const {
    return quantityAxis(quantity, unit);
}

void TracePlot::Canvas::retranslate() {
    yAxis->setLabel(axisText());
    yAxis2->setLabel(rightAxisText());
    xAxis->setLabel(TracePlot::tr("Time since start (min:s)"));
    for (int i = 0; i < m_series.size(); ++i)
        m_series[i]->setName(seriesName(i));
    const QString axes =
        rightAxis.quantity ? axisText() + QStringLiteral(", ") + rightAxisText() : axisText();
    owner->setAccessibleName(TracePlot::tr("Plot against time: %1").arg(axes));
    owner->setAccessibleDescription(TracePlot::tr(
        "Arrow keys move, plus and minus zoom, Home shows the whole run, End goes back to live."));
    owner->setToolTip(QString());
    m_predictionText->setText(predictionWords());
    fitMargins();
    schedule();
}

/// Whole words, or none of them: where an axis is low its unit, and the tab or the plot beside it name it.
void TracePlot::Canvas::placeAxisTexts() {
    const QRect area = axisRect()->rect();
    const int room = area.height() - 4 + 2 * std::max(0, std::min(area.top(), height() - area.bottom() - 1));
    const auto fitting = [&](Quantity of, const QString& whole) {
        return QFontMetrics(font()).horizontalAdvance(whole) <= room ? whole : quantityAxisUnit(of, unit);
    };
    yAxis->setLabel(fitting(quantity, axisText()));
    if (rightAxis.quantity)
        yAxis2->setLabel(fitting(*rightAxis.quantity, rightAxisText()));
}

/// A thick line with dashes takes thirty times as long as a plain one, a thin one another tenth: while it is
/// moved it is plain where samples stand close, and always plain and thin where they are denser than pixels.
void TracePlot::Canvas::fitPensToDensity() {
    const QCPRange time = xAxis->range();
    const std::size_t visible = traces->samplesBetween(time.lower, time.upper);
    const int width = std::max(1, axisRect()->width());
    // Of overlays the dashes tell the runs apart.
    const int max = overlays.empty() || m_rest.isActive() ? width : 4 * width;
    const Density density = std::cmp_greater(visible, max)                              ? Density::Dense
                            : m_rest.isActive() && std::cmp_greater(4 * visible, width) ? Density::Close
                                                                                        : Density::Loose;
    for (int i = 0; i < m_series.size(); ++i) {
        const QPen pen = penOfSeries(i);
        m_series[i]->setPen(density == Density::Loose ? pen : plainPen(pen, density));
        markObject(m_series[i], i);
    }
    styleOverlays(density);
    styleRight(density);
}

QPen TracePlot::Canvas::plainPen(const QPen& pen, Density density) {
    return {pen.color(), density == Density::Dense ? 1.0 : pen.widthF()};
}

/// Fixed left and right margins, so that plots above each other line up.
void TracePlot::Canvas::fitMargins() {
    QFont bold = font();
    bold.setBold(true);
    const QFontMetrics metrics(font()), boldMetrics(bold);
    int widest = boldMetrics.horizontalAdvance(TracePlot::tr("translation")); // the same in all quantities
    for (int i = 0; i < m_labels.size(); ++i) {
        const QString text = boldMetrics.elidedText(seriesName(i), Qt::ElideRight, kLongestLabel);
        m_labels[i]->setText(text);
        widest = std::max(widest, boldMetrics.horizontalAdvance(text));
    }
    for (const Overlay& overlay : overlays)
        for (const QCPItemText* label : overlay.labels)
            widest = std::max(widest, metrics.horizontalAdvance(label->text()));
    for (const QCPItemText* label : std::as_const(rightAxis.labels))
        widest = std::max(widest, metrics.horizontalAdvance(label->text()) + metrics.averageCharWidth());
    for (const QString& name : std::as_const(names))
        widest = std::max(widest, std::min(kLongestLabel, boldMetrics.horizontalAdvance(name)));
    const int left = metrics.horizontalAdvance(QStringLiteral("0.000")) + metrics.height() + 20;
    axisRect()->setMargins(
        QMargins(left, std::max({10, markerStrip(), m_emptyStrip}), widest + 14 + rightAxisWidth(), 0));
    axisRect()->setMinimumMargins(QMargins(0, 0, 0, 0));
}

void TracePlot::Canvas::updateEmptyText() {
    QString text;
    const bool isPredicted = !m_predicted.isEmpty();
    if (traces->rows() == 0) {
        text = isPredicted ? TracePlot::tr("Dotted: predicted. Traces begin with Start.")
                           : TracePlot::tr("No samples yet. Traces begin with Start.");
    } else if (quantity == Quantity::Strength && !traces->hasValues(quantity)) {
        text = TracePlot::tr("This controller does not estimate \u03bb\u2081.");
    } else if (quantity == Quantity::Shade && !(traces->largest(quantity) >= kMinToldShare)) {
        text = TracePlot::tr("Nothing has shaded an object.");
    }
    const int room = std::max(axisRect()->width(), width() / 2); // it has none before the first layout
    m_empty->setText(inLines(text, font(), room));
    const bool isAbove = isPredicted && !text.isEmpty(); // over the lines it would hide them
    m_empty->position->setCoords(0.5, isAbove ? 0.0 : 0.5);
    m_empty->setPositionAlignment(Qt::AlignHCenter | (isAbove ? Qt::AlignBottom : Qt::AlignVCenter));
    m_empty->setVisible(!text.isEmpty());
    const int strip =
        isAbove ? QFontMetrics(font()).height() * (1 + static_cast<int>(m_empty->text().count(u'\n'))) + 4
                : 0;
    if (std::exchange(m_emptyStrip, strip) != strip)
        fitMargins();
    m_errorBand->setVisible(quantity == Quantity::Error);
    const ShownAs shown = quantityShownAs(quantity);
    m_reference->setVisible(shown == ShownAs::Difference || shown == ShownAs::RatePerMinute ||
                            quantity == Quantity::Speed);
}

QCPItemText* TracePlot::Canvas::makeLineLabel() {
    auto* label = new QCPItemText(this);
    label->setLayer(QStringLiteral("labels"));
    label->setClipToAxisRect(false);
    label->setPositionAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    label->position->setType(QCPItemPosition::ptAbsolute);
    return label;
}

/// Names stand at the right, at the height of each line's last visible point, pushed apart where they would
/// overlap.
void TracePlot::Canvas::placeLabels() {
    struct Wish {
        QCPItemText* label;
        double y;
    };
    std::vector<Wish> wishes;
    const QRect area = axisRect()->rect();
    QList<QCPGraph*> graphs = m_series + rightAxis.graphs;
    QList<QCPItemText*> labels = m_labels + rightAxis.labels;
    for (const Overlay& overlay : overlays) {
        graphs << overlay.graphs;
        labels << overlay.labels;
    }
    if (traces->rows() == 0 && !m_predicted.isEmpty()) // names stand at the lines that are there
        std::ranges::copy(m_predicted, graphs.begin());
    for (int i = 0; i < graphs.size(); ++i) {
        const auto points = graphs[i]->data();
        auto it = points->findEnd(xAxis->range().upper, false);
        const auto begin = points->findBegin(xAxis->range().lower, false);
        bool found = false;
        while (!found && it != begin && it != points->constBegin()) {
            --it;
            found = std::isfinite(it->value);
        }
        labels[i]->setVisible(found);
        if (found)
            wishes.push_back({labels[i], std::clamp(graphs[i]->valueAxis()->coordToPixel(it->value),
                                                    double(area.top()), double(area.bottom()))});
    }
    std::ranges::stable_sort(wishes, {}, &Wish::y);
    QFont bold = font();
    bold.setBold(true);
    const double step = QFontMetrics(bold).height();
    for (std::size_t i = 1; i < wishes.size(); ++i)
        wishes[i].y = std::max(wishes[i].y, wishes[i - 1].y + step);
    // What was pushed out at the bottom comes back up.
    double floor = area.bottom() - 0.3 * step;
    for (std::size_t i = wishes.size(); i-- > 0;) {
        wishes[i].y = std::min(wishes[i].y, floor);
        floor = wishes[i].y - step;
    }
    for (const Wish& wish : wishes)
        wish.label->position->setPixelPosition({area.right() + 8.0 + rightAxisWidth(), wish.y});
}

void TracePlot::Canvas::addMarker(double time_s, const QString& text) {
    if (!std::isfinite(time_s))
        return;
    auto* line = new QCPItemLine(this);
    line->setClipToAxisRect(false); // it leads to its words
    for (QCPItemPosition* end : {line->start, line->end}) {
        end->setTypeX(QCPItemPosition::ptPlotCoords);
        end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    }
    line->start->setCoords(time_s, 1.0);
    auto* label = new QCPItemText(this);
    label->setLayer(QStringLiteral("labels"));
    label->setClipToAxisRect(false);
    label->position->setTypeX(QCPItemPosition::ptPlotCoords);
    label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
    label->position->setCoords(time_s, 0.0);
    label->setPadding(QMargins(4, 1, 3, 1));
    label->setVisible(false);
    markers.append({time_s, text, line, label});
    std::ranges::stable_sort(markers, {}, &Marker::time_s);
    restyle(dark);
}

void TracePlot::Canvas::clearMarkers() {
    for (const Marker& marker : std::as_const(markers)) {
        removeItem(marker.line);
        removeItem(marker.label);
    }
    markers.clear();
    fitMargins();
    schedule();
}

void TracePlot::Canvas::showMarkerTexts(bool visible) {
    markerTexts = visible;
    fitMargins();
    schedule();
}

QString TracePlot::Canvas::wordsOf(const QString& marker) const {
    return overlays.empty() ? marker : QStringLiteral("%1 (%2)").arg(marker, kOwnMark);
}

int TracePlot::Canvas::markerStrip() const {
    return markerTexts && !markers.isEmpty() ? QFontMetrics(font()).height() + 6 : 0;
}

/// A marker's words stand above the traces, which they would hide, right of its line or left of it where
/// there is no room, elided where neither side has enough.
void TracePlot::Canvas::placeMarkerTexts() {
    const QFontMetrics metrics(font());
    const QRect area = axisRect()->rect();
    constexpr double kAround = 12.0;
    double taken = area.left();
    for (qsizetype i = 0; i < markers.size(); ++i) {
        const Marker& marker = markers[i];
        const double x = xAxis->coordToPixel(marker.time_s);
        const double next =
            i + 1 < markers.size() ? xAxis->coordToPixel(markers[i + 1].time_s) : area.right();
        const double right = std::min(next, double(area.right())) - x - kAround;
        const double left = x - taken - kAround;
        const QString words = wordsOf(marker.text);
        const double wanted = std::min(metrics.horizontalAdvance(words), kLongestMarker);
        const bool onLeft = right < wanted && left > right;
        const double room = std::min(onLeft ? left : right, double(kLongestMarker));
        const bool inside = x >= area.left() && x <= area.right();
        const bool shown = markerTexts && inside && room >= std::min(wanted, 40.0);
        marker.label->setVisible(shown);
        marker.line->setVisible(inside);
        marker.line->end->setCoords(marker.time_s,
                                    shown ? -double(markerStrip()) / std::max(1, area.height()) : 0.0);
        if (shown) {
            marker.label->setText(metrics.elidedText(words, Qt::ElideRight, static_cast<int>(room)));
            marker.label->setPositionAlignment((onLeft ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignBottom);
        }
        if (inside)
            taken = shown && !onLeft ? x + metrics.horizontalAdvance(marker.label->text()) + kAround : x;
    }
}

} // namespace bask
