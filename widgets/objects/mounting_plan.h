#pragma once
// Plan of the end-effector seen along its -z axis: every object where it is mounted, to scale.

#include "engine/session/experiment.h"

#include <QWidget>

namespace bask {

/// Clicking an object asks for it to be selected. Coordinates and angles are those of the mounting in E.
class MountingPlan : public QWidget {
    Q_OBJECT

public:
    explicit MountingPlan(QWidget* parent = nullptr);

    void setObjects(const std::vector<ObjectSpec>& objects, int selected);

    QSize minimumSizeHint() const override { return {180, 130}; }
    QSize sizeHint() const override { return {280, 170}; }

signals:
    void objectClicked(int index);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    QTransform map() const;
    void retranslate();

    struct Item {
        QString name;
        QPolygonF outline_mm;
    };
    std::vector<Item> m_items;
    int m_selected = -1;
};

/// Outline (mm) of an object as mounted, projected on the xy-plane of E.
QPolygonF mountedOutline_mm(const ObjectSpec& object);

} // namespace bask
