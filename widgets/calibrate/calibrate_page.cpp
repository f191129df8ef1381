#include "widgets/calibrate/calibrate_page.h"

#include "engine/model/experiment_rig.h"
#include "widgets/calibrate/calibration_age.h"
#include "widgets/calibrate/camera_panel.h"
#include "widgets/calibrate/live_picture.h"
#include "widgets/calibrate/rig_panel.h"
#include "widgets/calibrate/sheet_panel.h"
#include "widgets/calibrate/thermal_board_watch.h"
#include "widgets/calibrate/thermal_panel.h"
#include "widgets/common/folding_splitter.h"
#include "widgets/common/labels.h"
#include "widgets/common/upright_scroll.h"
#include "widgets/thermal/thermal_picture_view.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QStackedWidget>
#include <QTabWidget>

#include <algorithm>

namespace bask {
namespace {

constexpr int kPanelWidth = 420, kLeastPicture = 480; // together as wide as a narrow window has room for
constexpr double kUsualDistance_m = 0.6;

// The tabs; which of them are shown depends on the camera.
constexpr int kThermalTabs = 2, kSheetTab = 4;
constexpr int kThermalItem = 1; ///< of the choice

/// From the camera to the source, as far as the experiment tells.
double distanceOf(const Experiment& experiment) {
    const auto& camera = experiment.vision.cameraPose;
    return camera ? (camera->head<3>() - experiment.source.pose.head<3>()).norm() : kUsualDistance_m;
}

double thermalDistanceOf(const Experiment& experiment) {
    const auto camera = believedThermalCamera(experiment, !experiment.rig);
    return camera && camera->X_RC ? (camera->X_RC->translation() - experiment.source.pose.head<3>()).norm()
                                  : kUsualDistance_m;
}

/// Two of one kind have one name.
bool haveSameThermalCamera(const Experiment& a, const Experiment& b) {
    const auto device = [](const Experiment& experiment) {
        return experiment.rig && experiment.rig->thermalCamera ? experiment.rig->thermalCamera->device
                                                               : std::string();
    };
    return a.rig.has_value() == b.rig.has_value() && device(a) == device(b) &&
           thermalProfile(a, !a.rig) == thermalProfile(b, !b.rig);
}

} // namespace

CalibratePage::CalibratePage(QWidget* parent)
    : QWidget(parent), m_choiceLabel(new QLabel(this)), m_choice(new QComboBox(this)),
      m_pictures(new QStackedWidget(this)), m_picture(new LivePicture),
      m_thermalPicture(new ThermalPictureView), m_boardPicture(new LivePicture),
      m_boardWatch(new ThermalBoardWatch(this)), m_tabs(new QTabWidget(this)), m_cameraPanel(new CameraPanel),
      m_rigPanel(new RigPanel), m_lensPanel(new CameraPanel), m_thermalPanel(new ThermalPanel),
      m_sheetPanel(new SheetPanel) {
    m_picture->setObjectName("livePicture");
    for (QWidget* picture : std::initializer_list<QWidget*>{m_picture, m_thermalPicture, m_boardPicture})
        m_pictures->addWidget(picture);
    m_thermalPicture->setMinimumWidth(kLeastPicture);
    m_choice->setObjectName("cameraChoice");
    m_choice->setEditable(true);
    m_choice->setInsertPolicy(QComboBox::NoInsert);
    m_choice->addItem(QString());
    m_choiceLabel->setBuddy(m_choice);
    m_tabs->setObjectName("calibrateTabs");
    m_tabs->setDocumentMode(true);
    const auto scrollFrom = [](auto* panel, QScrollArea* scroll) {
        using Panel = std::remove_pointer_t<decltype(panel)>;
        connect(panel, &Panel::attentionWanted, scroll, [scroll](QWidget* part) {
            scroll->widget()->layout()->activate(); // it may have grown
            scroll->ensureWidgetVisible(part);
        });
    };
    scrollFrom(m_cameraPanel, addPanel(m_cameraPanel, "cameraPanel"));
    scrollFrom(m_rigPanel, addPanel(m_rigPanel, "rigPanel"));
    scrollFrom(m_lensPanel, addPanel(m_lensPanel, "thermalLensPanel"));
    scrollFrom(m_thermalPanel, addPanel(m_thermalPanel, "thermalPanel"));
    addPanel(m_sheetPanel, "sheetPanel");

    auto* choice = new QHBoxLayout;
    choice->addWidget(m_choiceLabel);
    choice->addWidget(m_choice, 1);
    auto* seen = new QWidget(this);
    auto* left = new QVBoxLayout(seen);
    left->setContentsMargins(0, 0, 0, 0);
    left->setSpacing(8);
    left->addLayout(choice);
    left->addWidget(m_pictures, 1);
    auto* sides = new FoldingSplitter(this);
    sides->setHandleWidth(12);
    sides->addWidget(seen);
    sides->addWidget(m_tabs);
    sides->setStretchFactor(0, 1);
    sides->setStretchFactor(1, 0);
    sides->setSizes({1, 0}); // the panels have their least, the picture the rest
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(sides);
    connectAll();
    chooseThermal(false);
    retranslate();
}

void CalibratePage::connectAll() {
    connect(m_choice, &QComboBox::activated, this, &CalibratePage::choose);
    connect(m_choice->lineEdit(), &QLineEdit::returnPressed, this, &CalibratePage::choose);
    connect(m_cameraPanel, &CameraPanel::boardWanted, this, [this](const std::optional<Board>& board) {
        m_board = board;
        m_picture->setBoard(board);
        watch(isVisible());
    });
    connect(m_cameraPanel, &CameraPanel::heatMapChanged, m_picture, &LivePicture::setHeatMap);
    connect(m_cameraPanel, &CameraPanel::cameraChosen, this, [this](const CameraModel& camera) {
        VisionSpec vision = m_experiment.vision;
        vision.camera = camera;
        vision.camera->views.clear(); // a residual each: they are in the camera's own file
        vision.cameraDate = calibrationDate();
        emit visionEdited(vision);
    });
    connect(m_rigPanel, &RigPanel::visionEdited, this, &CalibratePage::visionEdited);
    connect(m_rigPanel, &RigPanel::sourceMeasured, this, &CalibratePage::sourceMeasured);
    connect(m_rigPanel, &RigPanel::followWanted, this, &CalibratePage::followWanted);
    connect(m_rigPanel, &RigPanel::moveWanted, this, &CalibratePage::moveWanted);
    connect(m_rigPanel, &RigPanel::holdWanted, this, &CalibratePage::holdWanted);
    connect(m_lensPanel, &CameraPanel::boardWanted, this, [this](const std::optional<Board>& board) {
        m_thermalBoard = board;
        m_boardWatch->setBoard(board);
        m_boardPicture->setBoard(board);
        m_thermalPanel->setBoardWanted(board.has_value());
        showPicture();
        watch(isVisible());
    });
    connect(m_boardWatch, &ThermalBoardWatch::looked, m_boardPicture, &LivePicture::setView);
    connect(m_boardWatch, &ThermalBoardWatch::looked, m_lensPanel, &CameraPanel::setView);
    connect(m_lensPanel, &CameraPanel::heatMapChanged, m_boardPicture, &LivePicture::setHeatMap);
    connect(m_lensPanel, &CameraPanel::cameraChosen, this, [this](const CameraModel& camera) {
        ThermalCalibration calibration = thermalCalibration(m_experiment, !m_experiment.rig);
        calibration.lens = camera;
        calibration.lens->views.clear();
        calibration.lensDate = calibrationDate();
        calibration.poseDate.clear(); // the place was found with another lens
        calibration.poseUncertainty_m.reset();
        emit thermalCalibrated(calibration);
    });
    connect(m_thermalPanel, &ThermalPanel::calibrated, this, &CalibratePage::thermalCalibrated);
    connect(m_thermalPanel, &ThermalPanel::moveWanted, this, &CalibratePage::moveWanted);
    connect(m_thermalPanel, &ThermalPanel::holdWanted, this, &CalibratePage::holdWanted);
    connect(m_sheetPanel, &SheetPanel::exported, this, &CalibratePage::exported);
    for (const CameraPanel* panel : {m_cameraPanel, m_lensPanel})
        connect(panel, &CameraPanel::exported, this, &CalibratePage::exported);
    connect(m_sheetPanel, &SheetPanel::boardMeasured, this,
            [this](const Board& board) { (m_isThermal ? m_lensPanel : m_cameraPanel)->setBoard(board); });
    connect(m_sheetPanel, &SheetPanel::markersMeasured, this,
            [this](const std::string& dictionary, const std::vector<int>& ids, double side_m) {
                VisionSpec vision = m_experiment.vision;
                if (dictionary != vision.dictionary) // not those of this rig
                    return;
                for (MarkerSpec& marker : vision.markers)
                    if (std::ranges::find(ids, marker.id) != ids.end())
                        marker.side_m = side_m;
                emit visionEdited(vision);
            });
}

QScrollArea* CalibratePage::addPanel(QWidget* panel, const char* name) {
    panel->setObjectName(QLatin1String(name));
    auto* content = new QWidget(this);
    auto* inside = new QVBoxLayout(content);
    inside->setContentsMargins(8, 10, 8, 8);
    inside->addWidget(panel);
    auto* scroll = new UprightScroll(content, this, kPanelWidth);
    m_tabs->addTab(scroll, panel->windowTitle());
    connect(panel, &QWidget::windowTitleChanged, m_tabs,
            [this, scroll](const QString& title) { m_tabs->setTabText(m_tabs->indexOf(scroll), title); });
    return scroll;
}

void CalibratePage::setExperiment(const Experiment& experiment) {
    const bool areMarkersNew = experiment.vision.markers != m_experiment.vision.markers;
    const bool isCameraNew = !haveSameThermalCamera(m_experiment, experiment);
    m_experiment = experiment;
    m_picture->setCamera(experiment.vision.camera);
    m_cameraPanel->setCamera(experiment.vision.camera);
    m_cameraPanel->setDistance(distanceOf(experiment));
    m_rigPanel->setExperiment(experiment);
    std::vector<QString> names;
    for (const ObjectSpec& object : experiment.objects)
        names.push_back(QString::fromStdString(object.name));
    m_thermalPicture->setNames(names);
    m_lensPanel->setCamera(thermalCalibration(experiment, !experiment.rig).lens);
    if (isCameraNew) {
        m_lensPanel->changeCamera();
        m_boardWatch->setBoard(m_thermalBoard); // forgets the picture that it looks at
    }
    m_lensPanel->setDistance(thermalDistanceOf(experiment));
    m_thermalPanel->setExperiment(experiment);
    offerThermalCamera();
    if (areMarkersNew)
        offerMarkers();
}

/// The rig's own markers are what is printed, unless somebody types others.
void CalibratePage::offerMarkers() {
    const VisionSpec& vision = m_experiment.vision;
    std::vector<int> ids;
    for (const MarkerSpec& marker : vision.markers)
        ids.push_back(marker.id);
    if (!ids.empty())
        m_sheetPanel->setMarkers(vision.dictionary, ids, vision.markers.front().side_m);
}

void CalibratePage::setView(const VisionView& view) {
    m_picture->setView(view);
    m_cameraPanel->setView(view);
    m_rigPanel->setView(view);
}

void CalibratePage::setThermalView(const ThermalView& view) {
    if (!m_isThermal || !isVisible())
        return;
    m_thermalPicture->setView(view);
    if (m_mayMove)
        m_boardWatch->setView(view);
    m_thermalPanel->setView(view);
}

void CalibratePage::setTemperatureUnit(TemperatureUnit unit) {
    m_thermalPicture->setTemperatureUnit(unit);
}

void CalibratePage::setRobot(const Vector6d& coordinates, bool isMoving, bool mayMove) {
    m_mayMove = mayMove;
    m_rigPanel->setRobot(coordinates, isMoving, mayMove);
    m_thermalPanel->setRobot(coordinates, isMoving, mayMove);
}

void CalibratePage::choose() {
    const QString text = m_choice->currentText().trimmed();
    const bool isThermal = m_choice->count() > kThermalItem && text == m_choice->itemText(kThermalItem);
    chooseThermal(isThermal);
    const QString name = isThermal || text == m_choice->itemText(0) ? QString() : text;
    if (name == m_camera)
        return;
    m_camera = name;
    emit cameraWanted(name);
}

void CalibratePage::offerThermalCamera() {
    const bool hasOne = thermalProfile(m_experiment, !m_experiment.rig).has_value();
    if (hasOne == (m_choice->count() > kThermalItem))
        return;
    if (hasOne) {
        m_choice->addItem(tr("Thermal camera"));
        return;
    }
    m_choice->removeItem(kThermalItem);
    if (m_isThermal) {
        m_choice->setCurrentIndex(0);
        chooseThermal(false);
    }
}

void CalibratePage::chooseThermal(bool isThermal) {
    m_isThermal = isThermal;
    if (m_tabs->currentIndex() != kSheetTab)
        m_tabs->setCurrentIndex(isThermal ? kThermalTabs : 0);
    for (int tab = 0; tab < kSheetTab; ++tab)
        m_tabs->setTabVisible(tab, (tab >= kThermalTabs) == isThermal);
    showPicture();
    watch(isVisible());
}

void CalibratePage::showPicture() {
    m_pictures->setCurrentWidget(!m_isThermal     ? static_cast<QWidget*>(m_picture)
                                 : m_thermalBoard ? static_cast<QWidget*>(m_boardPicture)
                                                  : m_thermalPicture);
}

void CalibratePage::watch(bool isVisible) {
    emit watchWanted(isVisible && !m_isThermal, m_board);
    emit thermalWatchWanted(isVisible && m_isThermal, m_thermalBoard);
}

void CalibratePage::retranslate() {
    m_choiceLabel->setText(tr("Camera"));
    m_choice->setItemText(0, tr("Simulated camera"));
    if (m_choice->count() > kThermalItem)
        m_choice->setItemText(kThermalItem, tr("Thermal camera"));
    m_choice->setToolTip(
        tr("Or type a number (0), a device (/dev/video0), a video file, a folder of pictures or "
           "an address (rtsp://\u2026), and Enter"));
    nameChoice(m_choice, tr("Camera"));
    m_tabs->setAccessibleName(tr("What is calibrated"));
    setAccessibleName(tr("Calibrate"));
}

void CalibratePage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

void CalibratePage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    watch(true);
}

void CalibratePage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    watch(false);
}

} // namespace bask
