#pragma once
// A map of the temperatures that two objects can have at the same time, with the point of their targets.

#include "engine/base/units.h"
#include "engine/control/reachable_pairs.h"

#include <QImage>
#include <QWidget>

#include <array>
#include <optional>

namespace bask {

/// Returns the colour of cells that a search reached, but no sampled pose.
QColor rareColour(const QPalette& palette);

/// The first object's temperature to the right, the second's upwards. Colour: how many of the poses come into
/// a cell, logarithmic; rareColour: a pose does, but none of the sampled ones; ground: none. The target moves
/// at once; what the map says of it follows when a map with that target is set.
///
/// The point can be dragged; a double click takes the temperatures there as targets, the arrow keys move them
/// by half a degree. A single click beside the point does nothing: a run may be on.
class ReachMap : public QWidget {
    Q_OBJECT

public:
    explicit ReachMap(QWidget* parent = nullptr);

    void setNames(const QString& first, const QString& second);
    void setMap(const ReachableMap& map);
    /// Hatches the map because it belongs to other objects, source or robot than the open ones.
    void setStale(bool stale);
    void setTarget_K(const Eigen::Vector2d& target_K);
    void setTemperatureUnit(TemperatureUnit unit);
    void setEditable(bool editable);

    /// Returns "2.3 K inside", "4.1 K outside", or that it is being checked.
    QString words() const;
    /// Returns the painted map for a file; `size` in device-independent pixels.
    QImage picture(const QSize& size, double devicePixelRatio) const;

signals:
    /// Sent at each step of a drag, which ends with targetsPicked, or with dragDropped if the map became
    /// hidden or the targets may not be changed any more.
    void targetsDragged(double first_K, double second_K);
    void dragDropped();
    void targetsPicked(double first_K, double second_K);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Axes;
    Axes axes(const QSizeF& size) const;
    bool answered() const;
    QPointF pointPlace(const Axes& axes) const;
    bool isOnPoint(const QPointF& place) const;
    bool movePoint(const QPointF& place);
    void dropDrag();
    QString tip(const QPointF& place) const;
    void paint(QPainter& painter, const QSizeF& size) const;
    void paintTicks(QPainter& painter, const Axes& axes, int axis) const;
    void paintName(QPainter& painter, const QRectF& box, int axis) const;
    void paintCells(QPainter& painter, const Axes& axes) const;
    void paintTarget(QPainter& painter, const Axes& axes) const;
    void paintWords(QPainter& painter, const QRectF& box) const;
    void describe();

    std::array<QString, 2> m_names;
    std::optional<ReachableMap> m_map;
    QImage m_cells; ///< one pixel for each cell of the map, top row first
    Eigen::Vector2d m_target_K{298.15, 298.15};
    bool m_stale = true;
    bool m_editable = true;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    enum class Drag { No, Held, Moved } m_drag = Drag::No;
    QPointF m_pressed;
    QPointF m_grip; ///< while dragged: from the point to the pointer
};

} // namespace bask
