#include "widgets/calibrate/calibrate_page.h"

#include "widgets/calibrate/camera_panel.h"
#include "widgets/calibrate/live_picture.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QTabWidget>

namespace bask {
namespace {

constexpr int kPanelWidth = 400;

} // namespace

CalibratePage::CalibratePage(QWidget* parent)
    : QWidget(parent), m_picture(new LivePicture(this)), m_tabs(new QTabWidget(this)),
      m_cameraPanel(new CameraPanel(this)) {
    m_picture->setObjectName("livePicture");
    m_tabs->setObjectName("calibrateTabs");
    m_cameraPanel->setObjectName("cameraPanel");
    m_tabs->setDocumentMode(true);
    m_tabs->setFixedWidth(kPanelWidth);
    QScrollArea* scroll = addPanel(m_cameraPanel);
    connect(m_cameraPanel, &CameraPanel::attentionWanted, scroll, [scroll](QWidget* part) {
        scroll->widget()->layout()->activate(); // it may have grown
        scroll->ensureWidgetVisible(part);
    });
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->setSpacing(12);
    layout->addWidget(m_picture, 1);
    layout->addWidget(m_tabs);
    connect(m_cameraPanel, &CameraPanel::boardWanted, m_picture, &LivePicture::setBoard);
    connect(m_cameraPanel, &CameraPanel::boardWanted, this, &CalibratePage::boardWanted);
    connect(m_cameraPanel, &CameraPanel::heatMapChanged, m_picture, &LivePicture::setHeatMap);
    connect(m_cameraPanel, &CameraPanel::cameraChosen, this, &CalibratePage::cameraChosen);
    retranslate();
}

QScrollArea* CalibratePage::addPanel(QWidget* panel) {
    auto* content = new QWidget(this);
    auto* inside = new QVBoxLayout(content);
    inside->setContentsMargins(8, 10, 8, 8);
    inside->addWidget(panel);
    auto* scroll = new QScrollArea(this);
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    m_tabs->addTab(scroll, panel->windowTitle());
    connect(panel, &QWidget::windowTitleChanged, m_tabs,
            [this, scroll](const QString& title) { m_tabs->setTabText(m_tabs->indexOf(scroll), title); });
    return scroll;
}

void CalibratePage::setView(const VisionView& view) {
    m_picture->setView(view);
    m_cameraPanel->setView(view);
}

void CalibratePage::setDistance(double distance_m) {
    m_cameraPanel->setDistance(distance_m);
}

void CalibratePage::setCamera(const std::optional<CameraModel>& camera) {
    m_picture->setCamera(camera);
    m_cameraPanel->setCamera(camera);
}

void CalibratePage::retranslate() {
    m_tabs->setAccessibleName(tr("What is calibrated"));
    setAccessibleName(tr("Calibrate"));
}

void CalibratePage::changeEvent(QEvent* event) {
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QWidget::changeEvent(event);
}

} // namespace bask
