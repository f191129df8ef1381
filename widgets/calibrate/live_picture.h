#pragma once
// The camera's picture, with what was found in it drawn over it.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <optional>

namespace bask {

/// The frame's pixels are drawn without copying. If the camera does not answer, this is shown over its last
/// picture, which is dimmed and hatched.
class LivePicture : public QWidget {
    Q_OBJECT

public:
    explicit LivePicture(QWidget* parent = nullptr);

    void setView(const VisionView& view);
    /// Sets the camera for drawing axes; without it no axes are drawn.
    void setCamera(const std::optional<CameraModel>& camera);
    /// Sets the board that is searched for: its rows get their colours.
    void setBoard(const std::optional<Board>& board);
    /// Sets the heat map that is drawn over the picture.
    void setHeatMap(const std::optional<HeatMap>& map);

    QString sentence() const;   ///< text over the picture; empty while the camera answers
    QString statusText() const; ///< text below the picture: size, rate, latency, age

    QSize sizeHint() const override { return {800, 480}; }
    QSize minimumSizeHint() const override { return {320, 200}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    QString foundText() const;
    QRectF pictureRect() const;
    void paintFound(QPainter& painter, const QRectF& place) const;

    VisionView m_view;
    double m_age_s = 0.0; ///< age of the picture when the view arrived
    std::optional<CameraModel> m_camera;
    std::optional<Board> m_board;
    std::optional<HeatMap> m_heatMap;
};

} // namespace bask
