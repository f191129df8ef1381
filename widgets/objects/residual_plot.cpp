#include "widgets/objects/residual_plot.h"

#include "widgets/common/theme.h"
#include "widgets/objects/outline_painting.h"

#include <QEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace bask {

struct ResidualPlot::Axes {
    QRectF frame;
    int lowDecade = -2;
    int highDecade = 1;

    double x(double harmonics) const {
        return frame.left() + (harmonics - 1.0) / (kMaxHarmonics - 1.0) * frame.width();
    }
    double y(double value_mm) const {
        const double t = (std::log10(value_mm) - lowDecade) / (highDecade - lowDecade);
        return frame.bottom() - std::clamp(t, 0.0, 1.0) * frame.height();
    }
};

ResidualPlot::ResidualPlot(QWidget* parent) : QWidget(parent), m_color(Qt::gray) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    retranslate();
}

void ResidualPlot::clear() {
    m_residuals.fill({});
    update();
}

void ResidualPlot::setResidual(int harmonics, double rms_m, double max_m) {
    // A perfect fit has no place on a logarithmic axis: draw it at a nanometre.
    m_residuals.at(static_cast<std::size_t>(harmonics)) = {std::max(rms_m * 1e3, 1e-6),
                                                           std::max(max_m * 1e3, 1e-6)};
    update();
}

void ResidualPlot::setCurrent(int harmonics) {
    m_current = harmonics;
    update();
}

void ResidualPlot::setColor(const QColor& color) {
    m_color = color;
    update();
}

void ResidualPlot::retranslate() {
    setAccessibleName(tr("Residual against the number of harmonics"));
    setToolTip(tr("Distance between the imported outline and the Fourier outline. Click to choose a number "
                  "of harmonics."));
}

void ResidualPlot::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
        update();
    QWidget::changeEvent(event);
}

void ResidualPlot::mousePressEvent(QMouseEvent* event) {
    const QRectF frame = axes().frame;
    const double t = (event->position().x() - frame.left()) / std::max(frame.width(), 1.0);
    const int harmonics =
        std::clamp(static_cast<int>(std::lround(1.0 + t * (kMaxHarmonics - 1.0))), 1, kMaxHarmonics);
    if (isEnabled() && event->button() == Qt::LeftButton)
        emit harmonicsClicked(harmonics);
}

ResidualPlot::Axes ResidualPlot::axes() const {
    Axes axes;
    double low = 1e9;
    double high = 0.0;
    for (const Residual& r : m_residuals) {
        if (r.rms_mm > 0.0) {
            low = std::min(low, r.rms_mm);
            high = std::max(high, r.max_mm);
        }
    }
    if (high > 0.0) {
        axes.highDecade = static_cast<int>(std::ceil(std::log10(high)));
        axes.lowDecade = std::max(static_cast<int>(std::floor(std::log10(low))), axes.highDecade - 5);
        axes.lowDecade = std::min(axes.lowDecade, axes.highDecade - 1);
    }
    const QFontMetricsF metrics(font());
    const double left = metrics.horizontalAdvance(QLocale().toString(std::pow(10.0, axes.lowDecade))) + 10.0;
    const double line = metrics.height();
    axes.frame = QRectF(rect()).adjusted(std::max(left, 34.0), line + 4.0, -8.0, -line - 6.0);
    return axes;
}

void ResidualPlot::paintAxes(QPainter& painter, const Axes& axes) const {
    const QColor text = mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), 0.75);
    const QColor grid = mixed(palette().color(QPalette::WindowText), palette().color(QPalette::Window), 0.14);
    const double line = fontMetrics().height();
    for (int decade = axes.lowDecade; decade <= axes.highDecade; ++decade) {
        const double y = axes.y(std::pow(10.0, decade));
        painter.setPen(grid);
        painter.drawLine(QLineF(axes.frame.left(), y, axes.frame.right(), y));
        painter.setPen(text);
        painter.drawText(QRectF(0.0, y - line / 2.0, axes.frame.left() - 5.0, line),
                         Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(std::pow(10.0, decade)));
    }
    for (const int h : {1, 10, 20, 30, 40}) {
        painter.setPen(grid);
        painter.drawLine(QLineF(axes.x(h), axes.frame.top(), axes.x(h), axes.frame.bottom()));
        painter.setPen(text);
        const double right = std::min(axes.x(h) + 20.0, static_cast<double>(width()));
        painter.drawText(QRectF(right - 40.0, axes.frame.bottom() + 2.0, 40.0, line),
                         h == kMaxHarmonics ? Qt::AlignRight : Qt::AlignHCenter, QLocale().toString(h));
    }
    painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft,
                     tr("Residual, mm: rms (line), largest (dashes)"));
    painter.drawText(
        QRectF(axes.x(20) + 14.0, axes.frame.bottom() + 2.0, axes.x(30) - axes.x(20) - 28.0, line),
        Qt::AlignHCenter,
        fontMetrics().elidedText(tr("harmonics"), Qt::ElideRight,
                                 static_cast<int>(axes.x(30) - axes.x(20) - 28.0)));
}

void ResidualPlot::paintCurve(QPainter& painter, const Axes& axes, double Residual::*value) const {
    QPolygonF curve;
    for (int h = 1; h <= kMaxHarmonics; ++h) {
        const double v = m_residuals.at(static_cast<std::size_t>(h)).*value;
        if (v > 0.0)
            curve << QPointF(axes.x(h), axes.y(v));
    }
    painter.drawPolyline(curve);
}

void ResidualPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Axes axes = this->axes();
    paintAxes(painter, axes);
    painter.setOpacity(isEnabled() ? 1.0 : 0.45);
    painter.setPen(QPen(m_color, 1.2, Qt::DashLine));
    paintCurve(painter, axes, &Residual::max_mm);
    painter.setPen(QPen(m_color, 2.0));
    paintCurve(painter, axes, &Residual::rms_mm);
    if (m_current < 1 || m_current > kMaxHarmonics)
        return;
    painter.setPen(QPen(palette().color(QPalette::WindowText), 1.0));
    painter.drawLine(QLineF(axes.x(m_current), axes.frame.top(), axes.x(m_current), axes.frame.bottom()));
    const double rms_mm = m_residuals.at(static_cast<std::size_t>(m_current)).rms_mm;
    if (rms_mm > 0.0) {
        painter.setPen(QPen(palette().color(QPalette::Window), 1.5));
        painter.setBrush(m_color);
        painter.drawEllipse(QPointF(axes.x(m_current), axes.y(rms_mm)), 5.0, 5.0);
    }
}

} // namespace bask
