#include "widgets/thermal/thermal_histogram_plot.h"

#include "widgets/common/colour_map.h"
#include "widgets/common/display.h"
#include "widgets/common/theme.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr double kSpace = 4.0;

} // namespace

ThermalHistogramPlot::ThermalHistogramPlot(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("thermalHistogram"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    describe();
}

void ThermalHistogramPlot::setHistogram(const QString& subject, std::optional<ThermalHistogram> histogram,
                                        const ThermalLook& look) {
    m_subject = subject;
    m_histogram = std::move(histogram);
    m_look = look;
    m_look.isotherm.reset(); // marks pixels, not bins
    describe();
    update();
}

void ThermalHistogramPlot::setTemperatureUnit(TemperatureUnit unit) {
    m_unit = unit;
    describe();
    update();
}

double ThermalHistogramPlot::to_K() const {
    return m_histogram->from_K + m_histogram->bin_K * static_cast<double>(m_histogram->counts.size());
}

QString ThermalHistogramPlot::title() const {
    return m_histogram ? tr("%1: %n pixel(s)", nullptr, m_histogram->pixels).arg(m_subject) : m_subject;
}

QString ThermalHistogramPlot::summary() const {
    if (!m_histogram)
        return tr("No pixels are read");
    const double deviation = displayDifference(m_histogram->deviation_K, m_unit);
    const auto decimals = decimalsOf(deviation, 2);
    const QString mean = formatTemperature(m_histogram->mean_K, m_unit, decimals.value_or(2));
    if (!decimals)
        return tr("mean %1").arg(mean);
    return tr("mean %1, s.d. %2", "standard deviation")
        .arg(mean,
             QLocale().toString(deviation, 'f', *decimals) + QChar(0x00a0) + differenceUnitSymbol(m_unit));
}

void ThermalHistogramPlot::describe() {
    setAccessibleName(tr("Distribution of apparent temperatures"));
    const QString words = title() + QStringLiteral("; ") + summary();
    if (words != accessibleDescription()) {
        setAccessibleDescription(words);
        setToolTip(words);
    }
}

void ThermalHistogramPlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        describe();
    update();
    QWidget::changeEvent(event);
}

void ThermalHistogramPlot::paintBars(QPainter& painter, const QRectF& place) const {
    const auto bins = static_cast<double>(m_histogram->counts.size());
    const double most = std::max(1, *std::ranges::max_element(m_histogram->counts));
    const double width = place.width() / bins;
    const QColor edge = mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Base), 0.45);
    for (std::size_t k = 0; k < m_histogram->counts.size(); ++k) {
        const int count = m_histogram->counts[k];
        if (count == 0)
            continue;
        const double height = std::max(1.5, count / most * place.height());
        const double middle_K = m_histogram->from_K + (static_cast<double>(k) + 0.5) * m_histogram->bin_K;
        const QRectF bar(place.left() + static_cast<double>(k) * width, place.bottom() - height, width,
                         height);
        painter.fillRect(bar, QColor::fromRgb(thermalRgb(middle_K, m_look)));
        painter.setPen(QPen(edge, 1.0)); // the colours of either end are near to one theme's ground
        painter.drawLine(bar.topLeft(), bar.topRight());
        const int before = k > 0 ? m_histogram->counts[k - 1] : 0;
        const int after = k + 1 < m_histogram->counts.size() ? m_histogram->counts[k + 1] : 0;
        if (before < count)
            painter.drawLine(bar.topLeft(), {bar.left(), place.bottom() - before / most * place.height()});
        if (after < count)
            painter.drawLine(bar.topRight(), {bar.right(), place.bottom() - after / most * place.height()});
    }
}

void ThermalHistogramPlot::paintAxis(QPainter& painter, const QRectF& place) const {
    painter.setPen(secondaryText(isDark(this)));
    painter.drawLine(place.bottomLeft(), place.bottomRight());
    const double from = displayTemperature(m_histogram->from_K, m_unit);
    const double to = displayTemperature(to_K(), m_unit);
    const QFontMetricsF metrics(painter.font());
    const double step = niceRange(from, to, std::max(1, static_cast<int>(place.width() / 45.0))).step;
    const int decimals = step < 1.0 ? static_cast<int>(std::ceil(-std::log10(step) - 1e-9)) : 0;
    for (double k = std::ceil(from / step - 1e-6); k * step <= to + 1e-6 * step; k += 1.0) {
        const double x = place.left() + (k * step - from) / (to - from) * place.width();
        painter.drawLine(QPointF(x, place.bottom()), QPointF(x, place.bottom() + 3.0));
        const QString text = formatTemperatureNumber(kelvinFromDisplay(k * step, m_unit), m_unit, decimals);
        QRectF box(0.0, place.bottom() + 4.0, metrics.horizontalAdvance(text), metrics.height());
        box.moveLeft(std::clamp(x - 0.5 * box.width(), place.left(), place.right() - box.width()));
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    }
}

void ThermalHistogramPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const double line = fontMetrics().height();
    const auto elided = [this](const QString& text, double room) {
        return fontMetrics().elidedText(text, Qt::ElideRight, static_cast<int>(room));
    };
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     elided(title(), width()));
    painter.setPen(secondaryText(isDark(this)));
    painter.drawText(QRectF(0.0, line, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     elided(summary(), width()));
    if (!m_histogram)
        return;
    const QString unit = temperatureUnitSymbol(m_unit);
    const double unitWidth = fontMetrics().horizontalAdvance(unit);
    const QRectF place(0.5, 2.0 * line + kSpace + 0.5, width() - unitWidth - kSpace - 2.0,
                       height() - 3.0 * line - 2.0 * kSpace - 2.0);
    if (place.height() < 8.0 || place.width() < 40.0)
        return;
    paintBars(painter, place);
    paintAxis(painter, place);
    painter.drawText(QRectF(width() - unitWidth - 1.0, place.bottom() + 4.0, unitWidth + 1.0, line),
                     Qt::AlignLeft | Qt::AlignVCenter, unit);
    const double mean = place.left() + (m_histogram->mean_K - m_histogram->from_K) /
                                           (to_K() - m_histogram->from_K) * place.width();
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.0, Qt::DashLine));
    painter.drawLine(QPointF(mean, place.top()), QPointF(mean, place.bottom()));
}

} // namespace bask
