#include "widgets/scene/vtk_view.h"

#include "widgets/common/scrolling.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QPainter>
#include <QTimer>
#include <QWheelEvent>

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace bask {

namespace {

constexpr int kSamples = 4; ///< of multisampling: thin lines are what the scene is made of

/// Whether the processor draws (no graphics card, remote desktop): there multisampling triples a frame's
/// time.
bool drawnByProcessor() {
    const auto* name = reinterpret_cast<const char*>(
        QOpenGLContext::currentContext()->functions()->glGetString(GL_RENDERER));
    const QByteArray renderer = QByteArray(name).toLower();
    for (const char* software :
         {"llvmpipe", "softpipe", "swrast", "software", "swiftshader", "gdi generic", "basic render"})
        if (renderer.contains(software))
            return true;
    return false;
}

QSurfaceFormat surfaceFormat() {
    QSurfaceFormat format = QSurfaceFormat::defaultFormat();
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setStencilBufferSize(8);
    format.setSamples(0); // VTK multisamples in a framebuffer of its own
    return format;
}

} // namespace

struct VtkView::Impl {
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkGenericRenderWindowInteractor> interactor;
    vtkNew<vtkInteractorStyleTrackballCamera> style;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkCallbackCommand> makeCurrent;
    vtkNew<vtkCallbackCommand> isCurrent;
    vtkNew<vtkCallbackCommand> render;
    std::function<void()> prepare;
    std::function<void(QPainter&)> overlay;
    QMetaObject::Connection contextGone;
    QTimer timer;
    QElapsedTimer sinceFrame;
    Qt::MouseButton button = Qt::NoButton;
    QPointF pressedAt;
    bool dragged = false; ///< since the press, farther than a hand trembles
    double wheelDegrees = 0.0;
    bool ready = false;
    bool broken = false;
    int frames = 0;
    double lastFrame_s = 0.0;
};

bool VtkView::available() {
    static const bool answer = [] {
        QOpenGLContext context;
        context.setFormat(surfaceFormat());
        if (!context.create())
            return false;
        QOffscreenSurface surface;
        surface.setFormat(context.format());
        surface.create();
        if (!surface.isValid() || !context.makeCurrent(&surface))
            return false;
        const bool enough = !context.isOpenGLES() && context.format().version() >= qMakePair(3, 2);
        context.doneCurrent();
        return enough;
    }();
    return answer;
}

VtkView::VtkView(QWidget* parent) : QOpenGLWidget(parent), m(std::make_unique<Impl>()) {
    setFormat(surfaceFormat());
    setFocusPolicy(Qt::StrongFocus);
    setProperty(kZoomsByWheel, true);
    m->window->SetReadyForRendering(false); // until initializeGL
    m->window->SetOwnContext(0);
    m->window->SetFrameBlitModeToNoBlit();
    m->window->SetForceMaximumHardwareLineWidth(1); // core profile: wide lines are VTK's own geometry
    m->window->AddRenderer(m->renderer);
    m->renderer->SetBackgroundAlpha(1.0);
    m->renderer->GetActiveCamera()->ParallelProjectionOn();

    m->interactor->SetRenderWindow(m->window);
    m->interactor->SetInteractorStyle(m->style);
    m->interactor->EnableRenderOff(); // it asks for frames, paintGL makes them

    m->makeCurrent->SetClientData(this);
    m->makeCurrent->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
        auto* view = static_cast<VtkView*>(self);
        // QOpenGLWidget::makeCurrent() would bind Qt's framebuffer behind VTK's back, so only when it must
        // be.
        if (view->context() != nullptr && QOpenGLContext::currentContext() != view->context())
            view->makeCurrent();
    });
    m->window->AddObserver(vtkCommand::WindowMakeCurrentEvent, m->makeCurrent);
    m->isCurrent->SetClientData(this);
    m->isCurrent->SetCallback([](vtkObject*, unsigned long, void* self, void* answer) {
        const auto* view = static_cast<VtkView*>(self);
        *static_cast<bool*>(answer) =
            view->context() != nullptr && QOpenGLContext::currentContext() == view->context();
    });
    m->window->AddObserver(vtkCommand::WindowIsCurrentEvent, m->isCurrent);
    m->render->SetClientData(this);
    m->render->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
        static_cast<VtkView*>(self)->requestFrame(kInteractionInterval_ms);
    });
    m->interactor->AddObserver(vtkCommand::RenderEvent, m->render);

    m->timer.setSingleShot(true);
    m->timer.setTimerType(Qt::PreciseTimer);
    connect(&m->timer, &QTimer::timeout, this, [this] { update(); });
}

