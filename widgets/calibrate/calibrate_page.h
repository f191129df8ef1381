#pragma once
// The Calibrate page: the live picture, and beside it one tab for each calibration.

#include "engine/model/experiment.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QScrollArea;
class QTabWidget;

namespace bask {

class CameraPanel;
class LivePicture;
class RigPanel;
class SheetPanel;

/// Object names: "livePicture", "cameraChoice", "calibrateTabs", "cameraPanel", "rigPanel", "sheetPanel".
class CalibratePage : public QWidget {
    Q_OBJECT

public:
    explicit CalibratePage(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setView(const VisionView& view);
    /// Coordinates of the end-effector in R; `mayMove`: no run is armed or on.
    void setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove);
    CameraPanel* cameraPanel() const { return m_cameraPanel; }

signals:
    /// Pictures are wanted while the page is visible, with a search for this board.
    void watchWanted(bool show, const std::optional<bask::Board>& board);
    /// A camera was chosen: a device, file, folder or address; empty for the simulated one.
    void cameraWanted(const QString& name);
    void visionEdited(const bask::VisionSpec& vision);
    void sourceMeasured(const bask::VisionSpec& vision, const bask::Vector6d& pose);
    void followWanted(bool follow);
    void moveWanted(const bask::Vector6d& coordinates);
    void holdWanted();

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QScrollArea* addPanel(QWidget* panel, const char* name);
    void connectAll();
    void offerMarkers();
    void choose();
    void watch();
    void retranslate();

    Experiment m_experiment;
    std::optional<Board> m_board; ///< the board to search for
    QString m_camera;             ///< the chosen camera
    QLabel* m_choiceLabel;
    QComboBox* m_choice;
    LivePicture* m_picture;
    QTabWidget* m_tabs;
    CameraPanel* m_cameraPanel;
    RigPanel* m_rigPanel;
    SheetPanel* m_sheetPanel;
};

} // namespace bask
