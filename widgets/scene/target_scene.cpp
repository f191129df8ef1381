#include "widgets/scene/target_scene.h"

#include "engine/base/message_code.h"
#include "widgets/scene/target_picture.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <vtkRenderer.h>

#include <algorithm>
#include <stdexcept>

namespace bask {

namespace {

constexpr QSizeF kPlainSize{1000.0, 700.0}; ///< of a saved picture whose text is as large as on screen

} // namespace

struct TargetScene::Impl : TargetPicture {
    QLabel* notice = nullptr;
    bool surfacesAreNew = false; ///< in the frame that is made
};

TargetScene::TargetScene(QWidget* parent) : QWidget(parent), m(std::make_unique<Impl>()) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (VtkView::available())
        makePicture();
    else
        showNotice();
}

TargetScene::~TargetScene() {
    // The view may still paint while QWidget's destructor takes it down, when the rest is gone.
    if (m->view != nullptr) {
        m->targets.reset();
        m->props.reset();
        delete m->view;
        m->view = nullptr;
    }
}

void TargetScene::makePicture() {
    m->view = new VtkView(this);
    m->view->setAccessibleName(tr("3-D scene of the targets"));
    layout()->addWidget(m->view);
    setFocusProxy(m->view);
    m->props = std::make_unique<SceneProps>(m->view->renderer());
    m->targets = std::make_unique<TargetProps>(m->view->renderer());
    m->view->setPrepare([this] {
        m->surfacesAreNew = m->resurface;
        m->prepare(palette(), font());
    });
    m->view->setOverlay([this](QPainter& painter) {
        m->paint(painter, palette(), font());
        if (m->surfacesAreNew)
            emit surfacesDrawn();
    });
    connect(m->view, &VtkView::cameraMoved, this, [this] { m->cameraIsPersons = true; });
    connect(m->view, &VtkView::cameraResetRequested, this, [this] { turnTo(m->preset); });
    connect(m->view, &VtkView::clicked, this, &TargetScene::pick);
    connect(m->view, &VtkView::failed, this, [this] {
        m->view->setPrepare({});
        m->view->setOverlay({});
        m->view->hide();
        m->view->deleteLater();
        m->targets.reset();
        m->props.reset();
        m->view = nullptr;
        showNotice();
    });
    applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
}

void TargetScene::showNotice() {
    m->notice = new QLabel(this);
    m->notice->setAlignment(Qt::AlignCenter);
    m->notice->setWordWrap(true);
    m->notice->setMargin(24);
    m->notice->setText(tr("The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. "
                          "Everything else works."));
    layout()->addWidget(m->notice);
}

bool TargetScene::hasPicture() const {
    return m->view != nullptr;
}
QSize TargetScene::sizeHint() const {
    return {640, 480};
}
QSize TargetScene::minimumSizeHint() const {
    return {160, 120};
}

void TargetScene::requestFrame() {
    if (m->view != nullptr)
        m->view->requestFrame();
}

void TargetScene::setExperiment(const Experiment& experiment) {
    const Box before = m->frame;
    if (!m->setExperiment(experiment))
        dropPick();
    if (!m->frame.isApprox(before))
        m->cameraIsPersons = false; // the next frame fits it
    requestFrame();
}

void TargetScene::setSurfaces(std::vector<Isosurface> surfaces, const Vector6d& fixed, PoseSubset subset) {
    if (subset != m->subset) {
        m->setSubset(subset);
        m->cameraIsPersons = false; // the next frame fits it
        dropPick();
    }
    if (!m->isPickAt(fixed))
        dropPick();
    m->surfaces = std::move(surfaces);
    m->fixed = fixed;
    m->resurface = true;
    requestFrame();
}

void TargetScene::setVerdictPoint(const std::optional<SceneVerdict>& verdict) {
    m->verdict = verdict;
    m->remark = true;
    requestFrame();
}

