#pragma once
// The Calibrate page: the picture of the chosen camera, and beside it one tab for each of its calibrations.

#include "engine/base/units.h"
#include "engine/model/experiment.h"
#include "engine/thermography/thermal_view.h"
#include "engine/vision/vision_view.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QScrollArea;
class QStackedWidget;
class QTabWidget;

namespace bask {

class CameraPanel;
class LivePicture;
class RigPanel;
class SheetPanel;
class ThermalBoardWatch;
class ThermalPanel;
class ThermalPictureView;

/// A rig's thermal camera is one of those that can be chosen: its lens is calibrated as any lens is, its
/// place by the objects' outlines. Object names: "livePicture", "cameraChoice", "calibrateTabs",
/// "cameraPanel", "rigPanel", "sheetPanel"; "thermalPictureView", "thermalLensPanel", "thermalPanel".
class CalibratePage : public QWidget {
    Q_OBJECT

public:
    explicit CalibratePage(QWidget* parent = nullptr);

    void setExperiment(const Experiment& experiment);
    void setView(const VisionView& view);
    void setThermalView(const ThermalView& view);
    void setTemperatureUnit(TemperatureUnit unit);
    /// Coordinates of the end-effector in R; `mayMove`: no run is armed or on.
    void setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove);
    CameraPanel* cameraPanel() const { return m_cameraPanel; }

signals:
    /// Pictures are wanted while the page is visible, with a search for this board.
    void watchWanted(bool show, const std::optional<bask::Board>& board);
    /// A camera was chosen: a device, file, folder or address; empty for the simulated one.
    void cameraWanted(const QString& name);
    /// The same of the thermal camera.
    void thermalWatchWanted(bool show, const std::optional<bask::Board>& board);
    void visionEdited(const bask::VisionSpec& vision);
    void thermalCalibrated(const bask::ThermalCalibration& calibration);
    void sourceMeasured(const bask::VisionSpec& vision, const bask::Vector6d& pose);
    void followWanted(bool follow);
    void moveWanted(const bask::Vector6d& coordinates);
    void holdWanted();
    /// Files were written.
    void exported(const QString& sentence, const QStringList& files);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QScrollArea* addPanel(QWidget* panel, const char* name);
    void connectAll();
    void offerMarkers();
    void choose();
    void offerThermalCamera();
    void chooseThermal(bool isThermal);
    void showPicture();
    void watch(bool isVisible);
    void retranslate();

    Experiment m_experiment;
    std::optional<Board> m_board;        ///< the board to search for
    QString m_camera;                    ///< the chosen camera
    bool m_isThermal = false;            ///< the thermal camera is chosen instead
    bool m_mayMove = false;              ///< as setRobot() told
    std::optional<Board> m_thermalBoard; ///< as m_board, of the thermal camera
    QLabel* m_choiceLabel;
    QComboBox* m_choice;
    QStackedWidget* m_pictures;
    LivePicture* m_picture;
    ThermalPictureView* m_thermalPicture;
    LivePicture* m_boardPicture; ///< of the thermal camera, while a board is looked for
    ThermalBoardWatch* m_boardWatch;
    QTabWidget* m_tabs;
    CameraPanel* m_cameraPanel;
    RigPanel* m_rigPanel;
    CameraPanel* m_lensPanel; ///< of the thermal camera
    ThermalPanel* m_thermalPanel;
    SheetPanel* m_sheetPanel;
};

} // namespace bask
