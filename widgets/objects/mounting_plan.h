#pragma once
// Plan of the end-effector seen along its -z axis: every object at its mounting, to scale, dragged and turned
// by mouse or keys.

#include "engine/model/experiment.h"

#include <QWidget>

#include <optional>
#include <set>

namespace bask {

/// Returns the side of the grid's squares, a round length (1, 2, 5 x 10^k mm) of at least 18 pixels.
double gridStep_mm(double pixelsPerMm);

/// Coordinates and angles are those of the mounting in E. Dragging an object moves it in steps of 5 mm, with
/// Alt of 0.1 mm; dragging its handle turns it in steps of 5 degrees, with Alt of 0.1; arrow keys move the
/// selected one by 1 mm (Shift: 1 cm), Page Up and Page Down turn it by 5 degrees (Shift: 1). During a drag
/// only the plan shows the change; Escape ends it without a change.
class MountingPlan : public QWidget {
    Q_OBJECT

public:
    explicit MountingPlan(QWidget* parent = nullptr);

    /// `remarked`: objects with a remark; they are hatched. `reach_m`: radius within which the robot carries
    /// objects, 0 for none.
    void setObjects(const std::vector<ObjectSpec>& objects, int selected, const std::set<int>& remarked = {},
                    double reach_m = 0.0);
    /// Changes only which objects have a remark; a drag goes on.
    void setRemarked(const std::set<int>& remarked);
    void setReadOnly(bool readOnly);

    QSize minimumSizeHint() const override { return {180, 160}; }
    QSize sizeHint() const override { return {300, 300}; }
    /// As high as wide, within limits: a wider column gives a larger plan.
    int heightForWidth(int width) const override;

    /// Where an object's centre and the handle of the selected one are drawn, in pixels.
    QPointF objectPosition(int index) const;
    QPointF handlePosition() const { return handle(map()); }

signals:
    void objectClicked(int index);
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
        QTransform map;     ///< map when the drag began
        QPointF grip_mm;    ///< from the object's centre to the point of the grip
        Vector6d mounting;  ///< current mounting
        bool turns = false; ///< turned by the handle
        bool moved = false;
    };
    QTransform map() const;
    QPointF handle(const QTransform& map) const; ///< of the selected object
    bool onHandle(const QTransform& map, const QPointF& at) const;
    int objectAt(const QTransform& map, const QPointF& at) const; ///< -1 if there is none
    double footHeight() const;
    bool canMove() const { return m_selected >= 0 && !m_readOnly; }
    const ObjectSpec& selected() const { return m_objects[static_cast<std::size_t>(m_selected)]; }
    void paintObjects(QPainter& painter, const QTransform& map) const;
    void paintGround(QPainter& painter, const QTransform& map) const;
    void paintNames(QPainter& painter, const QTransform& map) const;
    void paintHandle(QPainter& painter, const QTransform& map) const;
    void paintFoot(QPainter& painter, const QTransform& map) const;
    void paintReadout(QPainter& painter) const;
    void retranslate();

    std::vector<ObjectSpec> m_objects;
    std::set<int> m_remarked;
    int m_selected = -1;
    double m_reach_m = 0.0;
    bool m_readOnly = false;
    std::optional<Drag> m_drag;
};

} // namespace bask
