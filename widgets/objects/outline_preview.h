#pragma once
// To-scale drawing of one object: raw outline under the outline that is used, centroid, scale bar, size and
// legend.

#include "engine/shape/shape.h"

#include <QPolygonF>
#include <QWidget>

namespace bask {

/// Draws in the plane of the object, x right, y up. Passive: values in, picture out.
class OutlinePreview : public QWidget {
    Q_OBJECT

public:
    explicit OutlinePreview(QWidget* parent = nullptr);

    /// `shape` as used; `raw` as imported, empty if there is none; `color` of the object.
    void setObject(const QString& name, const Shape& shape, const Contour& raw, const QColor& color);
    void clear();

    QSize minimumSizeHint() const override { return {300, 200}; }
    QSize sizeHint() const override { return {560, 380}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void paintGrid(QPainter& painter, const QTransform& map) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;

    QString m_name;
    QPolygonF m_used_mm;
    QPolygonF m_raw_mm;
    QColor m_color;
    int m_harmonics = 0; ///< 0: not a Fourier outline
};

/// The raw outline in the frame of a series fitted to it: the fit moves the series' centroid to the origin.
Contour registered(const Contour& raw, const Shape& shape);

} // namespace bask
