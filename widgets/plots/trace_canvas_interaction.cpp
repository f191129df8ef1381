// Ranges, mouse, keys and cursors of a trace plot.

#include "widgets/plots/trace_canvas.h"

#include "widgets/common/display.h"
#include "widgets/common/floating_place.h"
#include "widgets/common/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>

namespace bask {
namespace {

constexpr int kReplotInterval_ms = 30;
constexpr int kRest_ms = 300;
constexpr double kShortestFollow_s = 60.0;
constexpr double kShortestZoom_s = 2.0;
constexpr int kRoomForTimeLabel = 190; // px

} // namespace

void TracePlot::Canvas::connectInteraction() {
    setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, [this] { redrawNow(); });
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] { schedule(); });
    connect(this, &QCustomPlot::afterReplot, this, [this] { m_isDrawn = true; });
    connect(this, &QCustomPlot::beforeReplot, this, [this] { updatePoints(); }); // dragging draws by itself
    setProperty(kKeptFree_px, 3 * fontMetrics().height());                       // until it is known
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        setProperty(kKeptFree_px, height() - axisRect()->bottom());
        placeAxisTexts();
        placeLabels();
        placePredictionWords();
        placeMarkerTexts();
    });
    connect(xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
            [this](const QCPRange& range) { onUserRange(range); });
    connect(this, &QCustomPlot::mouseWheel, this, [this](const QWheelEvent* event) {
        updateRanges();
        const bool overValues = yAxis->selectTest(event->position(), false) >= 0.0;
        const bool values = overValues || event->modifiers().testFlag(Qt::ControlModifier);
        axisRect()->setRangeZoom(values ? Qt::Vertical : Qt::Horizontal);
        if (values) {
            m_valueAuto = false;
            axisRect()->setRangeDrag(Qt::Horizontal | Qt::Vertical);
            schedule();
        }
    });
    connect(this, &QCustomPlot::mousePress, this, [this](const QMouseEvent* event) {
        updateRanges();
        m_pressed = event->pos();
        owner->setFocus(Qt::MouseFocusReason);
    });
    connect(this, &QCustomPlot::mouseRelease, this, [this](const QMouseEvent* event) {
        if ((event->pos() - m_pressed).manhattanLength() > 4 || !axisRect()->rect().contains(event->pos()))
            return;
        if (event->button() != Qt::LeftButton || traces->rows() == 0)
            return;
        const std::optional<double> clicked_s = momentAt(xAxis->pixelToCoord(event->pos().x()));
        pinCursor(clicked_s);
        if (clicked_s)
            emit owner->momentClicked(*clicked_s);
    });
    connect(this, &QCustomPlot::mouseDoubleClick, this, [this] {
        pinCursor(std::nullopt);
        showWhole();
        setFollow(true);
    });
    connect(this, &QCustomPlot::mouseMove, this, [this](const QMouseEvent* event) {
        if (axisRect()->rect().contains(event->pos()) && traces->rows() > 0)
            showCursor(xAxis->pixelToCoord(event->pos().x()));
        else
            hideCursor();
    });
}

void TracePlot::Canvas::schedule() {
    if (!isVisible() || m_timer.isActive())
        return;
    const qint64 since = m_sinceReplot.isValid() ? m_sinceReplot.elapsed() : kReplotInterval_ms;
    m_timer.start(static_cast<int>(std::max<qint64>(0, kReplotInterval_ms - since)));
}

void TracePlot::Canvas::redrawNow() {
    m_timer.stop();
    m_pointsAreOld = m_pointsAreOld || m_isUnread;
    updateRanges();
    updateTargets();
    updateEmptyText();
    const double lowBand = -displayDifference(kSettledBand_K, unit);
    m_errorBand->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_errorBand->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_errorBand->topLeft->setCoords(0.0, -lowBand);
    m_errorBand->bottomRight->setCoords(1.0, lowBand);
    const double reference = quantity == Quantity::Speed ? 100.0 : 0.0;
    m_reference->point1->setCoords(0.0, reference);
    m_reference->point2->setCoords(1.0, reference);
    if (!follow && xAxis->range() != m_drawnRange)
        m_rest.start(kRest_ms);
    m_drawnRange = xAxis->range();
    fitPensToDensity();
    replot(QCustomPlot::rpQueuedReplot);
    m_sinceReplot.start();
}

