#pragma once
// What the camera sees, with what was found in it drawn over it.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <optional>

namespace bask {

/// The frame's pixels are drawn from where they are, never copied. A camera that does not answer is said over
/// its last picture, which is dimmed and hatched.
class LivePicture : public QWidget {
    Q_OBJECT

public:
    explicit LivePicture(QWidget* parent = nullptr);

    void setView(const VisionView& view);
    /// By which axes are drawn; none without.
    void setCamera(const std::optional<CameraModel>& camera);
    /// That is looked for: its rows get their colours.
    void setBoard(const std::optional<Board>& board);
    /// Drawn over the picture.
    void setHeatMap(const std::optional<HeatMap>& map);

    QString sentence() const;   ///< over the picture; empty while the camera answers
    QString statusText() const; ///< below it: size, rate, latency, age

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
    void paintSentence(QPainter& painter, const QRectF& place) const;

    VisionView m_view;
    double m_age_s = 0.0; ///< of the picture, when the view came
    std::optional<CameraModel> m_camera;
    std::optional<Board> m_board;
    std::optional<HeatMap> m_heatMap;
};

} // namespace bask