VtkView::~VtkView() {
    disconnect(m->contextGone); // QOpenGLWidget's own destructor ends the context, when this part is gone
    releaseGL();
    m->interactor->RemoveObserver(m->render);
    m->window->RemoveObserver(m->makeCurrent);
    m->window->RemoveObserver(m->isCurrent);
}

vtkRenderer& VtkView::renderer() {
    return *m->renderer;
}
void VtkView::setPrepare(std::function<void()> prepare) {
    m->prepare = std::move(prepare);
}
void VtkView::setOverlay(std::function<void(QPainter&)> overlay) {
    m->overlay = std::move(overlay);
}
int VtkView::frames() const {
    return m->frames;
}
double VtkView::lastFrame_s() const {
    return m->lastFrame_s;
}

void VtkView::requestFrame(int interval_ms) {
    if (!isVisible()) // being shown paints
        return;
    const qint64 elapsed = m->sinceFrame.isValid() ? m->sinceFrame.elapsed() : interval_ms;
    const int wait = static_cast<int>(std::clamp<qint64>(interval_ms - elapsed, 0, interval_ms));
    if (!m->timer.isActive() || m->timer.remainingTime() > wait)
        m->timer.start(wait);
}

void VtkView::initializeGL() {
    m->contextGone = connect(
        context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { releaseGL(); }, Qt::DirectConnection);
    m->window->SetReadyForRendering(true);
    m->window->SetMapped(1);
    m->window->SetMultiSamples(drawnByProcessor() ? 0 : kSamples);
    m->window->OpenGLInit();
    m->ready = true;
    syncSize();
    if (!m->interactor->GetInitialized())
        m->interactor->Initialize();
}

void VtkView::releaseGL() {
    if (!m->ready)
        return;
    m->ready = false;
    disconnect(m->contextGone);
    makeCurrent();
    m->window->Finalize();
    m->window->SetReadyForRendering(false);
    doneCurrent();
}

void VtkView::syncSize() {
    const double ratio = devicePixelRatioF();
    const int width = std::max(1, static_cast<int>(std::lround(ratio * this->width())));
    const int height = std::max(1, static_cast<int>(std::lround(ratio * this->height())));
    m->window->SetSize(width, height);
    m->window->SetDPI(static_cast<int>(std::lround(72.0 * ratio)));
    m->interactor->SetSize(width, height);
}

void VtkView::resizeGL(int, int) {
    syncSize();
}

bool VtkView::blit() {
    vtkOpenGLFramebufferObject* rendered = m->window->GetDisplayFramebuffer();
    if (rendered == nullptr || rendered->GetFBOIndex() == 0)
        return false;
    const int* size = m->window->GetSize();
    vtkOpenGLState* state = m->window->GetState();
    state->vtkglDisable(GL_SCISSOR_TEST);
    state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    state->vtkglViewport(0, 0, size[0], size[1]);
    m->window->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                                      GL_NEAREST);
    return true;
}

void VtkView::paintGL() {
    m->timer.stop();
    QElapsedTimer timer;
    timer.start();
    if (m->prepare)
        m->prepare();
    if (m->ready && !m->broken) {
        syncSize();
        vtkOpenGLState* state = m->window->GetState();
        state->Reset(); // Qt has changed what VTK believes to know
        state->Push();
        state->vtkglDepthFunc(GL_LEQUAL);
        m->renderer->ResetCameraClippingRange();
        m->window->Render();
        state->Pop();
        if (!blit()) {
            m->broken = true;
            // Not from within a paint: the receiver will take this view away.
            QMetaObject::invokeMethod(this, &VtkView::failed, Qt::QueuedConnection);
        }
        QOpenGLContext::currentContext()->functions()->glBindFramebuffer(GL_FRAMEBUFFER,
                                                                         defaultFramebufferObject());
    }
    if (m->overlay && !m->broken) {
        QPainter painter(this);
        m->overlay(painter);
    }
    ++m->frames;
    m->lastFrame_s = static_cast<double>(timer.nsecsElapsed()) * 1e-9;
    m->sinceFrame.restart();
}