void TracePlot::Canvas::updateRanges() {
    const QScopedValueRollback<bool> guard(m_programRange, true);
    if (follow) {
        const double last = lastTime_s();
        if (window_s > 0.0)
            xAxis->setRange(std::max(0.0, last - window_s), std::max(last, window_s));
        else
            xAxis->setRange(0.0, std::max(wholeEnd_s(), kShortestFollow_s));
    }
    updatePoints();
    auto ticker = xAxis->ticker().staticCast<QCPAxisTickerTime>();
    const bool hours = xAxis->range().upper >= 3600.0;
    ticker->setTimeFormat(hours ? QStringLiteral("%h:%m:%s") : QStringLiteral("%m:%s"));
    ticker->setFieldWidth(QCPAxisTickerTime::tuMinutes, hours ? 2 : 1);
    ticker->setFieldWidth(QCPAxisTickerTime::tuHours, 1);
    // A low plot gives the room to the trace; the plot above it names the same axis.
    const QString timeText =
        hours ? TracePlot::tr("Time since start (h:min:s)") : TracePlot::tr("Time since start (min:s)");
    xAxis->setLabel(height() < kRoomForTimeLabel ? QString() : timeText);
    yAxis->ticker()->setTickCount(std::clamp(axisRect()->height() / 34, 3, 8));
    if (m_valueAuto) {
        const auto [low, high] = wantedValueRange();
        // Keep the axis still while it fits, so that a live trace does not breathe.
        const QCPRange now = yAxis->range();
        const bool fits = now.lower <= low + 0.05 * (high - low) && now.upper >= high - 0.05 * (high - low);
        if (!fits || high - low < 0.75 * now.size())
            yAxis->setRange(low, high);
    }
    fitRightAxis();
}

void TracePlot::Canvas::setFollow(bool wanted) {
    if (wanted) {
        m_valueAuto = true;
        axisRect()->setRangeDrag(Qt::Horizontal);
    }
    schedule();
    if (follow == wanted)
        return;
    follow = wanted;
    emit owner->followLiveChanged(follow);
}

void TracePlot::Canvas::onUserRange(const QCPRange& range) {
    if (m_programRange)
        return;
    {
        const QScopedValueRollback<bool> guard(m_programRange, true);
        const double end = std::max(wholeEnd_s(), kShortestFollow_s);
        const double size = std::clamp(range.size(), kShortestZoom_s, 1.5 * end);
        const double centre = std::clamp(range.center(), 0.0, end);
        if (size != range.size() || centre != range.center())
            xAxis->setRange(centre - 0.5 * size, centre + 0.5 * size);
    }
    setFollow(false);
    schedule();
    emit owner->timeRangeChosen(xAxis->range().lower, xAxis->range().upper);
}

void TracePlot::Canvas::showTime(double from_s, double to_s) {
    if (!(to_s > from_s))
        return;
    const QScopedValueRollback<bool> guard(m_programRange, true);
    setFollow(false);
    xAxis->setRange(from_s, to_s);
    schedule();
}

void TracePlot::Canvas::showWhole() {
    m_valueAuto = true;
    const QScopedValueRollback<bool> guard(m_programRange, true);
    xAxis->setRange(0.0, std::max(wholeEnd_s(), kShortestFollow_s));
    schedule();
}

void TracePlot::Canvas::zoomTime(double factor, double centre_s) {
    xAxis->scaleRange(factor, centre_s);
}

