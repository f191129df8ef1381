#pragma once
// The outlines of a file, over their picture if there is one: the operator clicks the wanted one.

#include "engine/shape/outline_file.h"

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QPolygonF>
#include <QTransform>
#include <QWidget>

#include <optional>
#include <vector>

namespace bask {

/// Draws in pixels of the picture (pixel centres at whole numbers), without a picture in mm with y up. The
/// wheel zooms about the pointer, a double click shows everything. Passive: takes values, sends clicks.
class OutlinePicker : public QWidget {
    Q_OBJECT

public:
    /// What a click does.
    enum class Tool {
        Pick,    ///< selects the smallest outline under the pointer that is not a hole
        Measure, ///< sets one end of the ruler, then the other
        Colour,  ///< takes the colour under the pointer
    };

    explicit OutlinePicker(QWidget* parent = nullptr);

    void clear();
    void setPicture(const QImage& picture);
    void setOutlines(const OutlineFile& file);
    void setSelected(int index); ///< -1: none
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// Shows a line with draggable ends on the picture; it starts across the largest outline.
    void setRulerShown(bool shown);

    QSize minimumSizeHint() const override { return {320, 240}; }
    QSize sizeHint() const override { return {640, 520}; }

signals:
    void outlineClicked(int index);
    void rulerMoved(const QLineF& ruler_px); ///< it was placed, or an end was released or set by a click
    void measured();                         ///< both ends were set by clicks
    void colourPicked(const QColor& colour);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    struct Ring {
        QPolygonF points;
        QRectF box;
        bool closed = true;
        bool hole = false;
        std::optional<std::size_t> holeIn;
    };
    QRectF content() const;
    QTransform map() const;
    int ringAt(const QPointF& place) const;
    QColor colourAt(const QPointF& place) const;
    void layRuler();
    int rulerEndAt(const QPointF& position) const;
    void click(const QPointF& position);
    void setRulerEnd(int end, const QPointF& place);
    void paintRings(QPainter& painter, const QTransform& map) const;
    void paintRuler(QPainter& painter, const QTransform& map) const;
    void retranslate();

    QImage m_picture;
    std::vector<Ring> m_rings;
    int m_selected = -1;
    Tool m_tool = Tool::Pick;
    bool m_rulerShown = false;
    std::optional<QLineF> m_ruler_px;
    int m_dragged = -1; ///< dragged end of the ruler
    bool m_secondEnd = false;
    double m_zoom = 1.0;
    QPointF m_pan; ///< offset of the fitted view's centre, widget px
};

} // namespace bask
