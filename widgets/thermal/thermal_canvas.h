#pragma once
// A thermal picture in colours with its colour bar, the objects' outlines and temperatures, and a spot.

#include "engine/base/units.h"
#include "engine/thermography/thermal_view.h"
#include "widgets/common/label_layout.h"
#include "widgets/thermal/thermal_colours.h"

#include <QPixmap>
#include <QTransform>
#include <QWidget>

#include <optional>
#include <vector>

class QHelpEvent;

namespace bask {

/// The spot is the pixel under the mouse. A click or an arrow key pins it, arrow keys move it, Escape or a
/// click on it removes it.
class ThermalCanvas : public QWidget {
    Q_OBJECT
public:
    explicit ThermalCanvas(QWidget* parent = nullptr);

    /// The picture is taken from the view without copying.
    void setView(const ThermalView& view);
    void setNames(const std::vector<QString>& names);
    void setTemperatureUnit(TemperatureUnit unit);
    void setLook(const ThermalLook& look);
    /// Draws the picture smoothly, or pixel by pixel, each as large as the others.
    void setSmooth(bool smooth);
    /// Shows the part of the picture with the objects, or all of it.
    void setZoomed(bool zoomed);
    /// Sets the object whose outline is drawn thicker.
    void setChosen(std::optional<std::size_t> object);
    /// Dims the picture, without what is measured in it, under a sentence; an empty one removes that.
    void setNotice(const QString& sentence, bool isProblem);

    /// Returns the pixel that is pinned, else the one under the mouse.
    std::optional<QPoint> spot() const { return m_pinned ? m_pinned : m_hovered; }
    bool isPinned() const { return m_pinned.has_value(); }
    /// Returns the spot's apparent temperature, its place and its object's name.
    QString spotText() const;
    /// Returns "saturated 12" and so on for pixels that tell no temperature, each beside its colour (rich
    /// text).
    QString legend() const;

    const QRect& shownPixels() const { return m_pixels; } ///< the part of the picture that is drawn
    QRectF pictureRect() const;                           ///< where it is drawn
    QRectF pixelRect(QPoint pixel) const;                 ///< where one of its pixels is drawn
    const std::vector<QRectF>& labelRects() const { return m_labels; } ///< those that were drawn last

    /// Returns the width with which the picture fills this height.
    int widthFor(int height) const;
    QSize sizeHint() const override { return {480, 320}; }
    QSize minimumSizeHint() const override { return {180, 110}; }

protected:
    bool event(QEvent* event) override;
    void changeEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    struct BarLabel {
        double T_K = 0.0;
        QString text;
    };
    const ThermalImage& prepared() const;
    void choosePixels();
    QSizeF shownSize(const QSizeF& room) const;
    std::vector<BarLabel> barLabels(double height) const;
    double barWidth() const; ///< with its gap and its labels
    QRectF barRect() const;
    QTransform fromPixels() const; ///< pixels (centres at whole numbers) to where they are drawn
    QPolygonF outlineOf(std::size_t object) const; ///< closed, pixels
    QString nameOf(std::size_t object) const;
    QString labelOf(std::size_t object, bool isShort) const;
    QString pixelText(QPoint pixel) const; ///< "41.3 °C"
    std::optional<std::size_t> objectAt(QPoint pixel) const;
    std::optional<QPoint> pixelAt(QPointF position) const;
    void hover(std::optional<QPoint> pixel);
    void pin(std::optional<QPoint> pixel);
    void describe();
    bool showToolTip(const QHelpEvent& event);
    QString spotLabel(QPoint pixel) const;
    QRectF spotBox(QPoint pixel) const; ///< of its label

    void paintPicture(QPainter& painter);
    void paintOutlines(QPainter& painter);
    void paintLabels(QPainter& painter);
    void paintSpot(QPainter& painter, QPoint pixel, bool isPinned);
    void paintBar(QPainter& painter);

    ThermalView m_view;
    std::vector<QString> m_names;
    TemperatureUnit m_unit = TemperatureUnit::Celsius;
    ThermalLook m_look;
    bool m_isSmooth = true, m_isZoomed = false;
    QRect m_pixels; ///< those that are drawn
    std::optional<std::size_t> m_chosen;
    QString m_notice;
    bool m_isProblem = false;
    std::optional<QPoint> m_pinned, m_hovered;

    mutable std::optional<ThermalImage> m_image; ///< of m_view with m_look, made when it is needed
    QPixmap m_scaled;                            ///< of m_image; null if that has changed
    LabelLayout m_layout;
    std::vector<QRectF> m_labels;
};

} // namespace bask
