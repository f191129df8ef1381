#pragma once
// Bar of the steady temperatures at which an object can be held, with its target's mark.

#include "engine/base/units.h"
#include "engine/control/feasibility.h"

#include <QWidget>

#include <optional>

namespace bask {

/// All bars of a page share one axis. Solid: reachable in the workspace; outlined: what the source could hold
/// at F = 1. Only the mark itself can be dragged: a click elsewhere on the bar does nothing.
class ReachBar : public QWidget {
    Q_OBJECT

public:
    explicit ReachBar(QWidget* parent = nullptr);

    void setAxis_K(double low_K, double high_K);
    void setTarget_K(double target_K);
    void setVerdict(const std::optional<TargetVerdict>& verdict);
    void setStale(bool stale);
    void setSeries(int index);
    void setTemperatureUnit(TemperatureUnit unit);
    void setEditable(bool editable);

    QSize minimumSizeHint() const override { return {180, sizeHint().height()}; }
    QSize sizeHint() const override; ///< two lines of text and the bar

signals:
    /// Steps of half a degree of the shown unit, within the bar's axis.
    void targetDragged(double target_K);
    void targetDropped();
    /// Sent instead of targetDropped: the mark became hidden, or may not be moved any more.
    void dragDropped();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    double x(double t_K) const;
    bool isOnMark(QPointF place) const;
    void dropDrag();
    void paintBands(QPainter& painter, const QRectF& track) const;
    void paintTarget(QPainter& painter, const QRectF& track) const;
    void describe();

    double m_low_K = 273.15;
    double m_high_K = 373.15;
    double m_target_K = 298.15;
    std::optional<TargetVerdict> m_verdict;
    bool m_stale = true;
    bool m_editable = false;
    std::optional<double> m_grip; ///< while dragged: from the mark to the pointer, px
    double m_pressed = 0.0;
    bool m_moved = false;
    int m_series = 0;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
};

} // namespace bask
