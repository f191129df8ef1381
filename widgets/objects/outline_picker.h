#pragma once
// The outlines of a file, over their picture where there is one: the operator clicks the one meant.

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

/// Draws in pixels of the picture (pixel centres at whole numbers), without one in mm, y up. The wheel zooms
/// about the pointer, a double click shows all again. Values in, clicks out.
class OutlinePicker : public QWidget {
    Q_OBJECT

public:
    /// What a click does.
    enum class Tool {
        Pick,    ///< the smallest outline under the pointer that is no hole
        Measure, ///< first one end of the ruler, then the other
        Colour,  ///< the colour under the pointer
    };

    explicit OutlinePicker(QWidget* parent = nullptr);

    void clear();
    void setPicture(const QImage& picture);
    void setOutlines(const OutlineFile& file);
    void setSelected(int index); ///< -1: none
    void setTool(Tool tool);
    Tool tool() const { return m_tool; }
    /// A line on the picture whose ends can be dragged; it begins across the largest outline.
    void setRulerShown(bool shown);

    QSize minimumSizeHint() const override { return {320, 240}; }
    QSize sizeHint() const override { return {640, 520}; }

signals:
    void outlineClicked(int index);
    void rulerMoved(const QLineF& ruler_px); ///< it was laid, or an end was let go or set by a click
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
    int m_dragged = -1; ///< end of the ruler
    bool m_secondEnd = false;
    double m_zoom = 1.0;
    QPointF m_pan; ///< px of the widget, of the fitted view's centre
};

} // namespace bask
