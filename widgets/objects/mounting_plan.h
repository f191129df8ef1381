#pragma once
// A view of the end-effector: every object at its mounting, to scale, moved, turned and tilted by mouse or
// keys.

#include "engine/model/experiment.h"

#include <QPainterPath>
#include <QRectF>
#include <QWidget>

#include <optional>
#include <set>

namespace bask {

/// Returns the side of the grid's squares, a round length (1, 2, 5 x 10^k mm) of at least 18 pixels.
double gridStep_mm(double pixelsPerMm);

/// Where the end-effector is seen from.
enum class MountingView {
    Top,   ///< along -z: x to the right, y up
    Front, ///< along +y: x to the right, z up
    Side   ///< along -x: y to the right, z up
};

/// Coordinates and angles are those of the mounting in E, and a drag changes those that it is about and no
/// other: from the top, dragging an object moves it in x and y and dragging its handle turns it about z; from
/// the front and the side, dragging changes its height, and the handle that of the two tilts whose axis is
/// nearer to the line of sight. In steps of 5 mm and 5 degrees, with Alt of 0.1. Arrow keys move the selected
/// one by 1 mm (Shift: 1 cm), Page Up and Page Down turn or tilt it by 5 degrees (Shift: 1). Escape ends a
/// drag without a change.
class MountingPlan : public QWidget {
    Q_OBJECT

public:
    explicit MountingPlan(QWidget* parent = nullptr);

    void setView(MountingView view);
    MountingView view() const { return m_view; }
    /// `remarked`: objects with a remark; they are hatched. `reach_m`: radius within which the robot carries
    /// objects, 0 for none.
    void setObjects(const std::vector<ObjectSpec>& objects, int selected, const std::set<int>& remarked = {},
                    double reach_m = 0.0);
    /// Changes only which objects have a remark; a drag goes on.
    void setRemarked(const std::set<int>& remarked);
    /// Shows an object where another view drags it; what is in view stays.
    void showDragged(int index, const Vector6d& mounting);
    void setReadOnly(bool readOnly);

    /// Scale (pixels per mm) at which all objects are in view, and an upper limit of the scale used.
    double fittedScale() const;
    void setMaxScale(double scale);

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override { return {300, 300}; }

    /// Where an object's centre and the handle of the selected one are drawn, in pixels.
    QPointF objectPosition(int index) const;
    QPointF handlePosition() const { return handle(map()); }

signals:
    void objectClicked(int index);
    /// During a drag, and with the mounting before it when Escape ends it.
    void objectDragged(int index, const bask::Vector6d& mounting);
    /// A drag has ended or a key is pressed: the new mounting.
    void objectMoved(int index, const bask::Vector6d& mounting);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    struct Drag {
        QPointF grip_mm;    ///< from the object's centre to the point of the grip
        Vector6d before;    ///< mounting when the drag began
        bool turns = false; ///< turned by the handle
        bool moved = false;
    };
    /// What the handle changes: a coordinate, and the sense in which it grows.
    struct Turn {
        Coordinate coordinate;
        double clockwise; ///< 1 or -1
    };
    bool isFromTop() const { return m_view == MountingView::Top; }
    Coordinate right() const { return m_view == MountingView::Side ? kY : kX; }
    Coordinate up() const { return isFromTop() ? kY : kZ; }
    QPointF centre_mm(const Vector6d& mounting) const;
    QPainterPath projected_mm(const ObjectSpec& object) const;
    QPointF handleDirection(const Vector6d& mounting) const; ///< of length 1, y up
    Turn turnOf(const Vector6d& mounting) const;
    Vector6d dragged(const QPointF& at_mm, bool fine) const;
    QTransform map() const;
    QRectF canvas() const; ///< for the objects, without margins
    void endDrag();
    QPointF handle(const QTransform& map) const; ///< of the selected object
    bool onHandle(const QTransform& map, const QPointF& at) const;
    bool holds(const QTransform& map, int index, const QPointF& at) const;
    int objectAt(const QTransform& map, const QPointF& at) const; ///< -1 if there is none
    double footHeight() const;
    QString readout() const; ///< where the dragged object is
    bool canMove() const { return m_selected >= 0 && !m_readOnly; }
    const ObjectSpec& selected() const { return m_objects[static_cast<std::size_t>(m_selected)]; }
    ObjectSpec& selected() { return m_objects[static_cast<std::size_t>(m_selected)]; }
    void paintObjects(QPainter& painter, const QTransform& map) const;
    void paintGround(QPainter& painter, const QTransform& map) const;
    void paintFacing(QPainter& painter, const QTransform& map) const;
    void paintNames(QPainter& painter, const QTransform& map) const;
    void paintHandle(QPainter& painter, const QTransform& map) const;
    void paintFoot(QPainter& painter, const QTransform& map) const;
    void retranslate();

    MountingView m_view = MountingView::Top;
    std::vector<ObjectSpec> m_objects; ///< as they are shown, one of them dragged
    std::set<int> m_remarked;
    int m_selected = -1;
    double m_reach_m = 0.0;
    double m_maxScale = 0.0; ///< 0: none
    bool m_readOnly = false;
    QRectF m_content_mm;
    std::optional<Drag> m_drag;
};

} // namespace bask