bool VtkView::event(QEvent* event) {
    if (event->type() == QEvent::Hide)
        m->timer.stop();
    return QOpenGLWidget::event(event);
}

void VtkView::showEvent(QShowEvent* event) {
    QOpenGLWidget::showEvent(event);
    update();
}

void VtkView::tellPosition(QPointF position, Qt::KeyboardModifiers modifiers) {
    const double ratio = devicePixelRatioF();
    m->interactor->SetEventInformationFlipY(static_cast<int>(std::lround(position.x() * ratio)),
                                            static_cast<int>(std::lround(position.y() * ratio)),
                                            modifiers.testFlag(Qt::ControlModifier),
                                            modifiers.testFlag(Qt::ShiftModifier));
}

void VtkView::mousePressEvent(QMouseEvent* event) {
    if (m->button != Qt::NoButton || !m->ready)
        return;
    tellPosition(event->position(), event->modifiers());
    switch (event->button()) {
    case Qt::LeftButton:
        m->interactor->LeftButtonPressEvent();
        break;
    case Qt::MiddleButton:
        m->interactor->MiddleButtonPressEvent();
        break;
    case Qt::RightButton:
        m->interactor->RightButtonPressEvent();
        break;
    default:
        event->ignore();
        return;
    }
    m->button = event->button();
    m->pressedAt = event->position();
    m->dragged = false;
}

void VtkView::mouseMoveEvent(QMouseEvent* event) {
    if (m->button == Qt::NoButton || !m->ready)
        return;
    tellPosition(event->position(), event->modifiers());
    m->dragged |= (event->position() - m->pressedAt).manhattanLength() >= QApplication::startDragDistance();
    m->interactor->MouseMoveEvent();
    emit cameraMoved();
}

void VtkView::releaseButton() {
    switch (m->button) {
    case Qt::LeftButton:
        m->interactor->LeftButtonReleaseEvent();
        break;
    case Qt::MiddleButton:
        m->interactor->MiddleButtonReleaseEvent();
        break;
    case Qt::RightButton:
        m->interactor->RightButtonReleaseEvent();
        break;
    default:
        break;
    }
    m->button = Qt::NoButton;
}

void VtkView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != m->button)
        return;
    tellPosition(event->position(), event->modifiers());
    const bool click = m->button == Qt::LeftButton && !m->dragged;
    releaseButton();
    if (click)
        emit clicked(event->position());
}

void VtkView::focusOutEvent(QFocusEvent* event) {
    releaseButton(); // else the camera would stick to the mouse after a dialog
    QOpenGLWidget::focusOutEvent(event);
}

void VtkView::wheelEvent(QWheelEvent* event) {
    if (!m->ready)
        return;
    m->wheelDegrees += event->angleDelta().y() / 8.0;
    const int notches = static_cast<int>(m->wheelDegrees / 15.0);
    m->wheelDegrees -= 15.0 * notches;
    tellPosition(event->position(), event->modifiers());
    for (int i = 0; i < std::abs(notches); ++i)
        if (notches > 0)
            m->interactor->MouseWheelForwardEvent();
        else
            m->interactor->MouseWheelBackwardEvent();
    if (notches != 0)
        emit cameraMoved();
    event->accept();
}

void VtkView::keyPressEvent(QKeyEvent* event) {
    // VTK's own key bindings (e: exit, w: wireframe, 3: stereo) are of no use to an operator, so keys end
    // here.
    vtkCamera* camera = m->renderer->GetActiveCamera();
    switch (event->key()) {
    case Qt::Key_Left:
        camera->Azimuth(5.0);
        break;
    case Qt::Key_Right:
        camera->Azimuth(-5.0);
        break;
    case Qt::Key_Up:
        camera->Elevation(-5.0);
        break;
    case Qt::Key_Down:
        camera->Elevation(5.0);
        break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        camera->SetParallelScale(camera->GetParallelScale() / 1.1);
        break;
    case Qt::Key_Minus:
        camera->SetParallelScale(camera->GetParallelScale() * 1.1);
        break;
    case Qt::Key_Home:
        emit cameraResetRequested();
        return;
    default:
        QOpenGLWidget::keyPressEvent(event);
        return;
    }
    camera->OrthogonalizeViewUp();
    emit cameraMoved();
    requestFrame(kInteractionInterval_ms);
}

} // namespace bask