void TargetScene::setCut(const std::optional<SceneCut>& cut) {
    if (cut) {
        const int first = m->isOverAngles() ? kThetaX : kX;
        const auto isOver = [&](int a) {
            return cut->field->axes[static_cast<std::size_t>(a)].coordinate == first + a;
        };
        if (!cut->field || cut->field->axes.size() != 3 || !isOver(0) || !isOver(1) || !isOver(2) ||
            cut->axis < first || cut->axis > first + 2 || cut->object < 0 ||
            cut->object >= static_cast<int>(m->experiment.objects.size()))
            throw std::invalid_argument("TargetScene: a cut needs an object's field over the surfaces' axes");
    }
    m->cut = cut;
    m->remark = true;
    requestFrame();
}

void TargetScene::setStale(bool stale) {
    if (stale == m->stale)
        return;
    m->stale = stale;
    m->remark = true;
    requestFrame();
}

void TargetScene::setTemperatureUnit(TemperatureUnit unit) {
    if (unit == m->unit)
        return;
    m->unit = unit;
    m->remark = true;
    requestFrame();
}

void TargetScene::clearPick() {
    dropPick();
    requestFrame();
}

void TargetScene::dropPick() {
    if (!m->picked)
        return;
    m->picked.reset();
    m->remark = true;
    emit pickDropped();
}

void TargetScene::viewAlongMinusZ() {
    turnTo(ViewPreset::AlongMinusZ);
}
void TargetScene::viewAlongX() {
    turnTo(ViewPreset::AlongX);
}
void TargetScene::viewIsometric() {
    turnTo(ViewPreset::Isometric);
}

void TargetScene::turnTo(ViewPreset preset) {
    m->preset = preset;
    if (m->view != nullptr)
        applyPreset(*m->view->renderer().GetActiveCamera(), m->preset);
    m->cameraIsPersons = false; // the next frame fits it
    requestFrame();
}

void TargetScene::pick(QPointF place) {
    const auto pose = m->poseAt(place);
    if (!pose)
        return;
    m->picked = pose;
    m->remark = true;
    requestFrame();
    emit posePicked(pose->q, m->words(*pose));
}

QImage TargetScene::image(QSize size) {
    if (m->view == nullptr || !m->view->isValid() || size.isEmpty())
        return {};
    const QRect place = m->view->geometry();
    const double ratio = m->view->devicePixelRatioF();
    const double growth = std::min(size.width() / kPlainSize.width(), size.height() / kPlainSize.height());
    m->scale = std::max(1.0, growth / ratio);
    m->view->resize((QSizeF(size) / ratio).toSize());
    if (!m->view->isVisible()) { // else it would hear of its size when it is shown again
        QResizeEvent resized(m->view->size(), place.size());
        QApplication::sendEvent(m->view, &resized);
    }
    const QImage picture = m->view->grabFramebuffer().copy(QRect({}, size));
    m->scale = 1.0;
    m->view->setGeometry(place);
    requestFrame();
    return picture;
}

Result<void> TargetScene::saveImage(const QString& path, QSize size) {
    const QImage picture = image(size);
    if (picture.isNull())
        return Error(MessageCode::FileUnwritable, path.toStdString(), {"there is no picture"});
    if (!picture.save(path, "PNG"))
        return Error(MessageCode::FileUnwritable, path.toStdString(), {"it cannot be written"});
    return {};
}

void TargetScene::changeEvent(QEvent* event) {
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
        m->rebuild = true;
        requestFrame();
        break;
    case QEvent::LanguageChange:
    case QEvent::LocaleChange:
        if (m->view != nullptr)
            m->view->setAccessibleName(tr("3-D scene of the targets"));
        if (m->notice != nullptr)
            m->notice->setText(
                tr("The 3-D scene of the targets needs OpenGL 3.2, which this display does not offer. "
                   "Everything else works."));
        requestFrame();
        break;
    default:
        break;
    }
    QWidget::changeEvent(event);
}

void TargetScene::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    requestFrame();
}

} // namespace bask
