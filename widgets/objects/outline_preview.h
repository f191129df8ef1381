#pragma once
// Drawing of one object to scale: raw outline coloured by its distance from the used outline, centroid,
// principal axes, scale bar, size, colour bar and legend.

#include "engine/shape/principal_axes.h"
#include "engine/shape/shape.h"

#include <QLinearGradient>
#include <QPolygonF>
#include <QWidget>

namespace bask {

/// Draws in the plane of the object, x right, y up. Passive: it only shows the values that are set.
class OutlinePreview : public QWidget {
    Q_OBJECT

public:
    explicit OutlinePreview(QWidget* parent = nullptr);

    /// `shape` as used; `raw` as imported, empty if there is none; `color` of the object.
    void setObject(const QString& name, const Shape& shape, const Contour& raw, const QColor& color);
    /// Sets the distances (m) of points of the raw outline (m, in its own coordinates, in order) from the
    /// fit's curve; ignored unless this curve is shown.
    void setDistances(const FourierFit& fit, const std::vector<Eigen::Vector2d>& points_m,
                      const std::vector<double>& distances_m);
    void clear();

    QSize minimumSizeHint() const override { return {300, 200}; }
    QSize sizeHint() const override { return {560, 380}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    QString axesText() const;
    QLinearGradient colours(const QPointF& from, const QPointF& to) const;
    bool isColoured() const { return !m_distances_mm.empty(); }
    void paintGrid(QPainter& painter, const QTransform& map) const;
    void paintOutlines(QPainter& painter, const QTransform& map) const;
    void paintDistances(QPainter& painter, const QTransform& map) const;
    void paintAxes(QPainter& painter, const QTransform& map) const;
    void paintLegend(QPainter& painter, const QRectF& area) const;
    void paintColourBar(QPainter& painter, const QRectF& area) const;

    QString m_name;
    FourierContour m_series; ///< without harmonics if it is not a Fourier outline
    QPolygonF m_used_mm;     ///< without its holes
    std::vector<QPolygonF> m_holes_mm;
    QPolygonF m_raw_mm;                 ///< the imported points or, with distances, their points
    int m_rawPoints = 0;                ///< as imported
    std::vector<double> m_distances_mm; ///< distances of m_raw_mm; empty if not known
    double m_max_mm = 0.0;              ///< the largest of them
    PrincipalAxes m_axes;
    QColor m_color;
};

/// Returns the raw outline in the frame of a series fitted to it: the fit moves the series' centroid to the
/// origin.
Contour registered(const Contour& raw, const Shape& shape);

} // namespace bask