bool TracePlot::Canvas::handleKey(const QKeyEvent* event) {
    updateRanges(); // the newest samples may not be drawn yet
    const QCPRange range = xAxis->range();
    const double newest = std::max(lastTime_s(), kShortestFollow_s); // a prediction goes on after it
    const double centre = follow ? std::min(range.upper, newest) : range.center();
    switch (event->key()) {
    case Qt::Key_Left:
        xAxis->moveRange(-0.15 * range.size());
        return true;
    case Qt::Key_Right:
        xAxis->moveRange(0.15 * range.size());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        zoomTime(0.8, centre);
        return true;
    case Qt::Key_Minus:
        zoomTime(1.25, centre);
        return true;
    case Qt::Key_Home:
        showWhole();
        setFollow(false);
        emit owner->timeRangeChosen(xAxis->range().lower, xAxis->range().upper);
        return true;
    case Qt::Key_End:
        setFollow(true);
        return true;
    case Qt::Key_Escape:
        if (!pinned_s)
            return false;
        pinCursor(std::nullopt);
        return true;
    default:
        return false;
    }
}

void TracePlot::Canvas::showCursor(double time_s) {
    m_cursor_s = momentAt(time_s);
    if (!m_cursor_s)
        return hideCursor();
    m_cursor->start->setCoords(*m_cursor_s, 1.0);
    m_cursor->end->setCoords(*m_cursor_s, 0.0);
    m_cursor->setVisible(true);
    layer(QStringLiteral("cursor"))->replot();

    const QList<ReadValue> parts = readout(*m_cursor_s, pinned_s);
    QString rich = QStringLiteral("<b>%1</b>").arg(parts.value(0).words.toHtmlEscaped());
    for (int i = 1; i < parts.size(); ++i)
        rich += QStringLiteral("<br><span style='color:%1'>\u25a0</span> %2")
                    .arg(parts[i].color.name(), parts[i].words.toHtmlEscaped());
    m_readout->setText(rich);
    m_readout->adjustSize();
    // On the side away from the cursor, so that it never hides what is pointed at.
    const QRect area = axisRect()->rect();
    const bool isLeft = xAxis->coordToPixel(*m_cursor_s) > area.center().x();
    m_readout->move(isLeft ? area.left() + 8 : area.right() - m_readout->width() - 8,
                    area.bottom() - m_readout->height() - 6);
    m_readout->show();
}

void TracePlot::Canvas::hideCursor() {
    m_cursor_s.reset();
    m_readout->hide();
    if (m_cursor->visible()) {
        m_cursor->setVisible(false);
        layer(QStringLiteral("cursor"))->replot();
    }
}

void TracePlot::Canvas::pinCursor(std::optional<double> time_s) {
    if (!time_s && !pinned_s)
        return;
    pinned_s = time_s;
    m_pinned->setVisible(time_s.has_value());
    if (time_s) {
        m_pinned->start->setCoords(*time_s, 1.0);
        m_pinned->end->setCoords(*time_s, 0.0);
    }
    layer(QStringLiteral("cursor"))->replot();
}

void TracePlot::Canvas::measureFrom(std::optional<int> x) {
    updateRanges();
    if (traces->rows() == 0)
        return;
    const std::optional<double> there_s = x ? std::optional(xAxis->pixelToCoord(*x)) : m_cursor_s;
    pinCursor(momentAt(there_s ? *there_s : position_s.value_or(traces->lastTime_s())));
}

void TracePlot::Canvas::setPosition(std::optional<double> time_s) {
    if (position_s == time_s)
        return;
    position_s = time_s;
    m_position->setVisible(time_s.has_value());
    if (time_s) {
        m_position->start->setCoords(*time_s, 1.0);
        m_position->end->setCoords(*time_s, 0.0);
    }
    if (isVisible() && m_isDrawn) // else the first drawing is still to come, with the line
        layer(QStringLiteral("cursor"))->replot();
}

void TracePlot::Canvas::resizeEvent(QResizeEvent* event) {
    QCustomPlot::resizeEvent(event);
    schedule();
}

void TracePlot::Canvas::leaveEvent(QEvent* event) {
    QCustomPlot::leaveEvent(event);
    hideCursor();
}

} // namespace bask
