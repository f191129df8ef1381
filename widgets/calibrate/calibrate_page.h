#pragma once
// The Calibrate page: the live picture, and beside it what can be calibrated, a tab each.

#include "engine/calibration/view_collector.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <optional>

class QScrollArea;
class QTabWidget;

namespace bask {

class CameraPanel;
class LivePicture;

/// Object names: "livePicture", "calibrateTabs", "cameraPanel".
class CalibratePage : public QWidget {
    Q_OBJECT

public:
    explicit CalibratePage(QWidget* parent = nullptr);

    /// Another tab, named by the panel's window title (also when that changes).
    QScrollArea* addPanel(QWidget* panel);

    void setView(const VisionView& view);
    void setDistance(double distance_m); ///< from the camera to the source
    void setCamera(const std::optional<CameraModel>& camera);
    CameraPanel* cameraPanel() const { return m_cameraPanel; }

signals:
    void boardWanted(const std::optional<bask::Board>& board);
    void cameraChosen(const bask::CameraModel& camera);

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    LivePicture* m_picture;
    QTabWidget* m_tabs;
    CameraPanel* m_cameraPanel;
};

} // namespace bask
